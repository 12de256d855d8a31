#include <QGuiApplication>
#include <QImage>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/drawing3d/overlay.h"
#include "app/look/theme.h"
#include "app/view3d/view_corner.h"
#include "tests/app/view3d/shown_view3d.h"
#include "tests/app/view3d/view3d_fixture.h"

// The real panel, shown, clicked and looked at. Needs a display with OpenGL; without one a single
// test checks what the panel says instead.
namespace {

using app::Document;
using app::SceneView;
using app::Theme;
using app::ThemeId;
using app::Vec3d;
using app::View3dPanel;
using view3d::kRightFace;

class View3dWindow : public ShownView3d {
protected:
    // The display tells of a pointer without a button when it likes; once it is pressed that would end the drag.
    void hover(QPoint at, const char* handle) {
        QTest::mouseMove(&view, at);
        ASSERT_TRUE(QTest::qWaitFor([&] { return view.handles().numbers().startsWith(handle); }, 5000)) << handle;
    }
    void TearDown() override { Theme::current().set(ThemeId::Light); }

    QImage picture() {
        EXPECT_TRUE(waitUntilDrawn());
        return panel.grab().toImage();
    }
    // Once frames and flights have come to their end: two in turn are alike. Null where that never comes.
    QImage settledPicture() {
        QImage last;
        const auto isSettled = [&] { return std::exchange(last, picture()) == last && !document.frames().busy(); };
        return QTest::qWaitFor(isSettled, 10000) ? last : QImage();
    }
    // Where a point of the world stands in the panel.
    QPoint at(Vec3d point) {
        const app::ViewFrame frame = view.viewFrame();
        const glm::dvec2 p = app::project(frame.camera, frame.size, point).at;
        return view.mapTo(&panel, QPoint(int(p.x), int(p.y)));
    }
    void clickAt(Vec3d point, Qt::MouseButton button = Qt::LeftButton) {
        QTest::mouseClick(&view, button, {}, view.mapFrom(&panel, at(point)));
    }
    static bool isNear(QRgb a, QColor b, int tolerance = 3) {
        return std::abs(qRed(a) - b.red()) <= tolerance && std::abs(qGreen(a) - b.green()) <= tolerance &&
               std::abs(qBlue(a) - b.blue()) <= tolerance;
    }
    int countNear(const QImage& image, QPoint middle, int radius, QColor color) {
        int count = 0;
        for (int y = middle.y() - radius; y <= middle.y() + radius; ++y)
            for (int x = middle.x() - radius; x <= middle.x() + radius; ++x)
                if (image.valid(x, y) && isNear(image.pixel(x, y), color)) ++count;
        return count;
    }
};

}  // namespace

TEST_F(View3dWindow, SaysWhatToDoWithoutAScene) {
    bool found = false;
    for (const QLabel* label : view.findChildren<QLabel*>())
        found |= label->isVisible() && label->text() == "No scene yet. Open a file, or begin with the pyramid.";
    EXPECT_TRUE(found);
}

TEST_F(View3dWindow, ShowsTheSceneInTheFrameBuffersColours) {
    openPyramid();
    // Below the middle of polygon 2, beside its normal's arrow.
    EXPECT_GT(countNear(picture(), at({335, 137.5, 25}), 3, QColor(37, 93, 167)), 40);
}

TEST_F(View3dWindow, APickedPixelBringsItsVectors) {
    openPyramid();
    document.pointing().pick(kRightFace);
    const QImage image = picture();
    int letters = 0;
    for (const app::Label& label : view.drawing().labels) {
        if (label.kind != app::Label::Kind::Letter) continue;
        ++letters;
        EXPECT_GT(countNear(image, at(label.at), 9, app::colorOf(label.ink, Theme::current().colors())), 8)
            << label.text;
    }
    EXPECT_EQ(letters, 5);
    document.pointing().pick(glm::ivec2{1, 1});  // background
    EXPECT_TRUE(view.drawing().vectors.empty());
}

