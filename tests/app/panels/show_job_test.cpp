// What a view shows of many polygons is made and painted beside the window.
#include "app/canvas/show_job.h"

#include <gtest/gtest.h>

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/buffer_view/buffer_range.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/canvas/canvas_base.h"
#include "app/compare/buffer_compare.h"
#include "app/frames/large_frame.h"
#include "tests/app/large_scene.h"

namespace {

using app::BufferView;
using app::CanvasBase;
using app::Document;
using app::FrameFeed;
using app::OtherSource;
using app::ShowJob;
using app::ShowRequest;
using pipeline::BufferId;

constexpr pipeline::BufferName kDepth{BufferId::ZView};

pipeline::FramePtr frameOf(const pipeline::Scene& scene) {
    return test::frameOf(scene, pipeline::setOf({BufferId::ZView, BufferId::PolygonId, BufferId::PolygonsVerdict}));
}

ShowRequest depthOf(const pipeline::FramePtr& frame) { return {.frame = frame, .buffer = *frame->buffer(kDepth)}; }

bool finished(const ShowJob& job) {
    return QTest::qWaitFor([&] { return !job.busy(); }, 20000);
}

}  // namespace

TEST(ShowJob, LittleIsMadeAtOnce) {
    ShowJob job;
    const auto frame = frameOf(test::pyramid());
    const auto answer = job.answer(depthOf(frame));
    ASSERT_TRUE(answer);
    EXPECT_FALSE(job.busy());
    EXPECT_EQ(job.answer(depthOf(frame)), answer) << "asking the same again costs nothing";
}

// Of one frame every buffer of the picture covers as much: the pixels that show a polygon.
TEST(ShowJob, ADescriptionTellsHowMuchIsDrawn) {
    const auto frame = test::frameOf(test::pyramid());
    const auto covered = [&](BufferId id) {
        const auto shown = app::showBuffer(*frame, {id}, lessons::ShownChannel::All, {});
        return shown->counts->description.section(", ", 2, 2);
    };
    const auto ids = *frame->buffer({BufferId::PolygonId});
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < ids.count(); ++i) drawn += ids.flat(i) >= 0;
    const QString share = QString::number(100.0 * double(drawn) / double(ids.count()), 'f', 2) + " % covered";
    for (const BufferId id : {BufferId::ZView, BufferId::Color, BufferId::Intensity, BufferId::Ambient})
        EXPECT_EQ(covered(id), share) << bufferInfo(id).name;
}

TEST(ShowJob, TheVeilIsOfTheThemesGround) {
    ShowJob job;
    const auto frame = frameOf(test::pyramid());
    const glm::ivec2 size(frame->scene().settings.width, frame->scene().settings.height);
    const lessons::ConditionMask nowhere{.size = size,
                                         .holds = std::vector<bool>(std::size_t(size.x) * std::size_t(size.y))};
    const auto veil = [&] {
        ShowRequest request = depthOf(frame);
        request.veil = std::make_shared<const lessons::ConditionMask>(nowhere);
        return job.answer(request)->shown.content.overlays.back().pixelColor(0, 0);
    };
    app::Theme::current().set(app::ThemeId::Light);
    EXPECT_GT(veil().lightness(), 200);
    app::Theme::current().set(app::ThemeId::Dark);
    EXPECT_LT(veil().lightness(), 50);
    app::Theme::current().set(app::ThemeId::Light);
}

// S of a pixel that is not shaded yet is not known: that its buffer holds 1 there must not look like light.
TEST(ShowJob, InsideShadingAPixelThatIsNotShadedYetIsNotDrawn) {
    Document document;
    QObject owner;
    document.frames().want(&owner, pipeline::setOf({BufferId::Shadow, BufferId::NDotL}));
    document.setScene(test::pyramid());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy() && document.stepper().steps(); }, 30000));
    // How many values its histogram counts.
    const auto drawn = [&](BufferId id) {
        const auto shown = app::showBuffer(*document.frames().shown(), {id, 0}, lessons::ShownChannel::All, {});
        return std::accumulate(shown->scale.histogram.begin(), shown->scale.histogram.end(), 0);
    };
    const auto whole = drawn(BufferId::Shadow);
    EXPECT_GT(whole, 0);
    document.stepper().goTo(*pipeline::parsePlace("shading/polygon=1"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy() && document.stepper().isSettled(); }, 30000));
    EXPECT_LT(drawn(BufferId::Shadow), whole);
    EXPECT_EQ(drawn(BufferId::Shadow), drawn(BufferId::NDotL));
    document.stepper().goTo(*pipeline::parsePlace("shading/start"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy() && document.stepper().isSettled(); }, 30000));
    EXPECT_EQ(drawn(BufferId::Shadow), 0);
}

