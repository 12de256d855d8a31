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

// Where a line of a loop has a value of the same name before.
const AlgorithmValue* findLastValue(const Walk& walk, std::string_view name) {
    const AlgorithmValue* last = nullptr;
    for (const Visit& visit : walk.visits)
        for (const AlgorithmValue& value : visit.values)
            if (value.name == name) last = &value;
    return last;
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

// The values of the other stages are the numbers of their buffers, bit for bit.
TEST_P(AlgorithmOf, TheValuesOfAStepAreThoseOfTheBuffers) {
    const FramePtr whole = test::frameOf(sceneOf(GetParam()));
    const Steps steps(whole);
    const auto row = [&](BufferId id, double i) {
        const AnyBuffer buffer = *whole->buffer({id});
        return Vec3d(buffer.value(0, std::size_t(i), 0), buffer.value(0, std::size_t(i), 1),
                     buffer.value(0, std::size_t(i), 2));
    };
    const auto isEqual = [](const AlgorithmValue& value, const Vec3d& expected) {
        return value.numbers.size() == 3 && Vec3d(value.numbers[0], value.numbers[1], value.numbers[2]) == expected;
    };
    int compared = 0;
    for (const std::int64_t tick : ticksOf(steps, StageId::Transform)) {
        const Walk walk = steps.algorithmAt({StageId::Transform, tick + 1})->walk;
        const AlgorithmValue* const world = findValue(walk, "xw, yw, zw");
        ASSERT_TRUE(world);
        ASSERT_TRUE(isEqual(*world, row(BufferId::VerticesWorld, double(tick)))) << tick;
        ++compared;
        if (const AlgorithmValue* const x = findValue(walk, "xs")) {
            ASSERT_EQ(x->numbers[0], row(BufferId::VerticesScreen, double(tick)).x) << tick;
        }
    }
    const AnyBuffer verdicts = *whole->buffer({BufferId::PolygonsVerdict});
    for (const std::int64_t tick : ticksOf(steps, StageId::Cull)) {
        const Walk walk = steps.algorithmAt({StageId::Cull, tick + 1})->walk;
        ASSERT_EQ(findValue(walk, "visibility")->text, name(Verdict(verdicts.flat(std::size_t(tick))))) << tick;
        ++compared;
    }
    for (const std::int64_t tick : ticksOf(steps, StageId::Normals)) {
        const Walk walk = steps.algorithmAt({StageId::Normals, tick + 1})->walk;
        const AlgorithmValue *const normal = findLastValue(walk, "n"), *const polygon = findValue(walk, "polygon");
        if (!normal || !polygon) continue;  // a vertex' normal
        ASSERT_TRUE(isEqual(*normal, row(BufferId::PolygonsNormal, polygon->numbers[0]))) << tick;
        ++compared;
    }
    const AnyBuffer color = *whole->buffer({BufferId::Color}), lit = *whole->buffer({BufferId::NDotL, 0});
    const AnyBuffer normals = *whole->buffer({BufferId::Normal});
    const bool isPhong = whole->scene().settings.shading == Shading::Phong;
    for (const std::int64_t tick : ticksOf(steps, StageId::Shading)) {
        const Moment after{StageId::Shading, tick + 1};
        const auto pixel = steps.pixelOf(after);
        if (!pixel) continue;
        const Walk walk = steps.algorithmAt(after)->walk;
        const auto at = [&](const AnyBuffer& buffer, int channel) {
            return buffer.value(std::size_t(pixel->x), std::size_t(pixel->y), channel);
        };
        const auto vectorAt = [&](const AnyBuffer& buffer) {
            return Vec3d(at(buffer, 0), at(buffer, 1), at(buffer, 2));
        };
        if (const AlgorithmValue* const stored = findValue(walk, "FB")) {
            ASSERT_TRUE(isEqual(*stored, vectorAt(color))) << text(steps.placeOf(after));
            ++compared;
        }
        if (!isPhong) continue;
        ASSERT_TRUE(isEqual(*findValue(walk, "N"), vectorAt(normals))) << text(steps.placeOf(after));
        ASSERT_EQ(findValue(walk, "N·L")->numbers[0], at(lit, 0)) << text(steps.placeOf(after));
    }
    EXPECT_GT(compared, 0);
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