TEST_F(View3dWindow, ThemesSwitchLive) {
    openPyramid();
    for (const ThemeId id : {ThemeId::Dark, ThemeId::Light}) {
        Theme::current().set(id);
        const QImage image = picture();
        EXPECT_TRUE(isNear(image.pixel(12, image.height() / 3), Theme::colors(id).view, 6));
    }
}

TEST_F(View3dWindow, AClickPicksThePixelThatShowsThePoint) {
    openPyramid();
    clickAt({335, 125, 50}, Qt::RightButton);
    ASSERT_TRUE(document.pointing().pixel());
    // Where lecture 1's camera puts that point: 320 + 200 · (−210 sin 45°) / z_v and 240 − 200 y_v / z_v with
    // z_v = 1000 − 460 sin 60° cos 45° − 25 = 693.31, y_v = −460 cos 60° cos 45° + 50 sin 60° = −119.33.
    EXPECT_NEAR(document.pointing().pixel()->x, 277.2, 1.5);
    EXPECT_NEAR(document.pointing().pixel()->y, 274.4, 1.5);
}

TEST_F(View3dWindow, AClickOnWhatTheEyeDoesNotSeeSaysWhy) {
    openPyramid();
    view.camera().go(app::ViewPreset::Front);  // polygon 0 faces this way, away from the eye
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.camera().now().forward == Vec3d(0, 1, 0); }, 5000));
    QSignalSpy said(&document, &Document::said);
    clickAt({335, 25, 50});
    EXPECT_FALSE(document.pointing().pixel());
    ASSERT_EQ(said.count(), 1);
    EXPECT_TRUE(said[0][0].toString().contains("polygon 0"));
}

TEST_F(View3dWindow, DraggingOrbitsAndPicksNothing) {
    openPyramid();
    const app::OrbitCamera before = view.camera().now();
    const QPoint middle = view.rect().center();
    QTest::mousePress(&view, Qt::LeftButton, {}, middle);
    QTest::mouseMove(&view, middle + QPoint(40, 10));
    QTest::mouseMove(&view, middle + QPoint(80, 20));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, middle + QPoint(80, 20));
    EXPECT_FALSE(document.pointing().pixel());
    EXPECT_GT(glm::length(view.camera().now().forward - before.forward), 0.1);
    EXPECT_EQ(view.camera().now().target, before.target);
}

TEST_F(View3dWindow, KeysGoToNamedViewsAndNothingElseListens) {
    openPyramid();
    const auto goesTo = [&](Qt::Key key, Vec3d forward) {
        QTest::keyClick(&view, key);
        return QTest::qWaitFor([&] { return glm::length(view.camera().now().forward - forward) < 1e-9; }, 5000);
    };
    EXPECT_TRUE(goesTo(Qt::Key_7, {0, 0, -1}));
    EXPECT_TRUE(goesTo(Qt::Key_3, {-1, 0, 0}));
    QTest::keyClick(&view, Qt::Key_5);
    EXPECT_TRUE(view.camera().now().orthographic);
    EXPECT_TRUE(panel.findChild<QToolButton*>("orthographic")->isChecked());
    QTest::keyClick(&view, Qt::Key_5);
    EXPECT_TRUE(goesTo(Qt::Key_1, {0, 1, 0}));
    // VTK would act on these.
    const QImage before = settledPicture();
    ASSERT_FALSE(before.isNull());
    for (const Qt::Key key : {Qt::Key_W, Qt::Key_E, Qt::Key_Q, Qt::Key_F}) QTest::keyClick(&view, key);
    EXPECT_EQ(settledPicture(), before);
}

// Letters that grow make the legend higher: two rows of 64 pixels at twice their size.
TEST_F(View3dWindow, TheSceneStandsAboveTheLegend) {
    panel.resize(620, 800);
    openPyramid();
    const auto* legend = view.findChild<app::ViewCorner*>("legend");
    for (const double scale : {1.0, 2.0}) {
        Theme::current().setScale(scale);
        ASSERT_TRUE(legend->isVisible());
        for (const app::Vec3d& corner : view.space().shown()->bounds.corners())
            EXPECT_LE(project(view.camera().now(), view.viewFrame().size, corner).at.y, legend->y()) << scale;
    }
    Theme::current().setScale(1);
}

