// The forms of one formula: what each of them errs by, and where the naive ones fail.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "pipeline/core/numerics.h"
#include "pipeline/plan/scene_remarks.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/stages/rasterize.h"
#include "pipeline/stages/transform.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// The largest error of a form of (a·b)^n over angles up to 90 degrees, for vectors that are known exactly: a along z, b
// on the unit circle. Reference: the cosine of what float made of b, in long double.
double powerError(PowerForm form, double exponent) {
    double worst = 0;
    const double widest = std::min(1.0, 6 / std::sqrt(exponent));
    for (int i = 0; i <= 4000; ++i) {
        const float x = float(widest * i / 4000);
        const Vec3<float> a{0, 0, 1}, b{x, 0, std::sqrt(1 - x * x)};
        const long double cosine = std::sqrt(1 - (long double)x * (long double)x);
        const long double exact = std::pow(cosine, (long double)exponent);
        worst = std::max(worst, double(std::abs(powerOfCosine(a, b, float(exponent), form) - exact)));
    }
    return worst;
}

// Schlick's t / (n - n t + t) is farthest from t^n where 1 - t = u / n with 1 / (1 + u) - exp(-u) largest: 0.204 at
// u = 2.51 for large n, a little less at 32. The Gaussian exp(n (t - 1)) = exp(-u) differs from (1 - u/n)^n by
// u² exp(-u) / (2 n), at most 2 exp(-2) / n = 8.5e-3 at 32.
TEST(Forms, ApproximationsOfThePowerErrAsTheirFormulasSay) {
    EXPECT_NEAR(powerError(PowerForm::Schlick, 32), 0.2, 0.008);
    EXPECT_NEAR(powerError(PowerForm::Gaussian, 32), 2 * std::exp(-2.0) / 32, 3e-4);
    EXPECT_LT(powerError(PowerForm::Log1p, 32), 2e-7);
    EXPECT_LT(powerError(PowerForm::Pow, 32), 2e-6);
    EXPECT_LT(powerError(PowerForm::Squaring, 32), 3e-6);
    EXPECT_LT(powerError(PowerForm::Exp2, 32), 3e-6);
}

// a·b is a float near 1, known to 2^-25: at exponent 10^6 that is a factor exp(0.03), and of several roundings more.
TEST(Forms, OnlyTheStablePowerHoldsAtAMillion) {
    EXPECT_LT(powerError(PowerForm::Log1p, 1e6), 2e-6);
    for (const PowerForm form : {PowerForm::Pow, PowerForm::Squaring, PowerForm::Exp2, PowerForm::Gaussian})
        EXPECT_GT(powerError(form, 1e6), 5e-3) << int(form);
}

TEST(Forms, EveryPowerIsOneAtItsCentreAndNoneBehind) {
    for (int form = 0; form < 6; ++form)
        for (const double exponent : {0.0, 1.0, 7.5, 1e6}) {
            const Vec3d a{0, 0, 1};
            EXPECT_EQ(powerOfCosine(a, a, exponent, PowerForm(form)), 1) << form << ' ' << exponent;
            EXPECT_EQ(powerOfCosine(a, -a, exponent, PowerForm(form)), 0) << form << ' ' << exponent;
            // A dot product that rounding left above 1.
            const double above = powerOfCosine(a, Vec3d(0, 0, 1.001), exponent, PowerForm(form));
            EXPECT_LE(above, kLargestPower) << form << ' ' << exponent;
            EXPECT_GE(above, 0.0) << form << ' ' << exponent;
        }
    EXPECT_EQ(powerOfCosine(Vec3d(0, 0, 1), Vec3d(0, 0, 0.5), 10.0, PowerForm::Squaring), 0x1p-10);
}

