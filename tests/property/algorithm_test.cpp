// Line and values of every step against the buffers and the inspector.
#include "pipeline/steps/algorithm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/inspect/pixel_report.h"
#include "pipeline/steps/steps.h"
#include "tests/support/scenes.h"
#include "tests/support/sweep.h"

namespace pipeline {
namespace {

// Five scenes that go through different lines: culled and not, painted, with shadows, in OpenGL's model, interpolated
// along scanlines, translucent.
Scene sceneOf(unsigned number) {
    Scene scene = test::smallScene(number);
    if (number == 0) scene = test::pyramid(), scene.settings.cull = CullMode::None;
    if (number == 1) scene = test::boxOverGround(), scene.settings.shading = Shading::Phong;
    if (number == 2) scene = test::openGlCube(), scene.settings.shading = Shading::Gouraud;
    if (number == 3) {
        scene = test::boxOverGround(), scene.settings.shading = Shading::Gouraud;
        scene.settings.interpolation = Interpolation::Scanline, scene.settings.visibility = Visibility::Painter;
    }
    scene.settings.width = std::min(scene.settings.width, 160),
    scene.settings.height = std::min(scene.settings.height, 120);
    if (number == 4) scene.objects.front().material.alpha = 0.5;
    return scene;
}

class AlgorithmOf : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Scenes, AlgorithmOf, testing::Range(0u, 5u));

// Of a stage's smallest steps.
std::vector<std::int64_t> ticksOf(const Steps& steps, StageId stage) {
    const std::vector<std::size_t> all = test::sweep(std::size_t(steps.total(stage)));
    return {all.begin(), all.end()};
}

const AlgorithmValue* findValue(const Walk& walk, std::string_view name) {
    for (const Visit& visit : walk.visits)
        for (const AlgorithmValue& value : visit.values)
            if (value.name == name) return &value;
    return nullptr;
}

TEST_P(AlgorithmOf, TheLineOfADepthTestHasTheBuffersValuesAndTheInspectorsVerdict) {
    const FramePtr whole = test::frameOf(sceneOf(GetParam()));
    if (whole->scene().settings.visibility != Visibility::ZBuffer) GTEST_SKIP() << "no depth test";
    const Steps steps(whole);
    const BufferName depth{steps.frame()->buffer({BufferId::Depth}) ? BufferId::Depth : BufferId::ZView};
    for (const std::int64_t tick : ticksOf(steps, StageId::ZBuffer)) {
        const Moment before{StageId::ZBuffer, tick}, after{StageId::ZBuffer, tick + 1};
        const auto state = *steps.algorithmAt(after);
        const glm::ivec2 pixel = *steps.pixelOf(after);
        const auto at = [&](const FramePtr& frame) {
            return frame->buffer(depth)->value(std::size_t(pixel.x), std::size_t(pixel.y));
        };
        const FramePtr there = steps.frameAt(after);
        const AlgorithmValue &z = *findValue(state.walk, "z"), &stored = *findValue(state.walk, "zbuffer(x, y)");
        ASSERT_EQ(stored.numbers[0], at(steps.frameAt(before))) << text(steps.placeOf(after));
        const PixelReport report = inspectPixel(*there, pixel);
        const auto arrived = std::ranges::find_if(report.fragments.rbegin(), report.fragments.rend(),
                                                  [](const FragmentReport& f) { return came(f.verdict); });
        ASSERT_NE(arrived, report.fragments.rend());
        ASSERT_EQ(arrived->polygon, int(*steps.polygonOf(after)));
        ASSERT_EQ(z.numbers[0], arrived->depth);
        const auto branch = std::ranges::find_if(state.walk.visits, [](const Visit& v) { return v.taken.has_value(); });
        ASSERT_EQ(*branch->taken, won(arrived->verdict));
        ASSERT_EQ(at(there), *branch->taken ? z.numbers[0] : stored.numbers[0]);
    }
}

// Every line of a frame forth, and back the same moments.
TEST_P(AlgorithmOf, BackByLineIsTheInverseOfForth) {
    const Steps steps(test::frameOf(sceneOf(GetParam())));
    for (const StageId stage : kStages) {
        if (!steps.runs(stage)) continue;
        for (const std::int64_t tick : ticksOf(steps, stage)) {
            Moment moment{stage, tick};
            // The ends of pixels' steps are ends of lines.
            for (int i = 0; i < 200 && moment < Moment{stage, tick + 1}; ++i) {
                const auto next = steps.next(moment, StepLevel::Line);
                ASSERT_TRUE(next);
                ASSERT_LT(moment, *next);
                ASSERT_LE(*next, (Moment{stage, tick + 1})) << text(steps.placeOf(*next));
                if (moment.done > 0 || moment.line > 0) {
                    ASSERT_EQ(steps.previous(*next, StepLevel::Line), moment) << text(steps.placeOf(*next));
                }
                const Place place = steps.placeOf(*next);
                ASSERT_EQ(steps.momentOf(place), *next) << text(place);
                ASSERT_EQ(*parsePlace(text(place)), place) << text(place);
                moment = *next;
            }
            ASSERT_EQ(moment, (Moment{stage, tick + 1}));
        }
    }
}

// Every name between braces has a value in each step that passes its line.
TEST_P(AlgorithmOf, EveryNameInALineIsBound) {
    const Steps steps(test::frameOf(sceneOf(GetParam())));
    for (const StageId stage : kStages)
        for (const std::int64_t tick : ticksOf(steps, stage)) {
            const auto state = steps.algorithmAt({stage, tick + 1});
            ASSERT_TRUE(state) << text(steps.placeOf({stage, tick + 1}));
            ASSERT_FALSE(state->walk.visits.empty());
            for (const auto* passed : {&state->walk.visits, &state->walk.around})
                for (const Visit& visit : *passed) {
                    const Algorithm::Line& line = state->walk.algorithm.lines[visit.line];
                    ASSERT_EQ(std::ptrdiff_t(visit.values.size()), std::ranges::count(line.row->text, '{'))
                        << line.row->text << ", " << text(steps.placeOf({stage, tick + 1}));
                    for (const AlgorithmValue& value : visit.values) {
                        ASSERT_FALSE(value.text.empty()) << value.name;
                        for (const double number : value.numbers) ASSERT_FALSE(std::isnan(number)) << value.name;
                    }
                }
        }
}

}  // namespace
}  // namespace pipeline