TEST_F(View3dWindow, TheLegendHidesAVector) {
    openPyramid();
    document.pointing().pick(kRightFace);
    ASSERT_EQ(view.drawing().vectors.size(), 5u);
    app::ViewOptions options = view.options();
    options.shown[std::size_t(app::VectorCode::R)] = false;
    view.setOptions(options);
    EXPECT_EQ(view.drawing().vectors.size(), 4u);
    panel.findChild<QToolButton*>("vectors")->click();
    EXPECT_TRUE(view.drawing().vectors.empty());

    auto* legend = view.findChild<app::ViewCorner*>("legend");
    const QPoint onN = app::legendEntry(app::VectorCode::N, legend->rect()).center().toPoint();
    QTest::mouseMove(legend, onN);
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.drawing().vectors.size() == 1; }, 20000)) << "N alone while hovered";
    QTest::mouseClick(legend, Qt::LeftButton, {}, onN);
    EXPECT_TRUE(view.options().vectors);
}

TEST_F(View3dWindow, AtThePointTheDiscIsThePolygonsColour) {
    openPyramid();
    panel.setSpace({app::ViewSpace::Point});
    EXPECT_TRUE(view.drawing().vectors.empty());
    document.pointing().pick(kRightFace);
    ASSERT_EQ(view.drawing().vectors.size(), 5u);
    // 0.35 of (37, 93, 167) over white: 255 − 0.35 (255 − c).
    EXPECT_GT(countNear(picture(), at({-0.3, -0.3, 0}), 12, QColor(179, 198, 224)), 100);
    EXPECT_FALSE(panel.findChild<QToolButton*>("light")->isEnabled());
    panel.setSpace({app::ViewSpace::World});
    EXPECT_TRUE(panel.findChild<QToolButton*>("light")->isEnabled());
    EXPECT_GT(countNear(picture(), at({335, 137.5, 25}), 4, QColor(37, 93, 167)), 20);
}

namespace {

const app::Handle& lightHandle(const SceneView& view) { return view.handles().all().front(); }

}  // namespace

TEST_F(View3dWindow, ADraggedLightIsOneStepOfUndo) {
    openPyramid();
    document.pointing().pick(kRightFace);
    const pipeline::Scene before = document.scene();
    ASSERT_EQ(lightHandle(view).name, "light 0");
    const QPoint at = view.mapFrom(&panel, this->at(lightHandle(view).at));
    const app::OrbitCamera camera = view.camera().now();
    hover(at, "light 0: x ");
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    QSignalSpy ready(&document.frames(), &app::FrameFeed::frameReady);
    QTest::mouseMove(&view, at + QPoint(20, 5));
    EXPECT_TRUE(view.handles().isDragging());
    EXPECT_TRUE(view.handles().numbers().startsWith("light 0: x "));
    ASSERT_TRUE(ready.wait()) << "the frame follows before the button is let go";
    EXPECT_NE(document.frames().shown()->scene().lights[0].position, before.lights[0].position);
    QTest::mouseMove(&view, at + QPoint(40, 10));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at + QPoint(40, 10));
    EXPECT_EQ(document.history().stack()->count(), 1);
    EXPECT_EQ(document.history().stack()->undoText(), "move light 0");
    EXPECT_EQ(view.camera().now(), camera) << "the view does not turn with what is dragged";
    document.history().stack()->undo();
    EXPECT_EQ(document.scene(), before);
}

TEST_F(View3dWindow, EscapePutsADraggedHandleBack) {
    openPyramid();
    const pipeline::Scene before = document.scene();
    const QPoint at = view.mapFrom(&panel, this->at(lightHandle(view).at));
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    QTest::mouseMove(&view, at + QPoint(30, 0));
    EXPECT_NE(document.scene(), before);
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_EQ(document.scene(), before);
    EXPECT_EQ(document.history().stack()->count(), 0) << "as if it had never been taken hold of";
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at + QPoint(30, 0));
    EXPECT_EQ(document.scene(), before);
}

