// Error measures, on differences that were put there.
#include "pipeline/study/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "pipeline/study/analysis.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

class ErrorRowsTest : public testing::Test {
protected:
    ErrorRowsTest() {
        scene = test::pyramid();
        scene.settings.width = 160, scene.settings.height = 120;
        scene.camera.pixelsPerUnit = 1;
        render();
    }
    void render() {
        frame = test::frameOf(scene, errorsNeed());
        ours = pictureOf(*frame);
        white = whiteOf(scene);
        seen = double(std::ranges::count_if(ours.object.pixels, [](std::int32_t id) { return id >= 0; }));
    }
    double value(const Picture& reference, std::string_view buffer, std::string_view measure,
                 ErrorKind kind = ErrorKind::Model) const {
        for (const ErrorRow& row : compare(*frame, ours, {&reference, nullptr}))
            if (row.buffer == buffer && row.measure == measure && row.value[index(kind)])
                return *row.value[index(kind)];
        return std::nan("");
    }
    Scene scene;
    FramePtr frame;
    Picture ours;
    double white = 0, seen = 0;
};

TEST_F(ErrorRowsTest, EqualPicturesHaveNoErrorAndNoPsnr) {
    ASSERT_GT(seen, 1000);
    for (const ErrorRow& row : compare(*frame, ours, {&ours, nullptr})) {
        const auto& model = row.value[index(ErrorKind::Model)];
        EXPECT_FALSE(row.measure == "PSNR" && model);
        if (model) {
            EXPECT_EQ(*model, row.measure == "mean SSIM" ? 1 : 0) << row.buffer << " " << row.measure;
        }
    }
}

// What a study can be asked for before it runs: every error that is found is known, and every known one is found in one
// of these scenes.
TEST(KnownErrors, AreThoseThatComparingFinds) {
    std::vector<ErrorChoice> found, known;
    std::set<std::string> buffers;
    for (const bool isGouraud : {false, true}) {
        Scene scene = test::boxOverGround();
        scene.settings.width = 40, scene.settings.height = 30;
        scene.settings.shading = isGouraud ? Shading::Gouraud : Shading::Phong;
        scene.settings.depthFormat = DepthFormat::Fixed16;
        scene.settings.antialiasing = isGouraud ? 1 : 2;
        scene.settings.rules.reset();
        const BufferSet all = errorsNeed() | setOf({BufferId::Antialiased, BufferId::VerticesNormal});
        const FramePtr frame = test::frameOf(scene, all);
        scene.settings.precision = Precision::Double;
        const FramePtr wider = test::frameOf(scene, all);
        const Picture reference = pictureOf(*wider);
        for (const ErrorRow& row : compare(*frame, pictureOf(*frame), {&reference, wider.get()}))
            for (std::size_t kind = 0; kind < kErrorKinds; ++kind)
                if (row.value[kind] && isError(row.measure)) {
                    found.push_back({row.buffer, row.measure, ErrorKind(kind)});
                    buffers.insert(row.buffer);
                }
    }
    for (const std::string& buffer : buffers)
        for (const ErrorChoice& one : knownErrors(*findBuffer(buffer))) known.push_back(one);
    for (const ErrorChoice& one : found)
        EXPECT_NE(std::ranges::find(known, one), known.end())
            << one.buffer << ':' << one.measure << ':' << name(one.kind);
    for (const ErrorChoice& one : known)
        EXPECT_NE(std::ranges::find(found, one), found.end())
            << one.buffer << ':' << one.measure << ':' << name(one.kind);
    // Those of errors.h's list.
    EXPECT_EQ(buffers, (std::set<std::string>{"object_id", "z_view", "polygon_id", "depth", "vertices.screen",
                                              "polygons.verdict", "polygons.normal", "vertices.normal", "normal",
                                              "shadow_buffer.0", "shadow.0", "intensity", "antialiased", "color"}));
}

TEST_F(ErrorRowsTest, CoverageTellsFalseFromMissingAndFromOther) {
    Picture reference = ours;
    int falsely = 0, missing = 0, other = 0;
    for (std::size_t i = 0; i < reference.object.pixels.size(); ++i) {
        std::int32_t& id = reference.object.pixels[i];
        if (id < 0 && missing < 5)
            id = 0, ++missing;
        else if (id == 0 && falsely < 3)
            id = -1, ++falsely;
        else if (id == 0 && other < 2)
            id = 7, ++other;
    }
    EXPECT_EQ(value(reference, "object_id", "pixels that differ"), 10);
    EXPECT_EQ(value(reference, "object_id", "missing"), 5);
    EXPECT_EQ(value(reference, "object_id", "falsely drawn"), 3);
    EXPECT_EQ(value(reference, "object_id", "another object"), 2);
}

