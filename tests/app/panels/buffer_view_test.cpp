#include "app/buffer_view/buffer_view.h"
#include "app/buffer_view/buffer_channels.h"
#include "app/buffer_view/buffer_flip.h"
#include "app/buffer_view/buffer_overlays.h"
#include "app/buffer_view/buffer_range.h"
#include "app/buffer_view/buffer_region.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "app/canvas/buffer_canvas.h"
#include "app/canvas/condition_bar.h"
#include "pipeline/buffers/palette.h"
#include "tests/support/scenes.h"

// The real view on a real document with lecture 1's pyramid.
namespace {

using app::BufferCanvas;
using app::BufferView;
using app::Document;
using pipeline::BufferId;

struct BufferViewTest : testing::Test {
    Document document;
    BufferView view{document};

    BufferViewTest() {
        view.resize(640, 560);
        view.show();
        document.setScene(test::pyramid());
        show({BufferId::ZView});
    }
    void show(const pipeline::BufferName& name) {
        view.setBuffer(name);
        EXPECT_TRUE(settled()) << name.text();
    }
    // The frame has come, and with it the buffer or the reason why there is none.
    bool settled() {
        return QTest::qWaitFor(
            [this] {
                return document.frames().shown() && !document.frames().busy() &&
                       (view.shown() || !view.message().isEmpty()) &&
                       (!view.shown() || view.shown()->buffer.name == view.buffer());
            },
            10000);
    }
    BufferCanvas& canvas() { return *view.canvas(); }
    const QImage& image() { return canvas().content().image; }
    pipeline::AnyBuffer buffer() { return *document.frames().shown()->buffer(view.buffer()); }
    QPoint widgetAt(QPoint pixel) {
        return canvas().placing().placement().toWidget(QPointF(pixel) + QPointF(0.5, 0.5)).toPoint();
    }
};

constexpr QPoint kOnPolygon2{268, 281};  // the picked pixel of the design's mock-up: inside polygon 2
constexpr QPoint kBackground{5, 5};

}  // namespace

TEST_F(BufferViewTest, EveryPixelHasTheColourThatAnExportGivesIt) {
    const auto z = buffer();
    const auto range = fittingRange(z, statistics(z), pipeline::DepthFormat::Linear);
    ASSERT_EQ(image().size(), QSize(640, 480));
    int drawn = 0;
    for (int y = 0; y < 480; ++y)
        for (int x = 0; x < 640; ++x) {
            const QRgb shown = image().pixel(x, y);
            const double value = z.value(std::size_t(x), std::size_t(y));
            ASSERT_EQ(qAlpha(shown) == 0, std::isinf(value)) << x << ", " << y;
            if (std::isinf(value)) continue;
            const auto color = elementColor(z, std::size_t(x), std::size_t(y), range);
            ASSERT_EQ(shown, qRgb(color.r, color.g, color.b)) << x << ", " << y;
            ++drawn;
        }
    EXPECT_GT(drawn, 2000);  // the pyramid covers more than half of a box of 84 × 66 pixels
}

TEST(BufferViewPutAway, WantsNothingAndShowsTheNewestFrameWhenItComesBack) {
    Document document;
    QWidget window;
    auto* view = new BufferView(document, &window);
    view->hide();
    window.show();
    view->setBuffer({BufferId::NDotL, 0});
    document.setScene(test::pyramid());
    const auto settled = [&] {
        return QTest::qWaitFor([&] { return document.frames().shown() && !document.frames().busy(); }, 10000);
    };
    ASSERT_TRUE(settled());
    EXPECT_FALSE(document.frames().shown()->buffer({BufferId::NDotL, 0}));
    EXPECT_FALSE(view->shown());
    view->show();
    ASSERT_TRUE(settled());
    ASSERT_TRUE(view->shown());
    EXPECT_EQ(view->shown()->buffer.name, (pipeline::BufferName{BufferId::NDotL, 0}));
    // A frame that came while it was away.
    const auto before = view->shown()->buffer.owner;
    view->hide();
    document.change(*findSetting(document.scene(), "camera.theta"), 35);
    ASSERT_TRUE(settled());
    EXPECT_EQ(view->shown()->buffer.owner, before);
    view->show();
    ASSERT_TRUE(settled());
    const auto now = document.frames().shown()->buffer({BufferId::NDotL, 0});
    ASSERT_TRUE(now);
    EXPECT_EQ(view->shown()->buffer.owner, now->owner);
}

