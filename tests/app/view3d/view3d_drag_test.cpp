// What a drag in a 3D view begins ends with the button that began it, whatever happens meanwhile.
#include <QMouseEvent>

#include "tests/app/view3d/shown_view3d.h"

namespace {

using app::Vec3d;

class View3dDrag : public ShownView3d {
protected:
    void SetUp() override {
        ShownView3d::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        openPyramid();
    }
    QPoint lightHandle() const {
        const app::HandleView place = app::handleView(view.viewFrame(), view.space().shown()->map);
        const glm::dvec2 p = app::placeOf(place, view.handles().all().front().at).at;
        return {int(p.x), int(p.y)};
    }
    // With every button that is down, as a mouse has it.
    void send(QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons down) {
        QMouseEvent event(type, at, view.mapToGlobal(QPointF(at)), button, down, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &event);
    }
    void takeHoldAt(QPoint at) {
        send(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
        send(QEvent::MouseMove, at + QPoint(20, 5), Qt::NoButton, Qt::LeftButton);
        ASSERT_TRUE(view.handles().isDragging());
        ASSERT_NE(lightNow(), kLight);
    }
    void letGoAt(QPoint at) { send(QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton); }
    void setExponent(double exponent) {
        pipeline::Scene scene = document.scene();
        scene.objects[0].material.exponent = exponent;
        document.edit(scene, "exponent", app::Document::Change::Done);
    }
    double exponent() const { return document.scene().objects[0].material.exponent; }
    Vec3d lightNow() const { return document.scene().lights[0].position; }

    const Vec3d kLight = test::pyramid().lights[0].position;
};

TEST_F(View3dDrag, EndsWithItsOwnButtonWhateverAnotherOneDoes) {
    for (const Qt::MouseButton other : {Qt::MiddleButton, Qt::RightButton}) {
        document.history().stack()->clear();
        const QPoint at = lightHandle(), end = at + QPoint(20, 5);
        takeHoldAt(at);
        const Vec3d dragged = lightNow();
        send(QEvent::MouseButtonPress, end, other, Qt::LeftButton | other);
        send(QEvent::MouseMove, end, Qt::NoButton, Qt::LeftButton | other);
        EXPECT_EQ(lightNow(), dragged) << "it does not jump";
        send(QEvent::MouseButtonRelease, end, other, Qt::LeftButton);
        EXPECT_TRUE(view.handles().isDragging());
        letGoAt(end);
        EXPECT_FALSE(view.handles().isDragging());
        EXPECT_EQ(document.history().stack()->count(), 1);
        document.history().stack()->undo();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy(); }));
    }
}

TEST_F(View3dDrag, TheNextOneKeepsWhatWasChangedBetween) {
    const QPoint at = lightHandle(), end = at + QPoint(20, 5);
    takeHoldAt(at);
    send(QEvent::MouseButtonPress, end, Qt::MiddleButton, Qt::LeftButton | Qt::MiddleButton);
    send(QEvent::MouseButtonRelease, end, Qt::MiddleButton, Qt::LeftButton);
    letGoAt(end);
    setExponent(3);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy() && waitUntilDrawn(); }));
    takeHoldAt(lightHandle());
    EXPECT_EQ(exponent(), 3);
}

TEST_F(View3dDrag, AViewThatIsHiddenPutsItBack) {
    const pipeline::Scene before = document.scene();
    const QPoint at = lightHandle();
    takeHoldAt(at);
    panel.hide();
    EXPECT_FALSE(view.handles().isDragging());
    EXPECT_EQ(document.scene(), before);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    send(QEvent::MouseMove, at + QPoint(40, 5), Qt::NoButton, Qt::NoButton);
    EXPECT_EQ(document.scene(), before);
}

TEST_F(View3dDrag, AnotherSceneIsNotChangedByADragInTheOneBefore) {
    const QPoint at = lightHandle();
    takeHoldAt(at);
    pipeline::Scene other = test::pyramid();
    other.objects[0].material.exponent = 3;
    QSignalSpy ready(&document.frames(), &app::FrameFeed::frameReady);
    document.setScene(other);
    EXPECT_FALSE(view.handles().isDragging());
    send(QEvent::MouseMove, at + QPoint(40, 5), Qt::NoButton, Qt::LeftButton);
    letGoAt(at + QPoint(40, 5));
    EXPECT_EQ(document.scene(), other);
    ASSERT_TRUE(ready.wait());
    takeHoldAt(lightHandle());
    EXPECT_EQ(exponent(), 3);
}

// A dialog that a key has opened gets the release: what moves then holds nothing.
TEST_F(View3dDrag, EndsWhereItsReleaseWentElsewhere) {
    const pipeline::Scene before = document.scene();
    const QPoint at = lightHandle();
    takeHoldAt(at);
    send(QEvent::MouseMove, at + QPoint(60, 5), Qt::NoButton, Qt::NoButton);
    EXPECT_FALSE(view.handles().isDragging());
    EXPECT_EQ(document.scene(), before);
}

// As when its file is read again, or by undo.
TEST_F(View3dDrag, EndsWhereTheSceneChangesUnderIt) {
    const QPoint at = lightHandle();
    takeHoldAt(at);
    pipeline::Scene dark = document.scene();
    dark.lights.clear();
    document.edit(dark, "no lights", app::Document::Change::Done);
    EXPECT_FALSE(view.handles().isDragging());
    send(QEvent::MouseMove, at + QPoint(40, 5), Qt::NoButton, Qt::LeftButton);
    EXPECT_EQ(document.scene(), dark);
}

// Handles are those of the frame on show, and the scene may be ahead of it.
TEST_F(View3dDrag, AHandleOfALightThatHasGoneMovesNothing) {
    const QPoint at = lightHandle();
    pipeline::Scene dark = document.scene();
    dark.lights.clear();
    document.edit(dark, "no lights", app::Document::Change::Done);
    send(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);  // its numbers would be shown
    send(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
    send(QEvent::MouseMove, at + QPoint(20, 5), Qt::NoButton, Qt::LeftButton);
    EXPECT_EQ(document.scene(), dark);
}

// Picked by the frame that the view shows, until it shows the new one.
TEST_F(View3dDrag, ThePointerReadsThePictureThatTheViewIsOf) {
    pipeline::Scene flat = document.scene();
    flat.settings.width = 2000, flat.settings.height = 10;
    document.edit(flat, "flat", app::Document::Change::Done);
    for (int x = 40; x < view.width(); x += 40)
        for (int y = 40; y < view.height(); y += 40) send(QEvent::MouseMove, {x, y}, Qt::NoButton, Qt::NoButton);
    document.pointing().select(lessons::Selection{lessons::Selection::Kind::Polygon, 4});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy(); }));
}

// The press that follows a release which another program got.
TEST_F(View3dDrag, APressOfItsOwnButtonAgainEndsIt) {
    const QPoint at = lightHandle();
    takeHoldAt(at);
    const Vec3d dragged = lightNow();
    send(QEvent::MouseButtonPress, {5, 5}, Qt::LeftButton, Qt::LeftButton);
    EXPECT_FALSE(view.handles().isDragging());
    EXPECT_EQ(lightNow(), dragged);
    EXPECT_EQ(document.history().stack()->count(), 1);
}

}  // namespace
