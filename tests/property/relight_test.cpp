// A frame that differs from the one before in nothing but what light is multiplied with takes the light from there; and
// has the bits of one computed from nothing, whatever the materials and whatever the processor.
#include <gtest/gtest.h>

#include "pipeline/run/frame_data.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

double oneOf(std::initializer_list<double> values, std::mt19937& random) {
    return *(values.begin() + random() % values.size());
}
// 0 one time in three: terms vanish and come back.
Vec3d coefficients(std::mt19937& random) {
    if (random() % 3 == 0) return Vec3d(0);
    return {oneOf({0.0, 0.3, 0.9}, random), oneOf({0.2, 0.7, 1e-30}, random), oneOf({0.0, 0.5, 3.0}, random)};
}

// One change of what light is multiplied with, or not even that.
void changeFactor(Scene& scene, std::mt19937& random) {
    Material& material = scene.objects[random() % scene.objects.size()].material;
    Light& light = scene.lights[random() % scene.lights.size()];
    switch (random() % 10) {
        case 0: material.diffuse = coefficients(random); break;
        case 1: material.specular = coefficients(random); break;
        case 2: material.diffuse = material.specular = Vec3d(0); break;
        case 3: material.exponent = oneOf({0, 1, 8, 60, 1e6, 1e30}, random); break;
        case 4: material.ambient = coefficients(random), material.emission = coefficients(random); break;
        case 5: material.highlight = Highlight(random() % 3); break;
        case 6: light.intensity = oneOf({0, 1, 80, -3, 1e9}, random); break;
        case 7: light.color = coefficients(random); break;
        case 8: scene.ambient.intensity = oneOf({0, 20}, random); break;
        default: scene.settings.exponentFactor = oneOf({0, 1, 4}, random);
    }
}

long long relitTiles(const Frame& frame) {
    return readStages(frame, [](const auto& data) { return data.shading->counts.relitTiles; });
}

Scene shinyScene(unsigned seed) {
    Scene scene = seed % 3 == 0 ? test::strangeScene(seed) : test::randomScene(seed);
    std::mt19937 random(seed + 31);
    Settings& settings = scene.settings;
    settings.precision = Precision::Float, settings.arithmetic = Arithmetic(random() % 2);
    settings.shading = seed % 8 == 7 ? Shading(random() % 3) : Shading::Phong;
    settings.model = seed % 16 == 5 ? Model(2 + random() % (kModelCount - 2)) : Model(random() % 2);
    settings.interpolation = Interpolation::Perspective, settings.forms = {};
    settings.depthFormat = random() % 4 ? DepthFormat::Linear : DepthFormat(random() % 9);
    settings.visibility = seed % 8 == 6 ? Visibility::Painter : Visibility::ZBuffer;
    settings.width = 30 + int(random() % 110), settings.height = 30 + int(random() % 70);
    settings.shadowFilter = int(random() % 2);
    settings.twoSided = seed % 8 == 5;  // of such a scene a frame keeps no light
    const Rule rule = Rule(seed % kRuleCount);
    if (rule != Rule::UnreadBuffers) settings.rules.reset(index(rule));  // without it every buffer is made
    if (scene.objects.empty()) scene.objects.push_back(test::pyramid().objects[0]);
    for (Object& object : scene.objects) object.material.alpha = random() % 8 ? 1 : 0.5;
    while (scene.lights.size() < 1 + seed % 3)
        scene.lights.push_back({LightKind::Point, {1, 2, 4}, 40, Vec3d(1), true});
    for (Light& light : scene.lights)
        if (light.intensity == 0) light.intensity = 20;
    return scene;
}

class Relight : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Shards, Relight, testing::Range(0u, 12u));

TEST_P(Relight, EqualsAFreshFrameAfterAnyChangeOfFactors) {
    long long relit = 0;
    for (unsigned seed = GetParam(); seed < 240; seed += 12) {
        Scene scene = shinyScene(seed);
        std::mt19937 random(seed);
        FramePtr frame;
        for (int step = 0; step < 30; ++step) {
            BufferSet wanted = setOf({BufferId::Color});
            if (step % 4 != 0) wanted.set(index(BufferId::Intensity));
            if (step % 13 == 12) wanted.set(index(BufferId::NDotL));
            frame = test::frameOf(scene, wanted, 0, frame);
            const FramePtr fresh = test::frameOf(scene, wanted);
            ASSERT_EQ(test::firstDifference(*frame, *fresh, wanted), "") << "seed " << seed << " step " << step;
            relit += relitTiles(*frame);
            step % 11 == 10 ? test::changeSomething(scene, random) : changeFactor(scene, random);
            if (scene.lights.empty()) scene.lights.emplace_back();
        }
    }
    EXPECT_GT(relit, 100);
}