TEST_F(BufferViewTest, AClickPicksThePixelUnderIt) {
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, widgetAt(kOnPolygon2));
    ASSERT_TRUE(document.pointing().pixel());
    EXPECT_EQ(*document.pointing().pixel(), glm::ivec2(268, 281));
    EXPECT_EQ(canvas().content().picked, kOnPolygon2);
}

TEST_F(BufferViewTest, ArrowKeysMoveThePickedPixelByOneAndWithShiftByTen) {
    document.pointing().pick(glm::ivec2(100, 100));
    QTest::keyClick(&canvas(), Qt::Key_Left);
    QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_EQ(*document.pointing().pixel(), glm::ivec2(99, 110));
    document.pointing().pick(glm::ivec2(0, 0));
    QTest::keyClick(&canvas(), Qt::Key_Up);  // stays in the picture
    EXPECT_EQ(*document.pointing().pixel(), glm::ivec2(0, 0));
}

TEST_F(BufferViewTest, DraggingMovesThePictureAndPicksNothing) {
    const QPointF before = canvas().placing().placement().origin;
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, QPoint(200, 200));
    for (int i = 1; i <= 4; ++i) {
        QMouseEvent move(QEvent::MouseMove, QPointF(200 + 10 * i, 200),
                         canvas().mapToGlobal(QPointF(200 + 10 * i, 200)), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QApplication::sendEvent(&canvas(), &move);
    }
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, QPoint(240, 200));
    EXPECT_EQ(canvas().placing().placement().origin - before, QPointF(40, 0));
    EXPECT_FALSE(document.pointing().pixel());
}

TEST_F(BufferViewTest, TheWheelZoomsToTheCursorInWholeSteps) {
    const QPoint at = widgetAt(kOnPolygon2);
    for (int i = 0; i < 6; ++i) {
        QWheelEvent wheel(at, canvas().mapToGlobal(QPointF(at)), {}, {0, 120}, {}, {}, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&canvas(), &wheel);
        EXPECT_EQ(canvas().placing().zoom(), std::floor(canvas().placing().zoom()));
        ASSERT_EQ(canvas().placing().pixelAt(at), kOnPolygon2) << "zoom " << canvas().placing().zoom();
    }
    EXPECT_GE(canvas().placing().zoom(), 10);
}

TEST_F(BufferViewTest, FittingShowsWhatIsDrawnAndThenTheWholePicture) {
    const QRectF seen(canvas().placing().placement().toPicture({0, 0}),
                      canvas().placing().placement().toPicture(QPointF(canvas().width(), canvas().height())));
    EXPECT_GE(canvas().placing().zoom(), 2);  // the pyramid is about 84 pixels wide
    for (const QPolygonF& edge : canvas().content().edges(QRectF(0, 0, 640, 480)))
        EXPECT_TRUE(seen.contains(edge.boundingRect()));
    canvas().placing().toggleFit();
    EXPECT_LT(canvas().placing().zoom(), 1.01);  // 640 pixels in 640
}

// A picture of a million polygons that is magnified shows few of them.
TEST_F(BufferViewTest, OutlinesAreThoseThatReachIntoThePartInSight) {
    const auto& edges = canvas().content().edges;
    EXPECT_EQ(edges(QRectF(0, 0, 640, 480)).size(), 3u) << "of the pyramid's five polygons two face away";
    EXPECT_TRUE(edges(QRectF(0, 0, 20, 20)).empty()) << "it stands in the middle";
    const QPointF on = QPointF(kOnPolygon2) + QPointF(0.5, 0.5);
    const auto near = edges(QRectF(on, QSizeF(0, 0)));
    EXPECT_TRUE(
        std::ranges::any_of(near, [&](const QPolygonF& edge) { return edge.containsPoint(on, Qt::OddEvenFill); }));
    EXPECT_LT(near.size(), 3u);
}