// The object's handle: M turns instead of moving, a drag around its ring is one step, Shift while it lasts is fine.
TEST_F(View3dWindow, AnObjectIsTurnedByItsRing) {
    openPyramid();
    document.pointing().pick(kRightFace);
    QTest::keyClick(&view, Qt::Key_M);
    ASSERT_EQ(view.handles().all().back().tool, app::HandleTool::Turn);
    const pipeline::Scene before = document.scene();
    // From above, over its origin.
    app::OrbitCamera camera = view.camera().now();
    app::lookAlong(camera, {0, 0, -1});
    camera.target = view.handles().all().back().at;
    view.camera().set(camera);
    const QPoint middle = view.mapFrom(&panel, at(view.handles().all().back().at));
    hover(middle, "pyramid");
    EXPECT_EQ(view.handles().numbers(), "pyramid: rotation x 0.0°  y 0.0°  z 0.0°\nM: scale it");
    QTest::mousePress(&view, Qt::LeftButton, {}, middle + QPoint(46, 0));
    ASSERT_TRUE(view.handles().isDragging());
    QTest::mouseMove(&view, middle + QPoint(33, -33));
    EXPECT_NEAR(document.scene().objects[0].transform.rotation.z, 45, 3);
    QTest::mouseMove(&view, middle + QPoint(0, -46));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, middle + QPoint(0, -46));
    EXPECT_NEAR(document.scene().objects[0].transform.rotation.z, 90, 3);
    EXPECT_EQ(document.history().stack()->count(), 1);
    EXPECT_TRUE(document.history().stack()->undoText().startsWith("turn "));
    document.history().stack()->undo();
    EXPECT_EQ(document.scene(), before);
}

TEST_F(View3dWindow, HandlesWorkInEyeSpaceToo) {
    openPyramid();
    panel.setSpace({app::ViewSpace::Eye});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !view.space().isMoving(); }, 5000));
    ASSERT_EQ(view.handles().all().front().kind, app::Handle::Kind::LightDirection);
    const app::HandleView place = app::handleView(view.viewFrame(), view.space().shown()->map);
    const glm::dvec2 p = app::placeOf(place, view.handles().all().front().at).at;
    const QPoint at{int(p.x), int(p.y)};
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    EXPECT_TRUE(view.handles().isDragging());
    QTest::mouseMove(&view, at + QPoint(20, 5));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at + QPoint(20, 5));
    EXPECT_EQ(document.history().stack()->undoText(), "move light 0");
    panel.setSpace({app::ViewSpace::Point});
    EXPECT_TRUE(view.handles().all().empty());
}

TEST_F(View3dWindow, KeysGoFromSpaceToSpace) {
    openPyramid();
    const auto comesTo = [&](app::ViewSpace space) {
        QTest::keyClick(&view, Qt::Key_S);
        return QTest::qWaitFor([&] { return view.space().id().space == space && !view.space().isMoving(); }, 5000);
    };
    EXPECT_TRUE(comesTo(app::ViewSpace::Eye));
    EXPECT_TRUE(comesTo(app::ViewSpace::Clip));
    EXPECT_FALSE(panel.findChild<QToolButton*>("normals")->isEnabled());
    EXPECT_TRUE(comesTo(app::ViewSpace::Screen));
    EXPECT_TRUE(comesTo(app::ViewSpace::Point)) << "the pyramid's light has no shadow buffer";
    EXPECT_TRUE(comesTo(app::ViewSpace::World));
    QTest::keyClick(&view, Qt::Key_S, Qt::ShiftModifier);
    EXPECT_EQ(view.space().id().space, app::ViewSpace::Point);
}

