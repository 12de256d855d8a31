// Stepping inside the frame of lecture 1's pyramid, whose polygons can be counted by hand.
#include "pipeline/steps/steps.h"

#include <gtest/gtest.h>

#include "pipeline/inspect/pixel_report.h"
#include "pipeline/stages/cull.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// Culling off: five polygons, in scene order.
Steps uncutPyramid() {
    Scene scene = test::pyramid();
    scene.settings.cull = CullMode::None;
    return Steps(test::frameOf(scene));
}

std::string at(const Steps& steps, std::string_view place) {
    return text(steps.placeOf(steps.momentOf(*parsePlace(place))));
}

TEST(Steps, CountWhatTheStagesWorkThrough) {
    const Steps steps(test::frameOf(test::pyramid(), setOf({BufferId::Color, BufferId::Overdraw})));
    EXPECT_EQ(steps.count(StageId::Transform, StepLevel::Polygon), 5);  // vertices: the stage knows no polygons
    EXPECT_EQ(steps.count(StageId::Cull, StepLevel::Pixel), 5);
    EXPECT_FALSE(steps.runs(StageId::ShadowBuffer));  // convex and alone
    EXPECT_EQ(steps.count(StageId::ShadowBuffer, StepLevel::Stage), 0);
    // Three of the five faces are turned towards the eye.
    EXPECT_EQ(steps.count(StageId::ZBuffer, StepLevel::Object), 1);
    EXPECT_EQ(steps.count(StageId::ZBuffer, StepLevel::Polygon), 3);
    std::int64_t fragments = 0;
    const AnyBuffer arrived = *steps.frame()->buffer({BufferId::Overdraw});
    for (std::size_t i = 0; i < arrived.count(); ++i) fragments += std::int64_t(arrived.flat(i));
    EXPECT_EQ(steps.count(StageId::ZBuffer, StepLevel::Pixel), fragments);
}

// Each as pixelOf names it alone, from the middle of a row as well, to the end of the polygon and no further.
TEST(Steps, ThePixelsToComeAreThoseOfOneStepAfterTheOther) {
    Scene scene = test::pyramid();
    scene.settings.shading = Shading::Phong;  // whose first steps are pixels
    const Steps steps(test::frameOf(scene, setOf({BufferId::Color})));
    for (const StageId stage : {StageId::ZBuffer, StageId::Shading}) {
        const std::int64_t polygon = steps.next({stage, 0}, StepLevel::Polygon)->done;
        const std::int64_t row = steps.next({stage, 0}, StepLevel::Scanline)->done;
        for (const std::int64_t from : {std::int64_t(0), std::int64_t(1), row, row + 1, polygon - 1}) {
            const std::vector<glm::ivec2> pixels = steps.pixelsToCome({stage, from});
            ASSERT_EQ(std::int64_t(pixels.size()), polygon - from);
            for (std::size_t i = 0; i < pixels.size(); ++i)
                ASSERT_EQ(steps.pixelOf({stage, from + std::int64_t(i) + 1}), pixels[i]) << from << " " << i;
        }
        EXPECT_TRUE(steps.pixelsToCome({stage, steps.total(stage)}).empty());
    }
    EXPECT_TRUE(steps.pixelsToCome(steps.first()).empty()) << "vertices have no pixels";
}

// The pyramid's polygons 1, 2 and 3 are drawn; row 270 crosses them (derived in tests/reference), row 0 nothing.
TEST(Steps, KnowWhichPlacesAFrameComesTo) {
    const Steps steps(test::frameOf(test::pyramid(), setOf({BufferId::Color})));
    const auto comesTo = [&](const char* place) { return steps.comesTo(*parsePlace(place)); };
    for (const char* place : {"transform", "z-buffer/start", "z-buffer/object=0", "z-buffer/polygon=2",
                              "z-buffer/polygon=2/row=270", "shading/polygon=1", "transform/vertex=4"})
        EXPECT_TRUE(comesTo(place)) << place;
    for (const char* place :
         {"z-buffer/polygon=0", "z-buffer/polygon=2/row=0", "z-buffer/polygon=2/row=270/x=0", "z-buffer/piece=1",
          "shading/layers", "shading/vertex-terms=1", "shadow-buffer/polygon=1"})
        EXPECT_FALSE(comesTo(place)) << place;
}