// Of each instruction set in both arithmetics: what it has kept itself, and in exact arithmetic what the others have.
TEST(RelightInVectors, HasTheSameBitsInEveryWidth) {
    if (test::kHasOneInstructionSet) GTEST_SKIP() << test::kWhyNotCompared;
    const BufferSet wanted = setOf({BufferId::Color, BufferId::Intensity});
    const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
    const auto choose = [](std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    };
    for (const Arithmetic arithmetic : {Arithmetic::Exact, Arithmetic::Fast}) {
        for (std::size_t i = 0; i < targets.size(); ++i) {
            Scene scene = test::spheres();
            scene.settings.arithmetic = arithmetic;
            choose(targets[arithmetic == Arithmetic::Exact ? i : 0]);
            FramePtr frame = test::frameOf(scene, wanted);
            scene.objects[0].material.exponent = 20;
            frame = test::frameOf(scene, wanted, 0, frame);
            if (arithmetic == Arithmetic::Exact) choose(targets[targets.size() - 1 - i]);
            scene.objects[0].material = {{0.3, 0.8, 0.1}, Vec3d(0.6), 5};
            scene.lights[1].color = {1, 0.2, 0.3};
            frame = test::frameOf(scene, wanted, 0, frame);
            EXPECT_GT(relitTiles(*frame), 0) << hwy::TargetName(targets[i]);
            EXPECT_EQ(test::firstDifference(*frame, *test::frameOf(scene, wanted), wanted), "")
                << hwy::TargetName(targets[i]);
        }
    }
    choose(0);
}

PlanPart incidencePart(const Frame& frame) {
    for (const PlanPart& part : frame.plan()[index(StageId::Shading)].parts)
        if (part.name == "N·L, highlights and S") return part;
    return {};
}
long long done(const Frame& frame, std::string_view what) {
    for (const Tally& tally : frame.run(StageId::Shading).tallies)
        if (tally.what == what) return tally.done;
    return 0;
}

// The second of three frames keeps the light, the third takes it: no N·L, no look-up, as many evaluations as the first
// has made. 333 × 241 pixels are 6 × 4 tiles.
TEST(RelightPlan, SaysWhatIsKeptAndReused) {
    const BufferSet wanted = setOf({BufferId::Color});
    Scene scene = test::spheres();
    const FramePtr first = test::frameOf(scene, wanted);
    EXPECT_EQ(incidencePart(*first).name, "");
    scene.objects[0].material.exponent = 20;
    const FramePtr second = test::frameOf(scene, wanted, 0, first);
    EXPECT_EQ(incidencePart(*second).action, Action::Run);
    // 84 × 61 blocks: each 8 bytes, and for each of two lights 12 and three numbers a pixel: 2.13 MB.
    EXPECT_TRUE(incidencePart(*second).why.starts_with("Kept for other materials, in 2.1 MB "))
        << incidencePart(*second).why;
    EXPECT_EQ(done(*second, "light evaluations"), done(*first, "light evaluations"));
    EXPECT_EQ(done(*second, "shadow look-ups"), done(*first, "shadow look-ups"));
    EXPECT_EQ(done(*second, "light evaluations reused"), 0);
    scene.objects[0].material.diffuse = {0.1, 0.2, 0.3};
    scene.lights[0].intensity = 50;
    const FramePtr third = test::frameOf(scene, wanted, 0, second);
    EXPECT_EQ(third->plan()[index(StageId::Shading)].why, "Material 0 changed.");
    EXPECT_EQ(incidencePart(*third).action, Action::Reuse);
    EXPECT_EQ(incidencePart(*third).why, "Those of frame 2, where they are all that the materials need.");
    EXPECT_EQ(done(*third, "light evaluations"), 0);
    EXPECT_EQ(done(*third, "shadow look-ups"), 0);
    EXPECT_EQ(done(*third, "light evaluations reused"), done(*first, "light evaluations"));
    EXPECT_EQ(relitTiles(*third), done(*third, "tiles"));
    EXPECT_EQ(done(*third, "tiles"), done(*first, "tiles"));
    EXPECT_NE(third->run(StageId::Shading).counts.find("; N·L, highlights and S reused in"), std::string::npos);
}

// Where a material had no highlight, the tiles that see it are shaded anew, and keep that; once.
TEST(RelightPlan, ShadesAnewWhereWhatIsKeptDoesNotSuffice) {
    const BufferSet wanted = setOf({BufferId::Color});
    Scene scene = test::spheres();
    FramePtr frame = test::frameOf(scene, wanted);
    const auto next = [&] { return frame = test::frameOf(scene, wanted, 0, frame); };
    scene.objects[0].material.exponent = 20;
    next();
    scene.objects[1].material.specular = Vec3d(0.5);  // it had none
    next();
    EXPECT_GT(relitTiles(*frame), 0);
    EXPECT_LT(relitTiles(*frame), done(*frame, "tiles"));
    scene.objects[1].material.specular = Vec3d(0.4);
    EXPECT_EQ(relitTiles(*next()), done(*frame, "tiles"));
    scene.objects[1].material.specular = Vec3d(0);  // what is kept of the highlight stays
    EXPECT_EQ(relitTiles(*next()), done(*frame, "tiles"));
    scene.objects[1].material.specular = Vec3d(0.3);
    EXPECT_EQ(relitTiles(*next()), done(*frame, "tiles"));
    scene.objects[1].material.highlight = Highlight::BlinnPhong;  // of H
    next();
    EXPECT_GT(relitTiles(*frame), 0);
    EXPECT_LT(relitTiles(*frame), done(*frame, "tiles"));
}