TEST_F(BufferViewTest, LargePixelsCarryTheirValues) {
    const QStringList lines = canvas().content().text(kOnPolygon2.x(), kOnPolygon2.y());
    ASSERT_EQ(lines.size(), 2);
    EXPECT_NEAR(lines[0].toDouble(), buffer().value(268, 281), 5e-5);
    EXPECT_EQ(lines[1], "p2");  // polygon 2 "Right" of the lecture; one fragment
    EXPECT_EQ(canvas().content().text(kBackground.x(), kBackground.y()), QStringList("no value"));
    canvas().placing().setZoom(72, widgetAt(kOnPolygon2));
    const QImage written = canvas().grab().toImage();
    const QPointF corner = canvas().placing().placement().toWidget(kOnPolygon2);
    int dark = 0;  // the letters, within the cell's frame
    for (int y = 20; y < 52; ++y)
        for (int x = 6; x < 66; ++x)
            dark += written.pixelColor(int(corner.x()) + x, int(corner.y()) + y).lightness() < 60;
    EXPECT_GT(dark, 60);
}

TEST_F(BufferViewTest, ALeftOutBufferTellsWhyAndIsComputedWhenAskedFor) {
    show({BufferId::ShadowBuffer, 0});
    EXPECT_TRUE(view.message().contains("The only object is convex: it cannot shadow itself."));
    EXPECT_FALSE(document.frames().shown()->buffer({BufferId::ShadowBuffer, 0}));
    QPushButton* compute = nullptr;
    for (auto* button : view.findChildren<QPushButton*>())
        if (button->text() == "Compute anyway") compute = button;
    ASSERT_TRUE(compute && compute->isVisible());
    compute->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.message().isEmpty(); }, 10000));
    EXPECT_TRUE(document.frames().shown()->buffer({BufferId::ShadowBuffer, 0}));
    EXPECT_EQ(image().size(), QSize(1024, 1024));  // texels of the light, not pixels of the picture
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, canvas().rect().center());
    EXPECT_FALSE(document.pointing().pixel());
}

TEST_F(BufferViewTest, RangeAndChannelAreKeptPerBuffer) {
    view.features().range->set({600, 700});
    show({BufferId::Specular, 0});
    view.features().channel->set(lessons::ShownChannel::Third);
    show({BufferId::ZView});
    EXPECT_EQ(view.shown()->look.range, (pipeline::PaletteRange{600, 700}));
    show({BufferId::Specular, 0});
    EXPECT_EQ(view.features().channel->channel(), lessons::ShownChannel::Third);
    // Blue of the specular term alone: 3 polygons are seen, with 3 values.
    EXPECT_TRUE(view.shown()->notice.contains("3 distinct values")) << view.shown()->notice.toStdString();
    show({BufferId::ZView});
    view.features().range->fit(true);  // the range follows every frame again
    EXPECT_NE(view.shown()->look.range, (pipeline::PaletteRange{600, 700}));
}

TEST_F(BufferViewTest, TheChoiceOfRangeNeverChangesTheValueThatIsRead) {
    const QStringList before = canvas().content().text(268, 281);
    view.features().range->set({0, 1});
    EXPECT_EQ(canvas().content().text(268, 281), before);
}

TEST_F(BufferViewTest, VerdictsAreShownOnThePolygonsWithTheirLetters) {
    show({BufferId::PolygonsVerdict});
    ASSERT_TRUE(canvas().content().shapes);
    QString letters(5, ' ');
    for (const app::Shape& shape : canvas().content().shapes->shapes)
        letters[shape.outline.polygon] = QLatin1Char(shape.letter);
    // Seen from theta = 45, phi = 60: Front, Right and Back face the eye; Left and Base face away.
    EXPECT_EQ(letters, "BKKKB");
    EXPECT_EQ(view.shown()->legend.size(), 2u);
}