// Half a unit everywhere; one pixel in which both see something else does not count.
TEST_F(ErrorRowsTest, DepthsAreComparedWhereBothSeeTheSame) {
    Picture reference = ours;
    for (double& z : reference.zView.pixels) z += 0.5;
    const auto first = std::ranges::find(reference.object.pixels, 0) - reference.object.pixels.begin();
    reference.object.pixels[std::size_t(first)] = -1;
    reference.zView.pixels[std::size_t(first)] = 1e6;
    EXPECT_NEAR(value(reference, "z_view", "RMSE"), 0.5, 1e-12);
    EXPECT_NEAR(value(reference, "z_view", "largest"), 0.5, 1e-12);
    const double nearest = std::ranges::min(reference.zView.pixels);
    EXPECT_LE(value(reference, "z_view", "largest relative"), 0.5 / nearest);
}

// No pixel shows the same object, none at all is seen: neither is an error of 0.
TEST_F(ErrorRowsTest, WhereNothingIsComparedThereIsNoRow) {
    Picture reference = ours;
    std::ranges::fill(reference.object.pixels, -1);
    EXPECT_EQ(value(reference, "object_id", "falsely drawn"), seen);
    for (const char* buffer : {"z_view", "intensity", "normal", "shadow.0"})
        for (const ErrorRow& row : compare(*frame, ours, {&reference, nullptr}))
            EXPECT_FALSE(row.buffer == buffer && row.value[index(ErrorKind::Model)]) << buffer << ' ' << row.measure;
    EXPECT_FALSE(showsAnything(reference));
    EXPECT_TRUE(showsAnything(ours));
}

// The same polygons in another order: no pixel shows another object, each shows another polygon, and is left out.
TEST_F(ErrorRowsTest, AnotherPolygonOfTheSameObjectIsCounted) {
    Scene turned = scene;
    turned.objects[0].mesh =
        test::mesh(scene.objects[0].mesh->positions, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}});
    const FramePtr other = test::frameOf(turned, errorsNeed());
    double polygons = -1, objects = -1;
    for (const ErrorRow& row : compare(*frame, ours, {nullptr, other.get()})) {
        const auto& arithmetic = row.value[index(ErrorKind::Arithmetic)];
        if (row.buffer == "polygon_id") polygons = arithmetic.value();
        if (row.buffer == "object_id" && row.measure == "pixels that differ") objects = arithmetic.value();
        EXPECT_FALSE(row.buffer == "intensity" && arithmetic) << row.measure;
    }
    EXPECT_EQ(polygons, seen);
    EXPECT_EQ(objects, 0);
}

TEST_F(ErrorRowsTest, NormalsByTheirAngle) {
    Picture reference = ours;
    const double turn = 1e-7;  // degrees: acos of the dot product would read 0
    for (Vec3d& n : reference.normal.pixels) {
        if (n == Vec3d(0)) continue;
        const Vec3d across = glm::normalize(glm::cross(n, Vec3d(0.3, 0.5, 0.8)));
        n = std::cos(turn * std::acos(-1.0) / 180) * n + std::sin(turn * std::acos(-1.0) / 180) * across;
    }
    EXPECT_NEAR(value(reference, "normal", "mean angle"), turn, 1e-9 * turn + 1e-14);
    EXPECT_NEAR(value(reference, "normal", "largest angle"), turn, 1e-6 * turn);
}

TEST_F(ErrorRowsTest, ShadowsByWhatIsFalselyDarkAndWhatLeaks) {
    Picture reference = ours;
    int dark = 0, lit = 0;
    for (std::size_t i = 0; i < reference.object.pixels.size(); ++i) {
        double& s = reference.shadow[0].pixels[i];
        if (reference.object.pixels[i] != 0 || s != 1) continue;
        if (dark < 4)
            s = 0, ++dark;  // ours is lit there: a leak
        else if (lit < 6)
            s = 1.5, ++lit;  // ours is darker by a half
    }
    EXPECT_NEAR(value(reference, "shadow.0", "leak"), 4 / seen, 1e-15);
    EXPECT_NEAR(value(reference, "shadow.0", "false shadow"), 3 / seen, 1e-15);
    EXPECT_NEAR(value(reference, "shadow.0", "misclassified"), 7 / seen, 1e-15);
}