double lengthError(UnitForm form) {
    double worst = 0;
    for (int i = 1; i <= 4000; ++i) {
        const Vec3d v(0.001 * i, 1, 0.3), n = normalized(v, form);
        const Vec3<float> f = normalized(Vec3<float>(v), form);
        worst = std::max(worst, std::abs(glm::length(n) - 1));
        worst = std::max(worst, std::abs(glm::length(Vec3d(f)) - 1));
    }
    return worst;
}
// C. Lomont's table: 3.4375e-2 without a step of Newton's, 1.7512e-3 with one; a step takes e to 3/2 e².
TEST(Forms, GuessesOfTheInverseRootErrAsPublished) {
    EXPECT_NEAR(lengthError(UnitForm::Estimate), 0.0343, 0.001);
    EXPECT_NEAR(lengthError(UnitForm::Newton), 0.00175, 0.0001);
    EXPECT_NEAR(lengthError(UnitForm::Newton2), 1.5 * 0.00175 * 0.00175, 1e-6);
    EXPECT_LT(lengthError(UnitForm::Scaled), 2e-7);
    EXPECT_LT(lengthError(UnitForm::Direct), 2e-7);
}
// (10^20)² does not fit into float, (10^-30)² is 0: the direct form says that there is no direction.
TEST(Forms, TheDirectRootFailsWhereSquaresDoAndTheOthersHold) {
    for (const float scale : {1e20f, 1e-30f})
        for (int form = 0; form < 5; ++form) {
            const Vec3<float> n = normalized(Vec3<float>(3 * scale, 0, 4 * scale), UnitForm(form));
            if (UnitForm(form) == UnitForm::Direct)
                EXPECT_EQ(n, Vec3<float>(0)) << scale;
            else
                EXPECT_NEAR(n.z, 0.8f, 0.03f) << form << ' ' << scale;
            EXPECT_EQ(normalized(Vec3<float>(0), UnitForm(form)), Vec3<float>(0)) << form;
            const float none = std::numeric_limits<float>::quiet_NaN();
            for (const Vec3<float> v : {Vec3<float>(none, 1, 1), Vec3<float>(1, none, 1), Vec3<float>(1, 1, none)})
                EXPECT_EQ(normalized(v, UnitForm(form)), Vec3<float>(0)) << form;
        }
}

Vec3d firstNormal(const Scene& scene, BufferId id = BufferId::PolygonsNormal) {
    const AnyBuffer b = *test::frameOf(scene, setOf({id}))->buffer({id});
    return {b.value(0, 0, 0), b.value(0, 0, 1), b.value(0, 0, 2)};
}
Scene sceneOf(std::shared_ptr<const Mesh> mesh) {
    Scene scene;
    scene.settings.shading = Shading::Phong;
    scene.objects = {{"mesh", std::move(mesh), {}, {}}};
    return scene;
}

// A square of side 1 in the plane z = 10^5, at x = y = 10^5: floats there are 2^-7 apart, and the cross products of
// their coordinates, 10^10, 2^10 apart. The square's own area vector is (0, 0, 2).
TEST(Forms, ANormalFromTheOriginIsLostFarFromIt) {
    const double o = 1e5;
    Scene scene = sceneOf(test::mesh({{o, o, o}, {o + 1, o, o}, {o + 1, o + 1, o}, {o, o + 1, o}}, {{0, 1, 2, 3}}));
    EXPECT_EQ(firstNormal(scene), Vec3d(0, 0, 1));
    scene.settings.forms.polygonNormal = PolygonNormalForm::FromOrigin;
    EXPECT_GT(angleBetween(firstNormal(scene), Vec3d(0, 0, 1)), 0.1);
    scene.settings.precision = Precision::Double;
    EXPECT_LT(angleBetween(firstNormal(scene), Vec3d(0, 0, 1)), 1e-5);
}

// An arrow head whose second corner is its concave one: there its outline turns the other way.
TEST(Forms, ThreeCornersMisleadWhereTheyAreConcave) {
    Scene scene = sceneOf(test::mesh({{0, 2, 0}, {0, 1, 0}, {1, 0, 0}, {0, 4, 0}, {-1, 0, 0}}, {{4, 1, 2, 3}}));
    EXPECT_EQ(firstNormal(scene), Vec3d(0, 0, 1));
    scene.settings.forms.polygonNormal = PolygonNormalForm::ThreeCorners;
    EXPECT_EQ(firstNormal(scene), Vec3d(0, 0, -1));
}

// Scaled by (1, 1, 0), normals stand along z. The determinant is 0: the inverse has no number.
TEST(Forms, TheInverseTransposeFailsForAFlattenedObject) {
    Mesh mesh = *test::mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}, {{0, 1, 2}});
    mesh.normals = std::vector<Vec3d>(3, glm::normalize(Vec3d(1, 0, 1)));
    Scene scene = sceneOf(makeMesh(std::move(mesh)));
    scene.settings.normalWeight = NormalWeight::Given;
    const auto normal = [&](NormalMatrixForm form, Vec3d scale) {
        scene.settings.forms.normalMatrix = form;
        scene.objects[0].transform.scale = scale;
        return firstNormal(scene, BufferId::VerticesNormal);
    };
    EXPECT_EQ(normal(NormalMatrixForm::Cofactors, {1, 1, 0}), Vec3d(0, 0, 1));
    // Its place is taken by the mean of the polygons', which is the flattened one's as well.
    EXPECT_EQ(normal(NormalMatrixForm::InverseTranspose, {1, 1, 0}), Vec3d(0, 0, 1));
    const pipeline::ObjectMatrix flat = makeObjectMatrix(ObjectTransform{{1, 1, 0}, {}, {}});
    EXPECT_FALSE(std::isfinite(normalMatrix(flat, NormalMatrixForm::InverseTranspose)[2].z));
    // Elsewhere both are the inverse transpose: diag(1, 2, 4)^-1 (1, 0, 1) ~ (4, 0, 1).
    for (const auto form : {NormalMatrixForm::Cofactors, NormalMatrixForm::InverseTranspose})
        for (const double side : {1.0, -1.0})
            EXPECT_LT(angleBetween(normal(form, {side, 2, 4}), Vec3d(4 * side, 0, 1)), 1e-6) << side;
}