// Fast arithmetic leaves out what the steps of shading read: they make it up, and come to the same picture.
TEST(Steps, ShadeInFastArithmeticToo) {
    Scene scene = test::pyramid();
    scene.settings.shading = Shading::Phong;
    scene.settings.arithmetic = Arithmetic::Fast;
    const FramePtr whole = test::frameOf(scene, setOf({BufferId::Color, BufferId::Intensity}));
    const Steps steps(whole);
    const FramePtr last = steps.frameAt({StageId::Shading, steps.total(StageId::Shading)});
    EXPECT_EQ(test::firstDifference(*last, *whole, setOf({BufferId::Color, BufferId::Intensity})), "");
    const FramePtr first = steps.frameAt({StageId::Shading, 0});
    const AnyBuffer dark = *first->buffer({BufferId::Intensity});
    for (std::size_t i = 0; i < dark.count(); ++i) ASSERT_EQ(dark.flat(i), 0);
}

// A picture that is reused holds the buffers that a frame before asked for, too.
TEST(Steps, InsideAPictureThatIsReusedAreThoseOfAFreshOne) {
    Scene scene = test::pyramid();
    scene.settings.shading = Shading::Phong;
    const BufferSet color = setOf({BufferId::Color});
    const FramePtr more = test::frameOf(scene, setOf({BufferId::Color, BufferId::Normal, BufferId::NDotL}));
    const FramePtr reused = test::frameOf(scene, color, 0, more);
    ASSERT_EQ(reused->plan()[index(StageId::Shading)].action, Action::Reuse);
    const Steps steps(reused), fresh(test::frameOf(scene, color));
    const Moment half{StageId::Shading, steps.total(StageId::Shading) / 2};
    EXPECT_EQ(test::firstDifference(*steps.frameAt(half), *fresh.frameAt(half), color), "");
}

TEST(Steps, AStageThatIsLeftOutIsPassedOver) {
    const Steps steps(test::frameOf(test::pyramid(), setOf({BufferId::Color})));
    const Moment normals{StageId::Normals, steps.total(StageId::Normals)};
    EXPECT_EQ(steps.next(normals, StepLevel::Stage)->stage, StageId::ZBuffer);
    EXPECT_EQ(steps.previous({StageId::ZBuffer, steps.total(StageId::ZBuffer)}, StepLevel::Stage), normals);
    EXPECT_EQ(at(steps, "shadow-buffer/polygon=2"), "normals");
}

TEST(Steps, TheZBufferAfterKPolygonsHoldsTheNearestOfThose) {
    // Polygons that were not there draw no fragments: the frame of the first two alone.
    Scene scene = test::pyramid();
    scene.settings.cull = CullMode::None;
    const Steps steps(test::frameOf(scene));
    const auto& positions = scene.objects[0].mesh->positions;
    scene.objects[0].mesh = test::mesh(positions, {{0, 1, 4}, {1, 2, 4}});
    const FramePtr two = test::frameOf(scene);
    const FramePtr there = steps.frameAt(steps.momentOf(*parsePlace("z-buffer/polygon=1")));
    for (const BufferId id : {BufferId::ZView, BufferId::PolygonId, BufferId::Overdraw, BufferId::DepthWrites}) {
        const AnyBuffer a = *there->buffer({id}), b = *two->buffer({id});
        for (std::size_t i = 0; i < a.count(); ++i) ASSERT_EQ(a.flat(i), b.flat(i)) << i;
    }
}

TEST(Steps, WithinAPolygonTheRowsFillFromTheTopAndTheLeft) {
    const Steps steps = uncutPyramid();
    const FramePtr before = steps.frameAt(steps.momentOf(*parsePlace("z-buffer/polygon=1")));
    const FramePtr after = steps.frameAt(steps.momentOf(*parsePlace("z-buffer/polygon=2")));
    const FramePtr there = steps.frameAt(steps.momentOf(*parsePlace("z-buffer/polygon=2/row=270/x=258")));
    const auto depths = [](const FramePtr& frame) { return *frame->buffer({BufferId::ZView}); };
    const AnyBuffer z = depths(there), first = depths(before), last = depths(after);
    for (std::size_t y = 0; y < 480; ++y)
        for (std::size_t x = 0; x < 640; ++x) {
            const bool drawn = y < 270 || (y == 270 && x <= 258);
            ASSERT_EQ(z.value(x, y), (drawn ? last : first).value(x, y));
        }
}

TEST(Steps, ARowOfAPolygonEndsInItsLastPixel) {
    const Steps steps = uncutPyramid();
    const Moment row = steps.momentOf(*parsePlace("z-buffer/polygon=2/row=270"));
    const auto pixel = steps.pixelOf(row);
    ASSERT_TRUE(pixel);
    EXPECT_EQ(pixel->y, 270);
    EXPECT_EQ(steps.next(row, StepLevel::Scanline), steps.momentOf(*parsePlace("z-buffer/polygon=2/row=271")));
    EXPECT_EQ(steps.next(row, StepLevel::Polygon), steps.momentOf(*parsePlace("z-buffer/polygon=2")));
    EXPECT_EQ(steps.pixelOf(*steps.next(row, StepLevel::Pixel))->y, 271);
}

