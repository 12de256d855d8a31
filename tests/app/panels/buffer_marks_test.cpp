#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/buffer_view/buffer_copies.h"
#include "app/buffer_view/buffer_flip.h"
#include "app/buffer_view/buffer_loupe.h"
#include "app/buffer_view/buffer_overlays.h"
#include "app/buffer_view/buffer_region.h"
#include "app/buffer_view/buffer_view.h"
#include "app/buffer_view/region_panel.h"
#include "app/canvas/buffer_canvas.h"
#include "app/canvas/canvas_flip.h"
#include "app/canvas/loupe.h"
#include "app/frames/pinned_pixels.h"
#include "app/frames/region_statistics.h"
#include "tests/support/scenes.h"

// Pinned pixels, the statistics of a region, and a picture that is turned over.
namespace {

using app::BufferCanvas;
using app::BufferView;
using app::Document;
using app::PinnedPixels;
using app::Region;
using pipeline::BufferId;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

// 4 × 2 numbers: −1 2 2 nan / 5 ∞ 2 −∞
pipeline::AnyBuffer numbers() {
    auto data =
        std::make_shared<std::vector<double>>(std::vector{-1.0, 2.0, 2.0, kNan, 5.0, kInfinity, 2.0, -kInfinity});
    return {{BufferId::ZView}, &pipeline::bufferInfo(BufferId::ZView), {2, 4}, std::span<const double>(*data), data};
}

struct BufferMarksTest : testing::Test {
    Document document;
    BufferView view{document}, other{document};

    BufferMarksTest() {
        for (BufferView* v : {&view, &other}) {
            v->resize(640, 560);
            v->show();
        }
        document.setScene(test::pyramid());
        view.setBuffer({BufferId::ZView});
        EXPECT_TRUE(QTest::qWaitFor(
            [&] {
                return !document.frames().busy() && view.shown() && view.shown()->buffer.name == view.buffer() &&
                       other.shown();
            },
            10000));
    }
    QPoint widgetAt(QPoint pixel) {
        const BufferCanvas& canvas = *view.canvas();
        return canvas.placing()
            .placement()
            .toWidget(canvas.placing().toShown(QPointF(pixel) + QPointF(0.5, 0.5)))
            .toPoint();
    }
};

constexpr glm::ivec2 kOnPolygon2{268, 281};

}  // namespace

// In every corner of the view, and while the picture is moved under the label.
TEST_F(BufferMarksTest, TheValueOfAPixelDoesNotCoverIt) {
    BufferCanvas& canvas = *view.canvas();
    canvas.placing().setZoom(8);
    const auto label = [this]() -> QRect {
        for (const QLabel* found : view.canvas()->findChildren<QLabel*>())
            if (found->isVisible() && found->text().startsWith("x ")) return found->geometry();
        return {};
    };
    for (const QPoint at : {QPoint(20, canvas.height() - 20), QPoint(60, canvas.height() - 12), QPoint(20, 10),
                            QPoint(canvas.width() - 12, canvas.height() - 12), QPoint(300, 250)}) {
        const auto pixel = canvas.placing().pixelAt(at);
        ASSERT_TRUE(pixel);
        document.pointing().hover(glm::ivec2(pixel->x(), pixel->y()));
        ASSERT_FALSE(label().isEmpty());
        EXPECT_FALSE(label().intersects(QRect(widgetAt(*pixel) - QPoint(4, 4), QSize(8, 8))))
            << at.x() << ' ' << at.y();
        EXPECT_TRUE(canvas.rect().contains(label()));
    }
    const auto middle = canvas.placing().pixelAt(QPoint(300, 250));
    const QPoint by = label().center() - widgetAt(*middle);
    canvas.placing().drag(canvas.placing().placement().origin + by);
    EXPECT_FALSE(label().intersects(QRect(widgetAt(*middle) - QPoint(4, 4), QSize(8, 8))));
}

// The pyramid in the lower left corner of the view: the value is in the other one.
TEST_F(BufferMarksTest, TheValueOfAPixelLeavesWhatIsDrawnInSight) {
    BufferCanvas& canvas = *view.canvas();
    canvas.placing().setZoom(2);
    const QRectF drawn = canvas.placing().focusInView();
    ASSERT_FALSE(drawn.isEmpty());
    ASSERT_LT(drawn.width(), canvas.width() / 2);
    const QPointF by = QPointF(0, canvas.height()) - drawn.bottomLeft();
    canvas.placing().drag(canvas.placing().placement().origin + by);
    document.pointing().pick(kOnPolygon2);
    const auto labels = canvas.findChildren<QLabel*>();
    const auto label = std::ranges::find_if(
        labels, [](const QLabel* one) { return one->isVisible() && one->text().startsWith("x "); });
    ASSERT_NE(label, labels.end());
    EXPECT_FALSE(canvas.placing().focusInView().intersects((*label)->geometry()));
    EXPECT_TRUE(canvas.rect().contains((*label)->geometry()));
}