// Black when it is kept, it has looked no shadow up.
TEST(RelightPlan, LooksShadowsUpOfWhatWasBlack) {
    const BufferSet wanted = setOf({BufferId::Color});
    Scene scene = test::spheres();
    scene.objects[1].material.diffuse = Vec3d(0);
    FramePtr frame = test::frameOf(scene, wanted);
    scene.objects[0].material.exponent = 20;
    frame = test::frameOf(scene, wanted, 0, frame);
    scene.objects[1].material.diffuse = Vec3d(0.5);
    frame = test::frameOf(scene, wanted, 0, frame);
    EXPECT_GT(done(*frame, "shadow look-ups"), 0);
    EXPECT_GT(relitTiles(*frame), 0);
    EXPECT_EQ(test::firstDifference(*frame, *test::frameOf(scene, wanted), wanted), "");
}

TEST(RelightPlan, SaysWhyNothingIsKept) {
    const auto afterTwoChanges = [](Scene scene, BufferSet wanted) {
        FramePtr frame = test::frameOf(scene, wanted);
        for (const double exponent : {20, 21}) {
            scene.objects[0].material.exponent = exponent;
            frame = test::frameOf(scene, wanted, 0, frame);
        }
        EXPECT_EQ(relitTiles(*frame), 0);
        EXPECT_EQ(incidencePart(*frame).action, Action::LeaveOut);
        return incidencePart(*frame).why;
    };
    const std::string_view begin = "Not kept for other materials: ";
    const auto expect = [&](const Scene& scene, BufferSet wanted, const std::string& why) {
        EXPECT_EQ(afterTwoChanges(scene, wanted), std::string(begin) + why);
    };
    const BufferSet color = setOf({BufferId::Color});
    Scene scene = test::spheres();
    expect(scene, setOf({BufferId::Color, BufferId::Shadow}), "more buffers than the picture are asked for.");
    scene.lights.resize(700);  // 80,253 pixels of nearly 13 bytes for each light
    for (std::size_t k = 2; k < scene.lights.size(); ++k) scene.lights[k].intensity = 0;
    expect(scene, color, "they may take more than 128 MB.");
    scene = test::spheres();
    scene.settings.antialiasing = 2;
    expect(scene, color, "each of a pixel's samples has its own.");
    scene = test::spheres();
    scene.settings.shading = Shading::Gouraud;
    expect(scene, color, "Phong shading in vectors of pixels alone keeps them.");
    scene = test::spheres();
    scene.settings.precision = Precision::Double;
    expect(scene, color, "Phong shading in vectors of pixels alone keeps them.");
}

// 32 × 32 boxes in a tile: a block sees four or more, and so many pieces are not kept.
TEST(RelightPlan, KeepsNoTileOfManyObjects) {
    const BufferSet wanted = setOf({BufferId::Color});
    Scene scene = test::boxOverGround();
    scene.settings.width = scene.settings.height = kTileSize;
    scene.settings.shading = Shading::Phong;
    scene.camera.eye = {0, 0, 10}, scene.camera.target = Vec3d(0), scene.camera.up = {0, 1, 0};
    scene.camera.projection = ProjectionKind::Orthographic, scene.camera.height = 32;
    Object box = scene.objects[1];
    box.mesh = test::box(Vec3d(-0.5), Vec3d(0.5));
    scene.objects.clear();
    for (int i = 0; i < 32 * 32; ++i) {
        box.transform.translation = {i % 32 - 15.5, i / 32 - 15.5, 0};
        scene.objects.push_back(box);
    }
    FramePtr frame = test::frameOf(scene, wanted);
    for (int i = 1; i < 4; ++i) {
        for (Object& object : scene.objects) object.material.diffuse = Vec3d(0.2 * i);
        frame = test::frameOf(scene, wanted, 0, frame);
        EXPECT_EQ(relitTiles(*frame), 0);
        EXPECT_GT(done(*frame, "light evaluations"), 0);
    }
    EXPECT_EQ(incidencePart(*frame).action, Action::Reuse);
    EXPECT_EQ(test::firstDifference(*frame, *test::frameOf(scene, wanted), wanted), "");
}

// A camera or a light that moves leaves nothing of it.
TEST(RelightPlan, KeepsNothingOfAnotherLight) {
    const BufferSet wanted = setOf({BufferId::Color});
    Scene scene = test::spheres();
    FramePtr frame = test::frameOf(scene, wanted);
    for (int i = 0; i < 3; ++i) {
        scene.lights[std::size_t(i) % 2].position.x += 1, scene.objects[0].material.exponent += 1;
        frame = test::frameOf(scene, wanted, 0, frame);
        EXPECT_EQ(incidencePart(*frame).name, "");
        EXPECT_TRUE(dataOf<float>(*frame)->shading->incidence.empty());
    }
}

}  // namespace
}  // namespace pipeline
