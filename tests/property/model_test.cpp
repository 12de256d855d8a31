// Every illumination model by its row: what the row says is what the pipeline does. One model is known to no table: it is
// tried by a row alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/export/buffers/gl_calls.h"
#include "pipeline/illumination/model_table.h"
#include "pipeline/inspect/equation_terms.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/simd/model_kernels.h"
#include "pipeline/steps/algorithm.h"
#include "pipeline/study/ray_caster.h"
#include "pipeline/study/ray_light.h"
#include "tests/support/scenes.h"
#include "tests/support/sweep.h"

namespace pipeline {
namespace {

// M. Oren and S. Nayar, "Generalization of Lambert's reflectance model", SIGGRAPH 1994, the qualitative model with
// σ = 0.5: k_d (N·L) (A + B max(0, cos φ) sin α tan β), A = 1 − 0.5 σ²/(σ² + 0.33), B = 0.45 σ²/(σ² + 0.09). With
// cosines, cos φ sin α tan β = (L·V − (N·L)(N·V)) / max(N·L, N·V).
constexpr double kA = 1 - 0.5 * 0.25 / (0.25 + 0.33), kB = 0.45 * 0.25 / (0.25 + 0.09);

constexpr Term leafOf(Quantity quantity, double number = 0) { return {Term::Kind::Leaf, quantity, number, {}}; }
using enum Quantity;
constexpr Term kAmbientParts[]{leafOf(Ambient), leafOf(AmbientLight)};
constexpr Term kBase[]{{Term::Kind::Product, Number, 0, kAmbientParts}};
constexpr Term kShadowed[]{leafOf(Shadow), leafOf(Intensity)};
constexpr Term kDiffuse[]{leafOf(Diffuse), leafOf(NDotL), leafOf(Factor, 0)};
constexpr Term kCosines[]{leafOf(NDotL), leafOf(NDotV)};
constexpr Term kExcess[]{leafOf(LDotV), {Term::Kind::Product, Number, 0, kCosines}};
constexpr Term kClamped[]{leafOf(Number, 0), {Term::Kind::Difference, Number, 0, kExcess}};
constexpr Term kFraction[]{{Term::Kind::Largest, Number, 0, kClamped}, {Term::Kind::Largest, Number, 0, kCosines}};
constexpr Term kSlope[]{leafOf(Number, kB), {Term::Kind::Fraction, Number, 0, kFraction}};
constexpr Term kRough[]{leafOf(Number, kA), {Term::Kind::Product, Number, 0, kSlope}};
constexpr ModelFactor kFactors[]{{"O", "how rough surfaces turn light back", {Term::Kind::Sum, Number, 0, kRough}}};
constexpr ModelFacts kOrenNayar = completed({.word = "oren-nayar",
                                             .label = "Oren–Nayar",
                                             .name = "Oren–Nayar's model",
                                             .base = kBase,
                                             .light = {{}, {}, kShadowed, kDiffuse, {}},
                                             .factors = kFactors,
                                             .choosesLobe = {"Oren–Nayar's model has no highlight."},
                                             .exponentFactor = {"Oren–Nayar's model has no exponent."}});

template <class Real>
void addOrenNayar(const LitSurface<Real>& in, LightSample<Real>& s) {
    if (!(s.nDotL > 0)) return;
    const Real nDotV = std::max(Real(0), glm::dot(in.at.N, in.at.V));
    const Real excess = std::max(Real(0), glm::dot(s.L, in.at.V) - s.nDotL * nDotV);
    s.factors[0] = Real(kA) + Real(kB) * excess / std::max(s.nDotL, nDotV);
    s.diffuse =
        Vec3<Real>(in.light.intensity * in.light.color) * Vec3<Real>(in.material.diffuse) * s.nDotL * s.factors[0];
}
constexpr LightTermsOf kOrenNayarTerms{addOrenNayar<float>, addOrenNayar<double>, addOrenNayar<long double>,
                                       addOrenNayar<Quad>};

class EveryModel : public testing::Test {
protected:
    EveryModel() { triedModel = &kOrenNayar, triedTerms = &kOrenNayarTerms; }
    ~EveryModel() override { triedModel = nullptr, triedTerms = nullptr; }