// The checker, the label, a screen reader and a copied value agree: S is stored as 1 where nothing was drawn.
TEST_F(BufferMarksTest, WhereNothingWasDrawnThereIsNoValue) {
    constexpr QPoint kBackground{5, 5};
    const auto show = [this](const pipeline::BufferName& name) {
        view.setBuffer(name);
        return QTest::qWaitFor(
            [&] { return !document.frames().busy() && view.shown() && view.shown()->buffer.name == name; }, 10000);
    };
    ASSERT_TRUE(show({BufferId::Shadow, 0}));
    document.pointing().pick(glm::ivec2(5, 5));
    ASSERT_EQ(qAlpha(view.canvas()->content().image.pixel(kBackground)), 0);
    const auto says = [this](const QString& words) {
        const auto labels = view.findChildren<QLabel*>();
        return view.canvas()->accessibleDescription().startsWith(words + ". ") &&
               std::ranges::any_of(labels, [&](const QLabel* label) { return label->text() == words; });
    };
    EXPECT_TRUE(says("x 5 y 5 → nothing drawn (cleared to 1.0000)"));
    view.features().copies->copyValue();
    EXPECT_EQ(QApplication::clipboard()->text(), "shadow.0 at 5, 5: nothing drawn (cleared to 1)");
    document.pointing().pick(glm::ivec2(268, 281));
    EXPECT_TRUE(says("x 268 y 281 → 1.0000"));
    ASSERT_TRUE(show({BufferId::Color}));
    document.pointing().pick(glm::ivec2(5, 5));
    EXPECT_TRUE(says("x 5 y 5 → 0 0 0")) << "the frame buffer's ground is a colour";
}

// Of −1, 2, 2, 5, 2: the mean is 2, the squares 9 + 0 + 0 + 9 + 0 over 5 make a variance of 3.6.
TEST(RegionStatistics, CountsWhatIsThere) {
    const auto all = app::regionStatistics(numbers(), {{3, 1}, {0, 0}}, 0);
    EXPECT_EQ(all.count, 8u);
    EXPECT_EQ(all.finite, 5u);
    EXPECT_EQ(all.nan, 1u);
    EXPECT_EQ(all.infinite, 2u);
    EXPECT_EQ(all.negative, 2u) << "−1 and −∞";
    EXPECT_EQ(all.min, -1);
    EXPECT_EQ(all.max, 5);
    EXPECT_DOUBLE_EQ(*all.mean, 2);
    EXPECT_DOUBLE_EQ(*all.deviation, std::sqrt(3.6));
    EXPECT_EQ(all.distinct, 3u);
    const auto one = app::regionStatistics(numbers(), {{2, 1}, {2, 1}}, 0);
    EXPECT_EQ(one.count, 1u);
    EXPECT_EQ(one.deviation, 0);
    const auto none = app::regionStatistics(numbers(), {{3, 0}, {3, 0}}, 0);
    EXPECT_FALSE(none.mean || none.min || none.distinct) << "a NaN has no mean";
    EXPECT_EQ(app::regionStatistics(numbers(), {{-5, -5}, {0, 0}}, 0).count, 1u) << "only what lies in the buffer";
}

TEST(RegionStatistics, AreWrittenWithTheWindowsMinus) {
    EXPECT_TRUE(app::regionText(numbers(), {{3, 1}, {0, 0}}, lessons::ShownChannel::All, {}).contains("minimum\t−1\n"));
}

// A mean of squares less the square of the mean would lose this spread of 1 in 10^9 altogether in float.
TEST(RegionStatistics, AreStableFarFromZero) {
    auto data = std::make_shared<std::vector<double>>();
    for (int i = 0; i < 1000; ++i) data->push_back(1e9 + i % 2);
    const pipeline::AnyBuffer buffer{
        {BufferId::ZView}, &pipeline::bufferInfo(BufferId::ZView), {1, 1000}, std::span<const double>(*data), data};
    EXPECT_NEAR(*app::regionStatistics(buffer, {{0, 0}, {999, 0}}, 0).deviation, 0.5, 1e-9);
}