// Until the new answer is there it is the whole old one: never a histogram of one frame beside the picture of another.
TEST(ShowJob, OfManyPolygonsTheOldAnswerStaysWholeUntilTheNewOneIsThere) {
    ShowJob job;
    pipeline::Scene scene = test::manyPolygons();
    const auto first = frameOf(scene);
    ASSERT_TRUE(app::isLarge(*first));
    EXPECT_FALSE(job.answer(depthOf(first))) << "the window does not wait for it";
    ASSERT_TRUE(finished(job));
    const auto before = job.answer(depthOf(first));
    ASSERT_TRUE(before);
    scene.camera.theta += 20;
    const auto second = frameOf(scene);
    EXPECT_EQ(job.answer(depthOf(second)), before);
    ASSERT_TRUE(finished(job));
    const auto after = job.answer(depthOf(second));
    EXPECT_EQ(after->request.frame, second);
    const app::ShownBuffer expected = app::show(depthOf(second));
    EXPECT_EQ(after->shown.content.image, expected.content.image);
    EXPECT_EQ(after->shown.scale.histogram, expected.scale.histogram);
}

// A view of the buffer z_view on the screen.
class DepthView : public testing::Test {
protected:
    DepthView() {
        view.resize(640, 560);
        view.show();
        view.setBuffer(kDepth);
    }
    Document document;
    BufferView view{document};
};

TEST_F(DepthView, AViewShowsOneFrameInAllThatItSays) {
    document.setScene(test::manyPolygons());
    const auto shows = [&](const pipeline::FramePtr& frame) {
        return frame && view.shown() && view.shown()->buffer.owner == frame->buffer(kDepth)->owner;
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy() && shows(document.frames().shown()); }, 20000));
    const auto counted = [](const app::ShownBuffer& shown) {
        const auto drawn = app::drawnElements(shown.buffer, {}, shown.look.channel);
        return app::histogram(shown.buffer, {shown.look.channel, {shown.scale.low, shown.scale.high}}, drawn,
                              int(shown.scale.histogram.size()));
    };
    // At each moment of a drag; the histogram may be of a frame before.
    for (int i = 1; i <= 20; ++i) {
        document.change(*findSetting(document.scene(), "camera.theta"), 45 + i, Document::Change::Live);
        QTest::qWait(5);
        const app::ShownBuffer& shown = *view.shown();
        EXPECT_EQ(view.canvas()->content().image, shown.content.image);
        const auto drawn = app::drawnElements(shown.buffer, {}, shown.look.channel);
        EXPECT_EQ(app::bufferImage(shown.buffer, shown.look, drawn), shown.content.image);
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy() && shows(document.frames().shown()); }, 20000));
    EXPECT_TRUE(QTest::qWaitFor([&] { return counted(*view.shown()) == view.shown()->scale.histogram; }, 10000));
}

// While a slider moves they may be of a frame before; the hand rests with the button down, and nothing else happens.
TEST_F(DepthView, CountsAreThoseOfThePictureOnceTheHandRests) {
    document.setScene(test::pyramid());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy() && view.shown().has_value(); }, 20000));
    const auto theta = *findSetting(document.scene(), "camera.theta");
    for (int i = 1; i <= 12; ++i) {
        document.change(theta, 45 + 3 * i, Document::Change::Live);
        ASSERT_TRUE(QTest::qWaitFor([&] { return view.frame()->sharedScene() == document.sharedScene(); }, 10000));
    }
    // A pixel's bin is the 64th of the scale in which its value lies; the greatest value lies in the last.
    const auto z = *document.frames().shown()->buffer(kDepth);
    std::vector<int> expected(64, 0);
    const auto& scale = view.shown()->scale;
    for (std::size_t i = 0; i < z.count(); ++i)
        if (const double value = z.flat(i); std::isfinite(value))
            ++expected[std::size_t(std::min(63.0, 64 * (value - scale.low) / (scale.high - scale.low)))];
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.shown()->counts->histogram == expected; }, 10000));
}