    // Those of the table and the one that is tried, in scenes of all kinds.
    template <class Claim>
    void forScenes(int count, Claim claim) {
        for (int i = 0; i <= int(kModelCount); ++i)
            for (int seed = 0; seed < count; ++seed) {
                Scene scene = test::smallScene(unsigned(seed) * 7 + unsigned(i));
                scene.settings.model = Model(i);
                SCOPED_TRACE(testing::Message() << modelFacts(Model(i)).name << ", seed " << seed * 7 + i);
                claim(std::move(scene));
                if (HasFatalFailure()) return;
            }
    }
};

// Looking at a buffer never changes a picture, and neither does leaving out.
TEST_F(EveryModel, IsTheSamePictureWhateverIsLookedAtOrLeftOut) {
    forScenes(12, [](Scene scene) {
        const FramePtr plain = test::frameOf(scene, setOf({BufferId::Color, BufferId::Intensity}));
        const FramePtr all = test::frameOf(scene);
        scene.settings.leaveOut = false;
        const FramePtr none = test::frameOf(scene);
        const BufferSet shown = setOf({BufferId::Color, BufferId::Intensity});
        EXPECT_EQ(test::firstDifference(*plain, *all, shown), "");
        EXPECT_EQ(test::firstDifference(*plain, *none, shown), "");
    });
}

TEST_F(EveryModel, ReusesWhatAFreshFrameComputes) {
    forScenes(8, [](Scene scene) {
        FramePtr before = test::frameOf(scene, setOf({BufferId::Color}));
        std::mt19937 random(17);
        for (int change = 0; change < 4; ++change) {
            const Model model = scene.settings.model;
            test::changeSomething(scene, random);
            scene.settings.model = model;
            if (!checkScene(scene).empty() && model != kTriedModel) return;
            const FramePtr reused = test::frameOf(scene, setOf({BufferId::Color}), 0, before);
            EXPECT_EQ(test::firstDifference(*reused, *test::frameOf(scene, setOf({BufferId::Color})),
                                            setOf({BufferId::Color})),
                      "");
            before = reused;
        }
    });
}

// Float differs from double by rounding. It is measured away from edges of polygons, shadows and cones, where rounding
// decides: at nine of ten pixels that see the same triangle the frame buffers differ by at most 1.
TEST_F(EveryModel, IsTheSameInFloatAndDouble) {
    int compared = 0;
    forScenes(12, [&](Scene scene) {
        scene.settings.forms = {}, scene.settings.depthFormat = DepthFormat::Linear;
        scene.settings.precision = Precision::Float;
        const FramePtr single = test::frameOf(scene);
        scene.settings.precision = Precision::Double;
        const FramePtr twice = test::frameOf(scene);
        const AnyBuffer a = *single->buffer({BufferId::Color}), b = *twice->buffer({BufferId::Color});
        int far = 0, all = 0;
        for (std::size_t i = 0; i < a.count(); ++i) {
            if (b.flat(i) == 0 && a.flat(i) == 0) continue;
            ++all;
            far += std::abs(a.flat(i) - b.flat(i)) > 1;
        }
        EXPECT_LE(far, all / 10);
        compared += all;
    });
    EXPECT_GT(compared, 20000);
}

// The tree that the equation is written from comes to what the frame holds: n, k and I as typed, dot products and factors
// as reported.
TEST_F(EveryModel, HasAnEquationWhoseNumbersGiveItsPicture) {
    int compared = 0;
    forScenes(16, [&](Scene scene) {
        scene.settings.precision = Precision::Double, scene.settings.forms = {};
        scene.settings.visibility = Visibility::ZBuffer, scene.settings.shading = Shading::Phong;
        for (Object& object : scene.objects) object.material.alpha = 1;
        const FramePtr frame = test::frameOf(scene);
        for (int y = 1; y < scene.settings.height; y += 4)
            for (int x = 1; x < scene.settings.width; x += 4) {
                const PixelReport report = inspectPixel(*frame, {x, y});
                if (!report.covered) continue;
                for (int c = 0; c < 3; ++c) {
                    const EquationTerms terms{scene, report, c, {}};
                    ASSERT_NEAR(terms.valueOf(report.evaluations[0]), report.intensity[c],
                                1e-9 * std::max(1.0, std::abs(report.intensity[c])))
                        << x << ", " << y << ", " << c;
                    const std::vector<EquationLine> lines = equation(scene, report, c);
                    ASSERT_FALSE(lines.empty());
                    EXPECT_EQ(toText(lines[0].formula).find("NaN"), std::string::npos);
                }
                for (const LightReport& light : report.evaluations[0].lights) {
                    if (!(light.nDotL > 0)) continue;
                    const EquationTerms terms{scene, report, 0, {}};
                    for (std::size_t i = 0; i < terms.model().factors.size(); ++i)
                        ASSERT_NEAR(terms.valueOf(terms.model().factors[i].definition, report.evaluations[0], &light),
                                    light.factors[i], 1e-6 * std::max(1.0, light.factors[i]))
                            << terms.model().factors[i].letter;
                }
                ++compared;
            }
    });
    EXPECT_GT(compared, 500);
}

// Each list keyed by model has an entry or a reason, and what has neither kernel nor rays is not drawn or judged by
// another model's.
TEST_F(EveryModel, HasAnEntryOrAReasonOnEveryFloor) {
    for (int i = 0; i <= int(kModelCount); ++i) {
        const Model model = Model(i);
        const ModelFacts& facts = modelFacts(model);
        SCOPED_TRACE(facts.name);
        EXPECT_FALSE(facts.word.empty() || facts.label.empty() || facts.name.empty());
        EXPECT_FALSE(facts.base.empty());
        EXPECT_FALSE(facts.light.diffuse.empty() && facts.light.specular.empty());
        EXPECT_LE(facts.factors.size(), kMostFactors);
        for (const Fact& fact : {facts.choosesLobe, facts.exponentFactor, facts.shadows})
            EXPECT_TRUE(fact.whyNot.empty() || fact.whyNot.ends_with('.')) << fact.whyNot;
        Scene scene = test::spheres();
        scene.settings.model = model;
        const std::string noKernel = whyNoKernel(model), noRays = rays::whyNoRayModel(model);
        if (model == kTriedModel) {
            EXPECT_NE(noKernel, "");
            EXPECT_NE(noRays, "");
        }
        EXPECT_EQ(whyNoRays(scene, RaySurfaces::Polygons).empty(), noRays.empty());
        bool told = noKernel.empty();
        const FramePtr frame = test::frameOf(scene, setOf({BufferId::Color}));
        for (const PlanPart& part : frame->plan()[index(StageId::Shading)].parts)
            told = told || (part.name == "pixels in vectors" && part.why == noKernel);
        EXPECT_TRUE(told) << noKernel;
        EXPECT_TRUE(!glRefuses(scene).empty() || facts.found.glLights);
    }
}

// A study refuses a model for which rays have no formula, and is right where they have one: in Phong shading what
// they compute at a pixel's point and normal is the frame's intensity. V is found of the pixel in one and of the point in
// the other, which snapping at 16 bits sets 2^-16 pixels apart: some 1e-6 of an angle, times n of a highlight's slope.
TEST_F(EveryModel, IsWhatRaysSee) {
    int compared = 0;
    forScenes(12, [&](Scene scene) {
        scene.settings.precision = Precision::Double, scene.settings.forms = {};
        scene.settings.visibility = Visibility::ZBuffer, scene.settings.shading = Shading::Phong;
        scene.settings.interpolation = Interpolation::Perspective;
        scene.settings.subPixelBits = 16;
        for (Object& object : scene.objects)
            object.material.alpha = 1, object.material.exponent = std::min(object.material.exponent, 30.0);
        if (!rays::whyNoRayModel(scene.settings.model).empty()) return;
        const auto lighting = rays::makeLighting<double>(scene);
        const FramePtr frame = test::frameOf(scene);
        for (int y = 2; y < scene.settings.height; y += 3)
            for (int x = 2; x < scene.settings.width; x += 3) {
                const PixelReport report = inspectPixel(*frame, {x, y});
                if (!report.covered) continue;
                const Evaluation& e = report.evaluations[0];
                const std::vector<double>& shadow = report.shadow;
                const Vec3d byRays = rays::shade<double>(lighting, lighting.material(report.object, report.back),
                                                         {e.position, e.N}, shadow);
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(byRays[c], report.intensity[c], 1e-3 * std::max(1.0, std::abs(byRays[c])));
                ++compared;
            }
    });
    EXPECT_GT(compared, 500);
}

}  // namespace
}  // namespace pipeline
