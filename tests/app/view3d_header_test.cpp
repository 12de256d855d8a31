// What the buttons over a 3D view say.
#include <QToolButton>

#include "pipeline/scene/shape.h"
#include "tests/app/shown_view3d.h"

namespace {

class View3dHeader : public ShownView3d {
protected:
    void openSphere() {
        pipeline::Scene scene = test::pyramid();
        scene.objects[0].mesh = pipeline::makeShape({.kind = pipeline::ShapeKind::Sphere});
        scene.objects[0].transform.scale = app::Vec3d(100.0);
        QSignalSpy ready(&document.frames(), &app::FrameFeed::frameReady);
        document.setScene(scene);
        ASSERT_TRUE(ready.wait());
    }
    void goTo(app::ViewSpace space) {
        panel.setSpace({space});
        ASSERT_TRUE(QTest::qWaitFor([&] { return !view.space().isMoving(); }, 5000));
    }
    const QToolButton* button(const char* name) { return panel.findChild<QToolButton*>(name); }
    QString tip(const char* name) { return button(name)->toolTip(); }
};

// Of a dense mesh not all normals are shown, which the button says, and in clip space why there are none.
TEST_F(View3dHeader, TheNormalsButtonSaysWhyItIsOffAndHowManyAreShown) {
    openSphere();
    const QString inWorld = tip("normals");
    ASSERT_TRUE(inWorld.contains(" are shown")) << inWorld.toStdString();
    goTo(app::ViewSpace::Clip);
    const QString inClip = tip("normals");
    EXPECT_TRUE(inClip.startsWith("Here lengths and angles mean nothing")) << inClip.toStdString();
    pipeline::Scene scene = document.scene();
    scene.objects[0].material.exponent = 3;
    QSignalSpy ready(&document.frames(), &app::FrameFeed::frameReady);
    document.edit(scene, "exponent", app::Document::Change::Done);
    ASSERT_TRUE(ready.wait());
    EXPECT_EQ(tip("normals"), inClip) << "after another frame too";
    goTo(app::ViewSpace::World);
    EXPECT_EQ(tip("normals"), inWorld);
}

// A screen reader reads the name, not the text.
TEST_F(View3dHeader, TheSpaceButtonsNameSaysWhichOneIsOn) {
    openPyramid();
    const QToolButton* space = nullptr;
    for (const QToolButton* each : panel.findChildren<QToolButton*>())
        if (each->text() == "World space") space = each;
    ASSERT_TRUE(space);
    EXPECT_EQ(space->accessibleName(), "Space: World space");
    goTo(app::ViewSpace::Eye);
    EXPECT_EQ(space->accessibleName(), "Space: Eye space");
}

// As a cue does: another scene, whose light has a shadow buffer, and how it is looked at before its frame is there.
TEST_F(View3dHeader, ACameraAskedForInALightsSpaceIsThereOnceTheSpaceIs) {
    openPyramid();
    pipeline::Scene scene = document.scene();
    scene.objects.push_back(scene.objects[0]);  // two: one may shadow the other
    scene.objects[1].transform.translation = {150, 0, 0};
    document.edit(scene, "another one", app::Document::Change::Done);
    lessons::SpaceShown asked;
    asked.space = "light 0";
    asked.camera.emplace();
    asked.camera->distance = 77;
    EXPECT_TRUE(panel.lookAt(asked).empty());
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.space().id().space == app::ViewSpace::Light; }, 5000));
    EXPECT_EQ(view.camera().now().distance, 77);
    EXPECT_TRUE(view.camera().isTouched());
}

}  // namespace