TEST_F(View3dWindow, AClickPicksInEverySpace) {
    openPyramid();
    for (const app::ViewSpace space : {app::ViewSpace::Eye, app::ViewSpace::Clip, app::ViewSpace::Screen}) {
        document.pointing().pick({});
        panel.setSpace({space});
        ASSERT_TRUE(QTest::qWaitFor([&] { return !view.space().isMoving(); }, 5000));
        view.camera().go(app::ViewPreset::Eye);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !view.camera().isFlying() && view.isDrawn(); }));
        const auto map = app::mapOf(*view.space().content(), {space});
        clickAt(map->toSpace({335, 125, 50}));
        ASSERT_TRUE(document.pointing().pixel()) << int(space);
        EXPECT_NEAR(document.pointing().pixel()->x, 277.2, 1.5);
        EXPECT_NEAR(document.pointing().pixel()->y, 274.4, 1.5);
    }
}

TEST_F(View3dWindow, EveryControlHasANameAndATip) {
    for (const QToolButton* button : panel.findChildren<QToolButton*>()) {
        EXPECT_FALSE(button->accessibleName().isEmpty());
        EXPECT_FALSE(button->toolTip().isEmpty());
    }
}

TEST_F(View3dWindow, WantsNoMoreThanTheShadingLeaves) {
    openPyramid();
    EXPECT_FALSE(document.frames().shown()->buffer({pipeline::BufferId::VerticesNormal})) << "flat shading leaves none";
    app::ViewOptions options = view.options();
    options.normals = app::NormalsShown::Vertices;
    QSignalSpy ready(&document.frames(), &app::FrameFeed::frameReady);
    panel.changeOptions(options);
    ASSERT_TRUE(ready.wait());
    EXPECT_EQ(view.space().content()->mesh->vertexNormals.size(), 5u);
}

TEST_F(View3dWindow, AfterADragItShowsTheSameAsAViewThatHasSeenNothingElse) {
    openPyramid();
    const auto theta = *findSetting(document.scene(), "camera.theta");
    const double begin = theta.get(document.scene());
    for (int i = 1; i <= 6; ++i) {
        document.change(theta, begin + 5 * i, i < 6 ? Document::Change::Live : Document::Change::Done);
        QTest::qWait(10);
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy(); }));
    View3dPanel other(document);
    other.resize(panel.size());
    other.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&other));
    const auto areDrawn = [&] { return other.view().space().content() && view.isDrawn() && other.view().isDrawn(); };
    ASSERT_TRUE(QTest::qWaitFor(areDrawn, 20000));
    const QImage dragged = view.grab().toImage(), fresh = other.view().grab().toImage();
    ASSERT_EQ(dragged.size(), fresh.size());
    qint64 differ = 0;
    for (int y = 0; y < fresh.height(); ++y)
        for (int x = 0; x < fresh.width(); ++x) differ += !isNear(dragged.pixel(x, y), QColor(fresh.pixel(x, y)));
    EXPECT_EQ(differ, 0);
}

TEST_F(View3dWindow, SurvivesBeingMovedToAnotherWindow) {
    openPyramid();
    QWidget other;
    other.resize(500, 400);
    panel.setParent(&other);
    other.show();
    panel.setGeometry(0, 0, 500, 400);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&other));
    EXPECT_GT(countNear(picture(), at({335, 137.5, 25}), 3, QColor(37, 93, 167)), 20);
    panel.hide();
    panel.setParent(nullptr);
}

TEST(View3dWithoutOpenGl, SaysSoAndGoesOn) {
    if (app::openGlProblem().isEmpty()) GTEST_SKIP() << "this machine has OpenGL 3.2";
    Document document;
    View3dPanel panel(document);
    panel.resize(400, 300);
    panel.show();
    QSignalSpy ready(&document.frames(), &app::FrameFeed::frameReady);
    document.setScene(test::pyramid());
    ASSERT_TRUE(ready.wait());
    document.pointing().pick(kRightFace);
    EXPECT_EQ(panel.view().problem(), "This machine gives no OpenGL 3.2. Buffers still work.");
    bool found = false;
    for (const QLabel* label : panel.view().findChildren<QLabel*>())
        found |= label->isVisible() && label->text() == panel.view().problem();
    EXPECT_TRUE(found);
}
