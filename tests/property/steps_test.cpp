// Stepping inside a frame: at its last moment the state is the whole frame, and no moment depends on how one got there.
#include <gtest/gtest.h>

#include "pipeline/illumination/illumination.h"
#include "pipeline/steps/steps.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

class StepsOf : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Seeds, StepsOf, testing::Range(0u, 40u));

BufferSet buffersUpTo(StageId stage) {
    BufferSet set;
    for (const BufferInfo& info : bufferTable()) set[index(info.id)] = info.stage <= stage;
    return set;
}

Moment randomMoment(const Steps& steps, std::mt19937& random) {
    const StageId stage = kStages[random() % kStageCount];
    const auto done = std::int64_t(random() % std::uint64_t(steps.total(stage) + 1));
    return steps.fitting({stage, done});
}

TEST_P(StepsOf, EveryStageEndsAsTheWholeFrameDoes) {
    const FramePtr whole = test::frameOf(test::smallScene(GetParam()));
    const Steps steps(whole);
    for (const StageId stage : kStages) {
        if (!steps.runs(stage)) continue;
        const FramePtr there = steps.frameAt({stage, steps.total(stage)});
        EXPECT_EQ(there->until(), stage);
        ASSERT_EQ(test::firstDifference(*there, *whole, buffersUpTo(stage)), "") << stageInfo(stage).name;
    }
    EXPECT_EQ(test::firstDifference(*steps.frameAt(steps.last()), *whole), "");
}

TEST_P(StepsOf, LaterStagesHaveNoBuffersAndSayWhy) {
    const FramePtr whole = test::frameOf(test::smallScene(GetParam()));
    const Steps steps(whole);
    for (const StageId stage : kStages) {
        if (!steps.runs(stage)) continue;
        const FramePtr there = steps.frameAt({stage, steps.total(stage) / 2});
        for (const BufferName& name : allBuffers(whole->scene().lights.size())) {
            if (bufferInfo(name.id).stage <= stage) {
                EXPECT_EQ(bool(there->buffer(name)), bool(whole->buffer(name))) << name.text();
            } else {
                EXPECT_FALSE(there->buffer(name)) << name.text();
                EXPECT_NE(there->whyAbsent(name), "") << name.text();
            }
        }
    }
}

TEST_P(StepsOf, AMomentDependsNeitherOnTheWayThereNorOnThreads) {
    std::mt19937 random(GetParam());
    const FramePtr whole = test::frameOf(test::smallScene(GetParam()));
    const Steps steps(whole), others(whole);
    for (int i = 0; i < 6; ++i) {
        const Moment moment = randomMoment(steps, random);
        const FramePtr first = steps.frameAt(moment, 1);
        steps.frameAt(randomMoment(steps, random));  // somewhere else in between
        ASSERT_EQ(test::firstDifference(*first, *steps.frameAt(moment, 7)), "") << text(steps.placeOf(moment));
        ASSERT_EQ(test::firstDifference(*first, *others.frameAt(moment)), "") << text(steps.placeOf(moment));
    }
}

TEST_P(StepsOf, BackIsTheInverseOfForth) {
    std::mt19937 random(GetParam());
    const Steps steps(test::frameOf(test::smallScene(GetParam())));
    for (const StepLevel level : {StepLevel::Stage, StepLevel::Object, StepLevel::Polygon}) {
        Moment moment = steps.first();
        std::int64_t made = 0, counted = 0;
        for (const StageId stage : kStages)
            counted += std::max<std::int64_t>(steps.runs(stage), steps.count(stage, level));
        while (const auto next = steps.next(moment, level)) {
            ASSERT_LT(moment, *next);
            ASSERT_EQ(steps.previous(*next, level), moment) << name(level) << " " << text(steps.placeOf(*next));
            moment = *next, ++made;
        }
        EXPECT_EQ(moment, steps.last());
        EXPECT_EQ(made, counted) << name(level);
    }
    // Of the many rows and pixels some.
    for (int i = 0; i < 20; ++i) {
        const StepLevel level = i % 2 ? StepLevel::Pixel : StepLevel::Scanline;
        const auto on = steps.next(randomMoment(steps, random), level);
        if (!on) continue;
        const auto farther = steps.next(*on, level);
        if (farther) {
            EXPECT_EQ(steps.previous(*farther, level), on) << text(steps.placeOf(*farther));
        }
    }
}

TEST_P(StepsOf, ANamedMomentIsFoundAgain) {
    std::mt19937 random(GetParam());
    const Steps steps(test::frameOf(test::smallScene(GetParam())));
    for (int i = 0; i < 60; ++i) {
        const Moment moment = randomMoment(steps, random);
        const Place place = steps.placeOf(moment);
        EXPECT_EQ(steps.momentOf(place), moment) << text(place);
        const auto read = parsePlace(text(place));
        ASSERT_TRUE(read) << text(place) << format(read.errors());
        EXPECT_EQ(*read, place) << text(place);
    }
}

// A step by pixel changes that pixel, and nothing else.
TEST_P(StepsOf, APixelChangesThatPixelAlone) {
    std::mt19937 random(GetParam());
    const FramePtr whole = test::frameOf(test::smallScene(GetParam()));
    const Steps steps(whole);
    for (int i = 0; i < 4; ++i) {
        const StageId stage = i % 2 ? StageId::ZBuffer : StageId::Shading;
        if (steps.total(stage) == 0) continue;
        const Moment before{stage, std::int64_t(random() % std::uint64_t(steps.total(stage)))};
        const Moment after{stage, before.done + 1};
        const auto pixel = steps.pixelOf(after);
        if (!pixel) continue;
        const auto overdraw = *steps.frameAt(before)->buffer({BufferId::Overdraw}),
                   arrived = *steps.frameAt(after)->buffer({BufferId::Overdraw});
        const auto colors = steps.frameAt(before)->buffer({BufferId::Intensity}),
                   shaded = steps.frameAt(after)->buffer({BufferId::Intensity});
        for (std::size_t y = 0; y < overdraw.rows(); ++y)
            for (std::size_t x = 0; x < overdraw.columns(); ++x) {
                const bool here = glm::ivec2(int(x), int(y)) == *pixel;
                if (stage == StageId::ZBuffer) {
                    ASSERT_EQ(arrived.value(x, y) > overdraw.value(x, y), here) << text(steps.placeOf(after));
                } else if (!here) {
                    ASSERT_EQ(shaded->value(x, y), colors->value(x, y)) << text(steps.placeOf(after));
                }
            }
    }
}

}  // namespace
}  // namespace pipeline