// Another buffer of the same frame: whatever frame A is of while a slider moves, B is of the same.
TEST(ShowJob, AAndBOfAComparisonAreOfOneFrame) {
    constexpr pipeline::BufferName kOther{BufferId::Overdraw};
    Document document;
    BufferView view(document);
    view.resize(640, 560);
    view.show();
    view.setBuffer(kDepth);
    std::vector<pipeline::FramePtr> frames;
    QObject::connect(&document.frames(), &FrameFeed::frameReady, [&] { frames.push_back(document.frames().shown()); });
    document.setScene(test::manyPolygons());
    view.compare().compareWith(OtherSource{.kind = OtherSource::Kind::Buffer, .buffer = kOther});
    view.compare().setMode(app::CompareMode::B);
    const auto comparing = [&] { return !document.frames().busy() && view.compare().difference().found().has_value(); };
    ASSERT_TRUE(QTest::qWaitFor(comparing, 20000));
    int seen = 0;
    for (int i = 1; i <= 20; ++i) {
        document.change(*findSetting(document.scene(), "camera.theta"), 45 + i, Document::Change::Live);
        QTest::qWait(20);
        const auto ofA = [&](const pipeline::FramePtr& frame) {
            return frame->buffer(kDepth)->owner == view.shown()->buffer.owner;
        };
        const auto frame = std::ranges::find_if(frames, ofA);
        ASSERT_NE(frame, frames.end());
        ASSERT_EQ(view.canvas()->wipe().share, 0) << "B fills the view";
        const auto b = app::showBuffer(**frame, kOther, lessons::ShownChannel::All, {});
        EXPECT_EQ(view.canvas()->seen().image, b->content.image) << i;
        seen += *frame != frames.front();
    }
    EXPECT_GT(seen, 0);
    // What was found about this B is not told of the next.
    view.compare().compareWith(OtherSource{.kind = OtherSource::Kind::Buffer, .buffer = {BufferId::Depth}});
    EXPECT_FALSE(view.compare().difference().found());
    ASSERT_TRUE(QTest::qWaitFor(comparing, 20000));
    const auto depth = *document.frames().shown()->buffer({BufferId::Depth});
    EXPECT_EQ(view.compare().difference().found()->values.count(), depth.count());
}

TEST_F(DepthView, TheDifferenceOfALargeFrameIsShownWithItsFittingRange) {
    document.setScene(test::manyPolygons());
    view.compare().compareWith(OtherSource{.kind = OtherSource::Kind::Buffer, .buffer = {BufferId::Depth}});
    view.compare().setMode(app::CompareMode::Difference);
    const auto showsDifference = [&] { return view.shown() && isDifference(*view.shown()->buffer.info); };
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return showsDifference() && !view.compare().difference().showing().busy(); }, 20000));
    EXPECT_EQ(view.shown()->numbers.max, view.compare().difference().found()->largest)
        << "z_view - depth is nowhere negative";
    const auto whole = view.shown()->look.range;
    view.features().range->set({1, 2});
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.shown()->look.range == pipeline::PaletteRange{1, 2}; }, 10000));
    view.features().range->fit(false);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return view.compare().difference().range() && view.shown()->look.range == whole; }, 10000));
    EXPECT_EQ(*view.compare().difference().range(), whole);
    view.compare().setMode(app::CompareMode::A);
    EXPECT_FALSE(showsDifference());
}

TEST_F(DepthView, FittingOnceKeepsTheRangeOfTheNextPicture) {
    document.setScene(test::manyPolygons());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy() && view.shown(); }, 20000));
    const auto whole = view.shown()->look.range;
    view.features().range->set({600, 700});
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.shown()->look.range == pipeline::PaletteRange{600, 700}; }, 10000));
    view.features().range->fit(false);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return view.state().range.has_value() && view.shown()->look.range == whole; }, 10000));
    EXPECT_EQ((*view.state().range)[0], double(whole.first));
}