TEST(Steps, PolygonsNotYetCulledHaveNoVerdict) {
    const Steps steps(test::frameOf(test::pyramid()));
    const AnyBuffer verdicts = *steps.frameAt({StageId::Cull, 3})->buffer({BufferId::PolygonsVerdict});
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(verdicts.flat(i) == double(Verdict::NotYet), i >= 3) << i;
}

TEST(Steps, FlatShadingEvaluatesPolygonsBeforePixels) {
    const Steps steps(test::frameOf(test::pyramid(), setOf({BufferId::Color})));
    EXPECT_EQ(at(steps, "shading/polygon-terms=1"), "shading/polygon-terms=1");
    const FramePtr evaluated = steps.frameAt(steps.momentOf(*parsePlace("shading/polygon-terms=4")));
    const AnyBuffer picture = *evaluated->buffer({BufferId::Color});
    for (std::size_t i = 0; i < picture.count(); ++i) ASSERT_EQ(picture.flat(i), 0);
    EXPECT_EQ(steps.next(steps.momentOf(*parsePlace("shading/polygon-terms=4")), StepLevel::Polygon),
              steps.momentOf(*parsePlace("shading/polygon=1")));  // polygon 0 faces away
}

TEST(Steps, ThePainterGoesFromTheFarthestToTheNearest) {
    Scene scene = test::pyramid();
    scene.settings.visibility = Visibility::Painter, scene.settings.split = false;
    scene.settings.cull = CullMode::None;
    const Steps steps(test::frameOf(scene));
    // Whatever came last at a pixel is seen in it.
    const FramePtr there = steps.frameAt(steps.momentOf(*parsePlace("z-buffer/piece=3")));
    const FramePtr whole = steps.frame();
    ASSERT_EQ(steps.count(StageId::ZBuffer, StepLevel::Polygon), 5);
    const auto last = steps.polygonOf(steps.momentOf({StageId::ZBuffer}));
    const AnyBuffer ids = *whole->buffer({BufferId::PolygonId}), reached = *there->buffer({BufferId::PolygonId});
    bool covered = false;
    for (std::size_t y = 0; y < 480; ++y)
        for (std::size_t x = 0; x < 640; ++x) {
            const double seen = ids.value(x, y);
            covered = covered || seen == double(*last);
            if (seen != double(*last)) {
                ASSERT_EQ(reached.value(x, y), seen);
            }
        }
    EXPECT_TRUE(covered);
}

TEST(Steps, RunToAPixelStopsAtEveryFragmentThatArrivesThere) {
    const Steps steps = uncutPyramid();
    const glm::ivec2 pixel{258, 270};
    const auto arrived = [&](const Frame& frame) { return frame.buffer({BufferId::Overdraw})->value(258, 270); };
    Moment moment = steps.first();
    int stops = 0;
    while (const auto next = steps.nextAt(moment, pixel)) {
        moment = *next;
        EXPECT_EQ(steps.pixelOf(moment), pixel);
        if (moment.stage != StageId::ZBuffer) break;
        ++stops;
        const FramePtr there = steps.frameAt(moment), before = steps.frameAt({moment.stage, moment.done - 1});
        EXPECT_EQ(arrived(*there), stops);
        EXPECT_EQ(arrived(*before), stops - 1);
    }
    EXPECT_EQ(stops, arrived(*steps.frame()));
    EXPECT_GT(stops, 0);
    EXPECT_EQ(moment.stage, StageId::Shading);  // shaded once, afterwards
    EXPECT_FALSE(steps.nextAt(moment, pixel));
}

TEST(Steps, RunToAPolygonStopsInEveryStageThatIsAtIt) {
    const Steps steps = uncutPyramid();
    Moment moment = steps.first();
    std::vector<StageId> stops;
    while (const auto next = steps.nextAt(moment, Steps::Thing::Polygon, 2)) {
        moment = *next;
        EXPECT_EQ(steps.polygonOf(moment), 2u);
        stops.push_back(moment.stage);
    }
    using enum StageId;
    // Normals of polygons; the terms of flat shading, and its pixels.
    EXPECT_EQ(stops, (std::vector<StageId>{Cull, Normals, StageId::ShadowBuffer, ZBuffer, Shading, Shading}));
}

TEST(Steps, KnowWhichPolygonsTheStageIsDoneWith) {
    const Steps steps = uncutPyramid();
    using Done = std::vector<std::uint8_t>;
    EXPECT_EQ(steps.polygonsDone(steps.momentOf(*parsePlace("z-buffer/polygon=1"))), (Done{1, 1, 0, 0, 0}));
    EXPECT_EQ(steps.polygonsDone(steps.momentOf(*parsePlace("z-buffer/polygon=2/row=270"))), (Done{1, 1, 0, 0, 0}));
    // The faces have vertices 0 1 4, 1 2 4, 2 3 4, 0 4 3 and 0 3 2 1: without the top, the base alone.
    EXPECT_EQ(steps.polygonsDone({StageId::Transform, 4}), (Done{0, 0, 0, 0, 1}));
    EXPECT_EQ(steps.polygonsDone(steps.first()), (Done{0, 0, 0, 0, 0}));
}