TEST_F(BufferMarksTest, PinsTakeTheLeastFreeNumber) {
    PinnedPixels& pins = document.pointing().pins();
    for (int i = 0; i < 9; ++i) EXPECT_TRUE(pins.toggle({i, 0}));
    EXPECT_FALSE(pins.toggle({20, 20})) << "nine are all";
    EXPECT_TRUE(pins.toggle({4, 0})) << "and a pinned one lets go";
    EXPECT_FALSE(pins.pin(5));
    EXPECT_TRUE(pins.toggle({20, 20}));
    EXPECT_EQ(pins.pin(5), glm::ivec2(20, 20));
    const auto width = findSetting(document.scene(), "width");
    ASSERT_TRUE(width);
    document.change(*width, 16);
    EXPECT_FALSE(pins.pin(5)) << "the picture has become smaller";
    document.history().stack()->undo();
    EXPECT_TRUE(pins.pin(5));
    document.setScene(test::pyramid());
    EXPECT_FALSE(pins.any()) << "another scene";
}

TEST_F(BufferMarksTest, EveryViewShowsThePinsAndItsOwnValues) {
    document.pointing().pick(kOnPolygon2);
    QTest::keyClick(&view, Qt::Key_P);
    for (BufferView* v : {&view, &other}) {
        ASSERT_EQ(v->canvas()->content().pinned.size(), 1u);
        EXPECT_EQ(v->canvas()->content().pinned[0], (std::pair{1, QPoint(268, 281)}));
    }
    const auto table = [](BufferView& v) {
        for (const QLabel* label : v.findChildren<QLabel*>())
            if (label->accessibleName() == "Pinned pixels") return label->text();
        return QString();
    };
    // z_view of the picked pixel differs from its colour, 37 93 167.
    EXPECT_TRUE(table(view).startsWith("1  x 268 y 281 → 6")) << table(view).toStdString();
    EXPECT_EQ(table(other), "1  x 268 y 281 → 37 93 167");
    document.pointing().pick(glm::ivec2{1, 1});
    QTest::keyClick(&view, Qt::Key_1);
    EXPECT_EQ(document.pointing().pixel(), kOnPolygon2);
    QTest::keyClick(&view, Qt::Key_P, Qt::ShiftModifier);
    EXPECT_TRUE(other.canvas()->content().pinned.empty());
}

TEST_F(BufferMarksTest, ADraggedRegionTellsItsStatistics) {
    BufferCanvas& canvas = *view.canvas();
    const QPoint from = widgetAt({260, 276}), to = widgetAt({269, 280});
    QTest::mousePress(&canvas, Qt::RightButton, {}, from);
    QTest::mouseMove(&canvas, to);
    QTest::mouseRelease(&canvas, Qt::RightButton, {}, to);
    const auto* panel = view.findChild<app::RegionPanel*>();
    ASSERT_TRUE(panel->isVisibleTo(&view));
    EXPECT_EQ(canvas.content().region, QRect(QPoint(260, 276), QPoint(269, 280)));
    EXPECT_TRUE(panel->text().contains("10 × 5 from 260, 276")) << panel->text().toStdString();
    EXPECT_FALSE(document.pointing().pixel()) << "it picks nothing";
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_FALSE(panel->isVisibleTo(&view));
    EXPECT_FALSE(canvas.content().region);
}

// 1200 × 1000 pixels, more than are looked at in one go: what stands there stays until the new numbers come.
TEST_F(BufferMarksTest, TheStatisticsOfALargeRegionComeLater) {
    pipeline::Scene scene = document.scene();
    scene.settings.width = 1200, scene.settings.height = 1000;
    document.replace(scene, "size");
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.shown() && view.shown()->buffer.columns() == 1200; }, 10000));
    const auto* panel = view.findChild<app::RegionPanel*>();
    view.features().region->set(app::Region{{0, 0}, {1199, 999}});
    EXPECT_TRUE(panel->text().isEmpty());
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel->text().contains("1200 × 1000 from 0, 0"); }, 10000));
    EXPECT_EQ(panel->text(),
              app::regionText(view.shown()->buffer, app::Region{{0, 0}, {1199, 999}}, view.shown()->look.channel, {}));
}