TEST_F(BufferViewTest, VerticesAreShownWhereTheyStandInThePicture) {
    show({BufferId::VerticesScreen});
    ASSERT_TRUE(canvas().content().shapes);
    const auto& points = canvas().content().shapes->points;
    ASSERT_EQ(points.size(), 5u);
    for (const app::ShapePoint& point : points)
        EXPECT_EQ(point.at, QPointF(buffer().value(0, std::size_t(point.vertex), 0),
                                    buffer().value(0, std::size_t(point.vertex), 1)));
}

TEST_F(BufferViewTest, DescribesItselfToAScreenReader) {
    EXPECT_TRUE(view.accessibleDescription().startsWith("z_view, 640 by 480, "))
        << view.accessibleDescription().toStdString();
    EXPECT_TRUE(view.accessibleDescription().contains("% covered, nearest "));
}

TEST_F(BufferViewTest, TheOldPictureStaysUntilTheNewFrameIsThere) {
    const QImage before = image();
    auto scene = document.scene();
    scene.camera.theta += 20;
    document.replace(scene, "turn");
    EXPECT_EQ(image(), before);
    ASSERT_TRUE(QTest::qWaitFor([&] { return image() != before; }, 10000));
}

TEST_F(BufferViewTest, OverlaysLieOverThePictureAndSayWhatTheyStandFor) {
    show({BufferId::Color});
    const auto legend = [&] { return view.shown()->notice; };
    view.features().overlays->set(app::OverlayId::Fragments, true);
    view.features().overlays->set(app::OverlayId::DepthTest, true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return canvas().content().overlays.size() == 2; }, 10000));
    for (const QImage& overlay : canvas().content().overlays) {
        EXPECT_NE(qAlpha(overlay.pixel(kOnPolygon2)), 0);
        EXPECT_EQ(qAlpha(overlay.pixel(kBackground)), 0);  // no fragment came
    }
    EXPECT_TRUE(legend().contains("×1"));
    EXPECT_TRUE(legend().contains("one fragment"));
    view.features().overlays->set(app::OverlayId::Fragments, false);
    EXPECT_EQ(canvas().content().overlays.size(), 1u);
    view.features().overlays->set(app::OverlayId::Verdict, true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return canvas().content().verdicts != nullptr; }, 10000));
    EXPECT_EQ(canvas().content().verdicts->shapes.size(), 5u);  // the pyramid's polygons
    EXPECT_TRUE(legend().contains("K kept, 3")) << legend().toStdString();
    EXPECT_TRUE(legend().contains("B back-facing, 2")) << legend().toStdString();
}

TEST_F(BufferViewTest, EdgeFunctionsAreThoseOfThePickedPixelsTriangle) {
    show({BufferId::Color});
    view.features().overlays->set(app::OverlayId::EdgeFunctions, true);
    EXPECT_FALSE(canvas().content().edgeView);
    document.pointing().pick(glm::ivec2(kOnPolygon2.x(), kOnPolygon2.y()));
    ASSERT_TRUE(canvas().content().edgeView);
    EXPECT_EQ(canvas().content().edgeView->polygon, 2u);
    document.pointing().pick(glm::ivec2(kBackground.x(), kBackground.y()));
    EXPECT_FALSE(canvas().content().edgeView);
}

TEST_F(BufferViewTest, WhatStandsOnPolygonsHasNoOverlays) {
    EXPECT_FALSE(app::whyNoOverlays(pipeline::bufferInfo(BufferId::PolygonsNormal)).isEmpty());
    EXPECT_FALSE(app::whyNoOverlays(pipeline::bufferInfo(BufferId::ShadowBuffer)).isEmpty());
    EXPECT_TRUE(app::whyNoOverlays(pipeline::bufferInfo(BufferId::ZView)).isEmpty());
}

TEST_F(BufferViewTest, TheAxisOfTheCountsIsKeptPerBuffer) {
    QTest::keyClick(&view, Qt::Key_L, Qt::ShiftModifier);
    EXPECT_FALSE(view.state().logCounts);
    EXPECT_FALSE(view.findChild<QPushButton*>("logCounts")->isChecked());
    show({BufferId::NDotL, 0});
    EXPECT_TRUE(view.state().logCounts) << "another buffer has its own";
    show({BufferId::ZView});
    EXPECT_FALSE(view.state().logCounts);
}