// A tenth of white in one of three colours: RMSE 0.1 / sqrt 3.
TEST_F(ErrorRowsTest, IntensitiesInSharesOfWhite) {
    Picture reference = ours;
    for (Vec3d& intensity : reference.intensity.pixels) intensity.x += 0.1 * white;
    EXPECT_NEAR(value(reference, "intensity", "RMSE"), 0.1 / std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(value(reference, "intensity", "largest"), 0.1, 1e-12);
    EXPECT_NEAR(value(reference, "intensity", "99 %"), 0.1, 1e-12);
    const Buffer2D<Vec3d> error = signedError(ours, reference, white);
    const auto at = std::size_t(std::ranges::find(ours.object.pixels, 0) - ours.object.pixels.begin());
    EXPECT_NEAR(error.pixels[at].x, -0.1, 1e-12);
    EXPECT_EQ(error.pixels[at].y, 0);
}

// All that is seen two steps darker: PSNR 20 log10(255 / (2 sqrt(seen / all))).
TEST_F(ErrorRowsTest, ColoursInSteps) {
    Picture reference = ours;
    for (std::size_t i = 0; i < reference.object.pixels.size(); ++i)
        if (reference.object.pixels[i] == 0) reference.intensity.pixels[i] -= Vec3d(2 * white / 255);
    EXPECT_EQ(value(reference, "color", "pixels that differ"), seen);
    EXPECT_EQ(value(reference, "color", "largest step"), 2);
    EXPECT_NEAR(value(reference, "color", "PSNR"), 20 * std::log10(255 / (2 * std::sqrt(seen / (160 * 120)))), 1e-9);
    EXPECT_LT(value(reference, "color", "mean SSIM"), 1);
    EXPECT_GT(value(reference, "color", "mean SSIM"), 0.9);
    // Rounding to a step: half of one at most, a twelfth of its square on average where intensities vary.
    EXPECT_LE(value(reference, "color", "largest step", ErrorKind::Storage), 0.5 + 1e-4);
    EXPECT_GT(value(reference, "color", "largest step", ErrorKind::Storage), 0.05);
}

TEST_F(ErrorRowsTest, StoredDepthsAreWithinHalfAStep) {
    for (const DepthFormat format : {DepthFormat::Fixed16, DepthFormat::Fixed24, DepthFormat::Fixed32,
                                     DepthFormat::Float, DepthFormat::Reversed}) {
        scene.settings.precision = Precision::Double;
        scene.settings.depthFormat = format;
        for (const ProjectionKind projection : {ProjectionKind::Perspective, ProjectionKind::Orthographic}) {
            scene.camera.projection = projection;
            render();
            const double steps = value(ours, "depth", "largest in steps", ErrorKind::Storage);
            // z_view and what is computed from it are rounded to 53 bits: 2^-52 is a millionth of a step of 32 bits.
            EXPECT_LE(steps, 0.5 + 1e-4) << int(format);
            EXPECT_GT(steps, 0.4) << int(format);
            EXPECT_GT(value(ours, "depth", "RMSE", ErrorKind::Storage), 0) << int(format);
        }
    }
}

// Float has 29 bits less than double: its errors against 128 bits are as much larger.
TEST_F(ErrorRowsTest, ArithmeticErrorsAreThoseOfThePrecision) {
    scene.settings.shading = Shading::Phong;
    scene.settings.precision = Precision::Quad;
    const FramePtr quad = test::frameOf(scene, errorsNeed());
    const auto measure = [&](Precision precision, std::string_view buffer, std::string_view what) {
        scene.settings.precision = precision;
        const FramePtr f = test::frameOf(scene, errorsNeed());
        for (const ErrorRow& row : compare(*f, pictureOf(*f), {nullptr, quad.get()}))
            if (row.buffer == buffer && row.measure == what) return row.value[index(ErrorKind::Arithmetic)].value();
        return std::nan("");
    };
    using enum Precision;
    EXPECT_EQ(measure(Float, "polygons.verdict", "polygons that differ"), 0);
    const std::pair<const char*, const char*> rows[]{{"vertices.screen", "largest"},
                                                     {"z_view", "RMSE"},
                                                     {"intensity", "RMSE"},
                                                     {"polygons.normal", "largest angle"}};
    for (const auto& [buffer, what] : rows) {
        const double inFloat = measure(Float, buffer, what), inDouble = measure(Double, buffer, what);
        EXPECT_GT(inFloat, 0) << buffer;
        EXPECT_LT(inFloat, 1e-3) << buffer;
        EXPECT_LT(inDouble, inFloat * 0x1p-20) << buffer;
    }
    EXPECT_EQ(measure(Double, "normal", "not of unit length"), 0);
}

// Four values: their mean 2.5, the mean of their squares 7.5; 99 % do not exceed the fourth.
TEST(ErrorSpread, OfFourValues) {
    const ErrorSpread spread = spreadOf({4, 1, 3, 2});
    EXPECT_EQ(spread.mean, 2.5);
    EXPECT_EQ(spread.rmse, std::sqrt(7.5));
    EXPECT_EQ(spread.p99, 4);
    EXPECT_EQ(spread.largest, 4);
    EXPECT_EQ(spreadOf({}).largest, 0);
    EXPECT_EQ(spreadOf({1e300, 1e300}).rmse, 1e300);  // whose square is no double
}

}  // namespace
}  // namespace pipeline