TEST_F(BufferMarksTest, WithoutAMouseItMeasuresBetweenTwoPins) {
    PinnedPixels& pins = document.pointing().pins();
    pins.toggle({265, 290});
    pins.toggle({260, 280});
    QTest::keyClick(&view, Qt::Key_M);
    EXPECT_EQ(view.canvas()->content().region, QRect(QPoint(260, 280), QPoint(265, 290)));
}

TEST_F(BufferMarksTest, TurnedOverThePictureKeepsItsNumbers) {
    const QImage upright = view.canvas()->content().image;
    QTest::keyClick(&view, Qt::Key_Y);
    BufferCanvas& canvas = *view.canvas();
    ASSERT_TRUE(canvas.placing().isFlipped());
    const app::CanvasContent painted = canvas.painted(canvas.content());
    EXPECT_EQ(painted.image.pixel(268, 479 - 281), upright.pixel(268, 281));
    EXPECT_EQ(painted.text(268, 479 - 281), canvas.content().text(268, 281));
    QTest::mouseClick(&canvas, Qt::LeftButton, {}, widgetAt({268, 281}));
    EXPECT_EQ(document.pointing().pixel(), kOnPolygon2) << "a click picks the pixel that is seen";
    EXPECT_EQ(canvas.placing().pixelAt(widgetAt({268, 281})), QPoint(268, 281));
    // At 1:1 a click falls on a border between rows: it is of the row below it, as it is painted.
    canvas.placing().setZoom(1);
    for (int y = 100; y < 110; ++y) {
        const auto pixel = canvas.placing().pixelAt(QPointF(canvas.width() / 2.0, y));
        const auto next = canvas.placing().pixelAt(QPointF(canvas.width() / 2.0, y + 0.5));
        ASSERT_TRUE(pixel && next);
        EXPECT_EQ(*pixel, *next) << y;
    }
    canvas.placing().fit(false);
    QTest::keyClick(&canvas, Qt::Key_Up);
    EXPECT_EQ(document.pointing().pixel(), glm::ivec2(268, 282)) << "up on the screen is the next row";
    const app::CanvasContent twice = app::upsideDown(app::upsideDown(canvas.content()));
    EXPECT_EQ(twice.image, canvas.content().image);
    const QRectF part(200, 250, 80, 60);
    EXPECT_EQ(twice.edges(part), canvas.content().edges(part));
    EXPECT_EQ(twice.focus, canvas.content().focus);
}

TEST_F(BufferMarksTest, TheLoupeEnlargesThePickedPixelAlsoTurnedOver) {
    view.features().loupe->set(true);
    document.pointing().pick(kOnPolygon2);
    auto* loupe = view.canvas()->findChild<app::Loupe*>();
    // Between the dot in the pixel's centre and the frame around it, which is 12 wide.
    const auto inside = [&] { return loupe->grab().toImage().pixelColor(loupe->rect().center() + QPoint(3, 0)); };
    const QColor expected = view.canvas()->content().image.pixelColor(kOnPolygon2.x, kOnPolygon2.y);
    EXPECT_EQ(inside(), expected);
    view.features().flip->set(true);
    EXPECT_EQ(inside(), expected);
    view.setBuffer({BufferId::Color});
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.shown()->buffer.name == view.buffer(); }, 10000));
    EXPECT_NE(inside(), expected) << "another picture";
    EXPECT_EQ(inside(), view.canvas()->content().image.pixelColor(kOnPolygon2.x, kOnPolygon2.y));
}

TEST_F(BufferMarksTest, ThePolygonUnderThePointerIsTheSameTurnedOver) {
    view.setBuffer({BufferId::PolygonsVerdict});
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.shown()->content.shapes != nullptr; }, 10000));
    const app::CanvasContent& content = view.shown()->content;
    const QPointF at(kOnPolygon2.x + 0.5, kOnPolygon2.y + 0.5);
    EXPECT_EQ(nearestPolygonAt(*content.shapes, at), 2);
    const app::CanvasContent turned = app::upsideDown(content);
    EXPECT_EQ(nearestPolygonAt(*turned.shapes, app::upsideDown(at, content.size.height())), 2);
    EXPECT_EQ(nearestPolygonAt(*content.shapes, {1, 1}), -1);
    EXPECT_EQ(content.shapes->value(2), "2") << "beside its letter";
}

// A million of them are freed at once, while the window asks for memory.
TEST_F(BufferMarksTest, APolygonInAPictureHoldsNoMemoryOfItsOwn) {
    EXPECT_TRUE(std::is_trivially_destructible_v<app::Shape>);
    EXPECT_TRUE(std::is_trivially_destructible_v<app::ShapePoint>);
}