TEST(Forms, AxesByCrossProductsVanishWhereTheCameraLooksAlongZ) {
    Scene scene = test::pyramid();
    const auto covered = [&](double phi, CameraBasisForm form) {
        scene.camera.phi = phi;
        scene.settings.forms.cameraBasis = form;
        const FramePtr frame = test::frameOf(scene);
        EXPECT_EQ(test::buffersWithoutNumbers(*frame), "");
        const AnyBuffer ids = *frame->buffer({BufferId::PolygonId});
        int count = 0;
        for (std::size_t i = 0; i < ids.count(); ++i) count += ids.flat(i) >= 0;
        return count;
    };
    EXPECT_GT(covered(0, CameraBasisForm::Angles), 1000);
    EXPECT_TRUE(sceneRemarks(scene).empty());
    EXPECT_EQ(covered(0, CameraBasisForm::CrossProduct), 0);
    ASSERT_EQ(sceneRemarks(scene).size(), 1u);
    EXPECT_EQ(sceneRemarks(scene)[0].about, "numerics.camera_basis");
    EXPECT_EQ(covered(60, CameraBasisForm::Angles), covered(60, CameraBasisForm::CrossProduct));
    EXPECT_TRUE(sceneRemarks(scene).empty());
}

// cos 10^-5 is 1 - 5·10^-11, a float 1.
TEST(Forms, AcosOfACosineReadsNoSmallAngle) {
    const Vec3<float> a{0, 0, 1}, b{1e-5f, 0, 1};
    EXPECT_EQ(angleBetween(a, b, CornerAngleForm::Acos), 0);
    EXPECT_NEAR(angleBetween(a, b, CornerAngleForm::Atan2), 1e-5f, 1e-11f);
    EXPECT_NEAR(angleBetween(a, Vec3<float>(0, 1, 0), CornerAngleForm::Acos), 1.5707963f, 1e-6f);
    EXPECT_EQ(angleBetween(a, Vec3<float>(0, 0, -1.0001f), CornerAngleForm::Acos), float(std::acos(-1.0)));
}

TEST(SubPixels, CornersAreOffByHalfAStepAtMost) {
    for (const int bits : {1, 4, 8, 16})
        for (int i = -500; i < 500; ++i) {
            const glm::dvec2 p(i * 0.7193, i * 1.3711);
            const glm::i64vec2 units = snap(p, bits);
            EXPECT_LE(std::abs(double(units.x) / kSubPixels - p.x), std::exp2(-bits - 1)) << bits;
            EXPECT_LE(std::abs(double(units.y) / kSubPixels - p.y), std::exp2(-bits - 1)) << bits;
            EXPECT_EQ(units.x % (kSubPixels >> bits), 0) << bits;
        }
}

// A closed sphere from outside: whatever the grid, every ray meets its front once, so that front faces alone neither
// overlap nor leave a hole.
TEST(SubPixels, NoGridTearsASurface) {
    Scene scene;
    scene.objects = {{"sphere", test::sphere(2, 12, 24), {}, {}}};
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {7, 3, 2};
    scene.settings.width = 150, scene.settings.height = 120;
    for (const int bits : {1, 2, 4, 8, 12, 16}) {
        scene.settings.subPixelBits = bits;
        const AnyBuffer overdraw = *test::frameOf(scene)->buffer({BufferId::Overdraw});
        const std::size_t width = 150;
        int holes = 0, twice = 0;
        for (std::size_t y = 0; y < 120; ++y) {
            std::size_t first = width, last = 0;
            for (std::size_t x = 0; x < width; ++x)
                if (overdraw.value(x, y) > 0) first = std::min(first, x), last = x;
            for (std::size_t x = first; x <= last && first < width; ++x)
                holes += overdraw.value(x, y) == 0, twice += overdraw.value(x, y) > 1;
        }
        EXPECT_EQ(holes, 0) << bits;
        EXPECT_EQ(twice, 0) << bits;
    }
}

}  // namespace
}  // namespace pipeline