TEST_F(DepthView, TheWorstPixelOfALargeFrameIsPickedOnceItIsFound) {
    pipeline::Scene scene = test::pyramid();
    scene.settings.width = 1280, scene.settings.height = 960;
    document.setScene(scene);
    view.compare().compareWith(OtherSource{.kind = OtherSource::Kind::Buffer, .buffer = {BufferId::Overdraw}});
    ASSERT_FALSE(view.compare().difference().found());
    view.compare().goToWorst();
    ASSERT_TRUE(QTest::qWaitFor([&] { return document.pointing().pixel().has_value(); }, 20000));
    const auto& found = *view.compare().difference().found();
    const auto columns = found.values.columns();
    EXPECT_EQ(*document.pointing().pixel(), glm::ivec2(*found.worst % columns, *found.worst / columns));
}

// A picture that is given up leaves the one before, until it is gone on with.
TEST_F(DepthView, AViewToldToStopShowsWhatItHadUntilItIsToGoOn) {
    document.setScene(test::manyPolygons());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy() && view.shown(); }, 20000));
    const auto before = view.shown()->look.range;
    view.features().range->set({1, 2});
    document.work().cancel();
    EXPECT_TRUE(document.work().stopped().contains("a buffer's picture"));
    QTest::qWait(300);
    EXPECT_EQ(view.shown()->look.range, before);
    document.work().resume();
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.shown()->look.range == pipeline::PaletteRange{1, 2}; }, 10000));
    EXPECT_TRUE(document.work().stopped().isEmpty());
}

TEST_F(DepthView, WhatIsSelectedAmongManyPolygonsIsMarkedWithoutWaitingForIt) {
    document.setScene(test::manyPolygons());
    const auto& marked = view.canvas()->content().marked;
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy() && view.shown(); }, 20000));
    document.pointing().select(lessons::Selection{lessons::Selection::Kind::Object, 0});
    EXPECT_TRUE(marked.empty()) << "the window does not wait for it";
    const auto outlines = app::outlinesOf(*document.frames().shown(), *document.pointing().selection());
    ASSERT_EQ(outlines.size(), 1u);
    ASSERT_TRUE(QTest::qWaitFor([&] { return marked == outlines; }, 10000));
    document.pointing().select({});
    EXPECT_TRUE(marked.empty());
    // Given up before it was found.
    document.pointing().select(lessons::Selection{lessons::Selection::Kind::Object, 0});
    document.pointing().select({});
    QTest::qWait(200);
    EXPECT_TRUE(marked.empty());
}

TEST(ShowJob, WhatIsStoppedIsLeftUnfinished) {
    const auto frame = frameOf(test::manyPolygons());
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(app::show(depthOf(frame), stop.get_token()).content.image.isNull());
    const pipeline::BufferName verdicts{BufferId::PolygonsVerdict};
    const ShowRequest onPolygons{.frame = frame, .buffer = *frame->buffer(verdicts)};
    const auto shapes = app::show(onPolygons, stop.get_token()).content.shapes;
    EXPECT_TRUE(!shapes || shapes->shapes.empty());
    EXPECT_FALSE(app::show(onPolygons).content.shapes->shapes.empty());
}

// The same pixels, wherever they are painted; until then what was painted last, moved to where it belongs now.
TEST(CanvasBase, PaintsManyPolygonsBesideTheWindow) {
    const auto frame = frameOf(test::manyPolygons());
    const app::ShownBuffer verdicts =
        app::show({.frame = frame, .buffer = *frame->buffer({BufferId::PolygonsVerdict})});
    ASSERT_TRUE(verdicts.content.isOfManyPolygons);
    app::CanvasContent atOnce = verdicts.content;
    atOnce.isOfManyPolygons = false;
    CanvasBase base, expectedBase;
    const auto drawn = [](CanvasBase& by, const app::CanvasContent& content, QPointF origin) {
        QImage image(320, 240, QImage::Format_RGB32);
        QPainter painter(&image);
        by.draw(painter, content, {{origin, 1}, image.size(), 1});
        return image;
    };
    const QImage expected = drawn(expectedBase, atOnce, {-150, -120});
    EXPECT_NE(drawn(base, verdicts.content, {-150, -120}), expected) << "nothing is there yet";
    EXPECT_TRUE(base.busy());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !base.busy(); }, 20000));
    EXPECT_EQ(drawn(base, verdicts.content, {-150, -120}), expected);
    EXPECT_FALSE(base.busy()) << "it is painted once";
    const QImage moved = drawn(base, verdicts.content, {-140, -120});
    EXPECT_TRUE(base.busy());
    EXPECT_EQ(moved.copy(10, 0, 310, 240), expected.copy(0, 0, 310, 240));
}