TEST_F(BufferMarksTest, TurnedOverItFitsTheSamePart) {
    BufferCanvas& canvas = *view.canvas();
    canvas.placing().fit(true);
    view.features().flip->set(true);
    canvas.placing().toggleFit();
    const QRectF focus = canvas.content().focus;
    ASSERT_FALSE(focus.isEmpty());
    const QRectF part = canvas.placing().look().focus;  // by the rows' own numbers
    EXPECT_NEAR(part.top(), focus.top(), 1e-9);
    EXPECT_NEAR(part.bottom(), focus.bottom(), 1e-9);
}

// In a view that gets its size while it is hidden, as in a window that is about to open, the picture has its size later;
// what stands over it stays at its corners.
TEST_F(BufferMarksTest, WordsStandAtTheCornersOfAPictureThatGrewUnseen) {
    document.pointing().pick(kOnPolygon2);
    QLabel* readout = nullptr;
    for (QLabel* label : view.canvas()->findChildren<QLabel*>())
        if (label->text().startsWith("x 268")) readout = label;
    ASSERT_TRUE(readout && readout->isVisible());
    view.hide();
    view.resize(400, 300);
    view.setBare(true);
    view.resize(900, 700);
    view.show();
    QCoreApplication::processEvents();
    EXPECT_GT(view.canvas()->height(), 500);
    EXPECT_EQ(readout->geometry().bottom(), view.canvas()->height() - 9);
}

// The one that marks NaN is on from the start, and stays off once it is off.
TEST_F(BufferMarksTest, AnOverlayThatWasSwitchedOffStaysOff) {
    EXPECT_EQ(view.state().overlays, std::vector<std::string>{"strange"});
    view.features().overlays->set(app::OverlayId::Strange, false);
    view.features().overlays->set(app::OverlayId::Verdict, true);
    const auto state = view.state();
    ASSERT_EQ(state.overlays.size(), 1u);
    view.features().overlays->set(app::OverlayId::Strange, true);
    EXPECT_TRUE(view.lookAt(state).empty());
    EXPECT_EQ(view.state(), state);
}

// Turned over, the picture has no edge functions, and the menu says why; all else is there.
TEST_F(BufferMarksTest, TheMenuSaysWhatATurnedPictureLacks) {
    for (const bool isFlipped : {false, true}) {
        QMenu menu;
        app::fillOverlayMenu(menu, {}, pipeline::bufferInfo(BufferId::Color), isFlipped, [](app::OverlayId, bool) {});
        const QList<QAction*> actions = menu.actions();
        ASSERT_EQ(actions.size(), qsizetype(app::kOverlayCount));
        for (const app::OverlayInfo& overlay : app::overlayTable()) {
            const QAction* action = actions[qsizetype(index(overlay.id))];
            const bool lacks = isFlipped && overlay.id == app::OverlayId::EdgeFunctions;
            EXPECT_EQ(action->isEnabled(), !lacks) << overlay.name;
            EXPECT_EQ(action->toolTip().contains("row 0 on top"), lacks) << action->toolTip().toStdString();
        }
    }
}

TEST_F(BufferMarksTest, NothingDrawnIsSaidOverAColouredGroundToo) {
    const auto says = [this](const char* words) {
        return QTest::qWaitFor(
            [&] { return !document.frames().busy() && view.shown() && view.shown()->empty == words; }, 10000);
    };
    auto scene = test::pyramid();
    // A flat triangle in the plane z = 0 that is clockwise from above, where the eye is.
    scene.objects[0].mesh = test::mesh({{0, 0, 0}, {0, 100, 0}, {100, 0, 0}}, {{0, 1, 2}});
    document.setScene(scene);
    // The eye stands at θ = 45°, φ = 60°: opposite to it, at θ = -135°, φ = 120°, the front is seen.
    const char* away =
        "Nothing was drawn: the only polygon faces away from the eye, and back faces are left out. Set cull=none, or "
        "look "
        "from the other side: camera.theta=-135 camera.phi=120.";
    EXPECT_TRUE(says(away));
    view.setBuffer({BufferId::Color});
    EXPECT_TRUE(says(away));
    scene.objects.clear();
    document.setScene(scene);
    EXPECT_TRUE(says("Nothing was drawn: the scene has no polygons."));
    document.setScene(test::pyramid());
    EXPECT_TRUE(says(""));
}