TEST_F(BufferViewTest, FlipAndRegionAreKeptInItsState) {
    view.features().flip->set(true);
    view.features().region->set(app::Region{{200, 300}, {260, 290}});
    const lessons::BufferShown state = view.state();
    EXPECT_TRUE(state.flipped);
    EXPECT_EQ(state.region, (std::array<int, 4>{200, 290, 260, 300}));
    view.features().flip->set(false);
    view.features().region->set({});
    EXPECT_TRUE(view.lookAt(state).empty());
    EXPECT_EQ(view.state(), state);
    EXPECT_TRUE(canvas().placing().isFlipped());
}

// Played by polygons from the beginning: at the moment that the search finds, and no further; played on, past it.
TEST_F(BufferViewTest, PlayStopsWhereAConditionBeginsToHold) {
    show({BufferId::Color});
    view.condition().open();
    view.condition().setText("z_view < 700");
    app::Stepper& stepper = document.stepper();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.condition().mask() && stepper.steps(); }, 10000));
    view.condition().runToStop();
    ASSERT_TRUE(QTest::qWaitFor([&] { return stepper.isInside() && stepper.isSettled(); }, 20000));
    const pipeline::Moment searched = *stepper.moment();
    stepper.leave();
    document.pointing().pick({});
    stepper.setSpeed(16);
    stepper.setPlaying(true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !stepper.isPlaying(); }, 30000));
    EXPECT_EQ(*stepper.moment(), searched);
    ASSERT_TRUE(document.pointing().pixel());
    ASSERT_TRUE(QTest::qWaitFor([&] { return stepper.isSettled() && !document.frames().busy(); }, 10000));
    stepper.setPlaying(true);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !stepper.isInside() || *stepper.moment() > searched; }, 30000));
    stepper.leave();
    view.condition().close();
    stepper.setPlaying(true);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !stepper.isPlaying() && !stepper.isInside(); }, 30000))
        << "without a condition to the end";
}

TEST_F(BufferViewTest, AConditionVeilsThePixelsForWhichItDoesNotHold) {
    show({BufferId::Color});
    view.condition().open();
    view.condition().setText("z_view < 700");
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.condition().mask() != nullptr; }, 10000));
    const auto z = *document.frames().shown()->buffer({BufferId::ZView});
    std::size_t near = 0;
    for (std::size_t i = 0; i < z.count(); ++i) near += z.flat(i) < 700;
    EXPECT_EQ(view.condition().mask()->count, near);
    EXPECT_GT(near, 0u);
    ASSERT_EQ(canvas().content().overlays.size(), 1u);
    EXPECT_NE(qAlpha(canvas().content().overlays[0].pixel(kBackground)), 0);
    view.condition().goTo(true);
    ASSERT_TRUE(document.pointing().pixel());
    EXPECT_LT(z.value(std::size_t(document.pointing().pixel()->x), std::size_t(document.pointing().pixel()->y)), 700);
    EXPECT_EQ(
        qAlpha(canvas().content().overlays[0].pixel(document.pointing().pixel()->x, document.pointing().pixel()->y)),
        0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document.stepper().steps() != nullptr; }, 10000));
    view.condition().runToStop();
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return document.stepper().isInside() && document.stepper().isSettled(); }, 20000));
    EXPECT_EQ(document.stepper().moment()->stage, pipeline::StageId::ZBuffer);
    document.stepper().leave();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !view.condition().busy(); }, 10000));
    view.condition().setText("z_vew < 700");
    EXPECT_EQ(view.condition().said(), "Column 1: no buffer \"z_vew\"; the nearest is \"z_view\"");
    EXPECT_TRUE(canvas().content().overlays.empty());
    view.condition().setText("z_view > 0");
    view.condition().close();
    EXPECT_TRUE(canvas().content().overlays.empty());
}