TEST(Steps, InsideTheZBufferTheLedgerOfAPixelTellsWhatIsToCome) {
    const Steps steps = uncutPyramid();
    const glm::ivec2 pixel{258, 270};
    const PixelReport whole = inspectPixel(*steps.frame(), pixel);
    const Moment first = *steps.nextAt({StageId::ZBuffer, 0}, pixel);
    const PixelReport there = inspectPixel(*steps.frameAt(first), pixel);
    ASSERT_EQ(there.fragments.size(), whole.fragments.size());
    ASSERT_EQ(there.fragments.size(), 2u);  // polygon 0 is hidden behind polygon 2
    EXPECT_EQ(there.fragments[0].verdict, FragmentVerdict::WonStays);
    EXPECT_EQ(there.fragments[1].verdict, FragmentVerdict::NotYet);
    EXPECT_EQ(whole.fragments[0].verdict, FragmentVerdict::Overwritten);
}

// Polygon 2, which the pixel shows, comes after polygon 0.
TEST(Steps, InsideShadingTheEquationOfAPixelSaysThatItWaits) {
    for (const Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong}) {
        Scene scene = test::pyramid();
        scene.settings.cull = CullMode::None, scene.settings.shading = shading;
        const Steps steps(test::frameOf(scene));
        const auto said = [&](std::int64_t done) {
            const FramePtr frame = steps.frameAt({StageId::Shading, done});
            std::string text;
            for (const EquationLine& line : equation(frame->scene(), inspectPixel(*frame, {258, 270}), 2))
                text += line.role + ": " + toText(line.formula) + '\n';
            return text;
        };
        const std::string before = said(1), after = said(steps.total(StageId::Shading));
        EXPECT_NE(before.find("note: This pixel is not shaded yet."), std::string::npos) << before;
        EXPECT_EQ(before.find("frame buffer: "), std::string::npos);
        EXPECT_NE(after.find("frame buffer: "), std::string::npos) << after;
        EXPECT_EQ(after.find("not shaded yet"), std::string::npos);
    }
}

TEST(Steps, SayInWordsWhereTheyAre) {
    const Steps steps = uncutPyramid();
    const Moment moment = steps.momentOf(*parsePlace("z-buffer/polygon=2/row=270/x=258"));
    EXPECT_EQ(steps.words(moment, StepLevel::Pixel), "polygon 2, row 270, x 258");
    EXPECT_EQ(steps.words(moment, StepLevel::Polygon), "polygon 2, row 270, x 258");  // inside it
    const Moment polygon = steps.momentOf(*parsePlace("z-buffer/polygon=2"));
    EXPECT_EQ(steps.words(polygon, StepLevel::Polygon), "polygon 2");
    EXPECT_EQ(steps.made(polygon, StepLevel::Polygon), 3);
    EXPECT_EQ(steps.words(steps.first(), StepLevel::Polygon), "Transform, not begun");
    EXPECT_EQ(steps.words({StageId::Transform, 2}, StepLevel::Pixel), "vertex 1");
    EXPECT_EQ(steps.words(steps.momentOf({StageId::ZBuffer}), StepLevel::Object), "object 0, pyramid");
    EXPECT_EQ(steps.words(steps.last(), StepLevel::Stage), "Shading, done");
    const Steps::Progress progress = steps.progress(moment);
    EXPECT_EQ(progress.done, moment.done);
    EXPECT_EQ(progress.of, steps.total(StageId::ZBuffer));
    EXPECT_EQ(progress.unit, "fragments");
}

TEST(Place, ThatIsNoneSaysWhatIsKnown) {
    for (const char* wrong :
         {"", "zbuffer", "z-buffer/vertex=1", "z-buffer/polygon", "z-buffer/polygon=-1", "z-buffer/polygon=2/x=3",
          "z-buffer/row=3", "cull/polygon=1/row=2", "z-buffer/start/row=1", "cull/light=0",
          "z-buffer/polygon=99999999999", "z-buffer/polygon=1/polygon=2", "z-buffer/layers", "z-buffer/"}) {
        const auto place = parsePlace(wrong);
        ASSERT_FALSE(place) << wrong;
        EXPECT_NE(place.errors()[0].found, "") << wrong;
        EXPECT_NE(place.errors()[0].expected, "") << wrong;
    }
}

}  // namespace
}  // namespace pipeline
