#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/scene/mesh/topology.h"
#include "tests/support/scenes.h"
#include "tests/twin/comparison.h"
#include "tests/twin/twin_scenes.h"

// A real OpenGL carries out the calls that an export writes, and must draw our picture.
namespace twin {
namespace {

using namespace pipeline;

class Twin : public testing::TestWithParam<NamedScene> {
protected:
    void SetUp() override {
        std::string whyNot;
        m_gl = GlContext::make(whyNot);
        ASSERT_TRUE(m_gl) << "not compared with OpenGL: " << whyNot;
    }

    void expectTheSamePicture(const std::string& name, const Scene& scene) {
        const FramePtr frame = test::frameOf(scene);
        const auto calls = glCalls(*frame);
        ASSERT_TRUE(calls) << format(calls.errors());
        expectThePicture(name, frame, *calls);
    }

    void expectThePicture(const std::string& name, const FramePtr& frame, const std::vector<GlCall>& calls) {
        const Settings& settings = frame->scene().settings;
        // OpenGL's polygons are counted by glBegin: one each.
        ASSERT_EQ(std::size_t(std::ranges::count(calls, "glBegin", &GlCall::function)),
                  frame->topology().polygonCount());
        const GlPicture picture = m_gl->draw(calls, {settings.width, settings.height});
        EXPECT_EQ(picture.error, "") << name;
        const Comparison found = compare(*frame, picture);
        fmt::print("{}: {}\n", name, found.text());
        EXPECT_GT(found.interior, 1000) << name;
        EXPECT_LE(found.color, 1) << name << ", " << explain(*frame, picture, found.colorAt);
        EXPECT_LE(found.depthShare, 1) << name << ", " << explain(*frame, picture, found.depthAt);
        // Two grids of 1/256 pixel part an edge by at most 1/128 pixel in x and in y: of the pixels
        // along it, on average one in 64 has its centre between the two.
        EXPECT_LE(found.coverage, 4 + found.edge / 32) << name;
        EXPECT_EQ(found.astray, 0) << name;
    }

private:
    std::unique_ptr<GlContext> m_gl;
};

TEST_P(Twin, DrawsTheSamePicture) { expectTheSamePicture(GetParam().name, GetParam().scene); }

INSTANTIATE_TEST_SUITE_P(OpenGl, Twin, testing::ValuesIn(featureScenes()),
                         [](const auto& scene) { return scene.param.name; });

// Nobody tells OpenGL of an ambient light here: what it has by itself is the reference.
class AmbientTwin : public Twin {};

TEST_P(AmbientTwin, IsOpenGlsOwnWhereTheSceneGivesNone) {
    Scene scene = GetParam().scene;
    scene.ambient.intensity.reset();
    const FramePtr frame = test::frameOf(scene);
    auto calls = glCalls(*frame);
    ASSERT_TRUE(calls) << format(calls.errors());
    std::vector<GlCall> untold = *calls;
    ASSERT_EQ(
        std::erase_if(untold, [](const GlCall& call) { return toC(call).find("MODEL_AMBIENT") != std::string::npos; }),
        1u);
    expectThePicture(GetParam().name, frame, untold);
}

INSTANTIATE_TEST_SUITE_P(OpenGl, AmbientTwin, testing::Values(featureScenes().front()),
                         [](const auto& scene) { return scene.param.name; });

class RandomTwin : public Twin {};

TEST_P(RandomTwin, DrawsTheSamePicture) { expectTheSamePicture(GetParam().name, GetParam().scene); }

std::vector<NamedScene> randomScenes() {
    std::vector<NamedScene> scenes;
    for (unsigned seed = 0; seed < 50; ++seed) scenes.push_back({fmt::format("Seed{}", seed), randomGlScene(seed)});
    return scenes;
}

INSTANTIATE_TEST_SUITE_P(OpenGl, RandomTwin, testing::ValuesIn(randomScenes()),
                         [](const auto& scene) { return scene.param.name; });

}  // namespace
}  // namespace twin
