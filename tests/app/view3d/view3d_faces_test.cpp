#include <QToolButton>

#include "tests/app/view3d/shown_view3d.h"

using View3dFaces = ShownView3d;

TEST_F(View3dFaces, KeysGoFromFaceToFaceOfAPointLight) {
    pipeline::Scene scene = test::pyramid();
    pipeline::Object floor;
    floor.name = "floor";
    floor.mesh = pipeline::makeShape({.kind = pipeline::ShapeKind::Plane});
    floor.transform.scale = app::Vec3d(600.0);
    floor.transform.translation = {335, 75, -20};
    scene.objects.push_back(floor);
    scene.lights[0].kind = pipeline::LightKind::Point;
    scene.lights[0].position = {300, 0, 900};
    QSignalSpy ready(&document.frames(), &app::FrameFeed::frameReady);
    document.setScene(scene);
    ASSERT_TRUE(ready.wait());
    auto* face = panel.findChild<QToolButton*>("face");
    EXPECT_TRUE(face->isHidden()) << "the world has no faces";
    panel.setSpace({app::ViewSpace::Light});
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.space().id().space == app::ViewSpace::Light; }, 10000));
    EXPECT_EQ(face->text(), "face −z") << "the one that sees the most";
    QTest::keyClick(&view, Qt::Key_F);
    EXPECT_EQ(face->text(), "face +x");
    EXPECT_EQ(panel.state().space, "light 0 +x");
    QTest::keyClick(&view, Qt::Key_F, Qt::ShiftModifier);
    QTest::keyClick(&view, Qt::Key_F, Qt::ShiftModifier);
    EXPECT_EQ(face->text(), "face +z");
    lessons::SpaceShown state;
    state.space = "light 0 -y";
    EXPECT_TRUE(panel.lookAt(state).empty());
    EXPECT_EQ(face->text(), "face −y");
    state.space = "light 0 -w";
    EXPECT_FALSE(panel.lookAt(state).empty());
}

// Another view shows the shadow buffer, so that the frame that is there has it, and no other frame comes.
TEST_F(View3dFaces, TheLightsSpaceComesWithoutANewFrame) {
    QObject other;
    document.frames().want(&other, pipeline::setOf({pipeline::BufferId::ShadowBuffer}));
    QSignalSpy ready(&document.frames(), &app::FrameFeed::frameReady);
    document.setScene(test::boxOverGround());
    ASSERT_TRUE(QTest::qWaitFor([&] { return ready.count() > 0 && !document.frames().busy(); }, 10000));
    panel.setSpace({app::ViewSpace::Light});
    EXPECT_EQ(view.space().id().space, app::ViewSpace::Light);
}
