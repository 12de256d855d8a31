// What the buttons over a 3D view say.
#include <QAction>
#include <QLayout>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "app/look/theme.h"
#include "app/view3d/view3d_header.h"
#include "app/view3d/view_corner.h"
#include "pipeline/scene/mesh/shape.h"
#include "tests/app/view3d/shown_view3d.h"

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

// From the least width that the window gives a view, at every size of text: a word is short or whole, never with a piece
// missing, and what has no room is in the menu.
TEST_F(View3dHeader, NoWordIsCutInANarrowView) {
    openPyramid();
    pipeline::Scene scene = document.scene();
    scene.objects.push_back(scene.objects[0]);  // two: one may shadow the other
    scene.objects[1].transform.translation = {150, 0, 0};
    scene.lights[0].kind = pipeline::LightKind::Point;
    document.edit(scene, "a point light", app::Document::Change::Done);
    QWidget host;
    app::View3dPanel narrow(document, &host);
    host.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&host));
    ASSERT_TRUE(QTest::qWaitFor([&] { return narrow.view().space().content() != nullptr; }, 20000));
    auto* header = narrow.findChild<app::View3dHeader*>();
    ASSERT_TRUE(header);
    bool wasShort = false, wasLong = false;
    for (const app::SpaceId space : {app::SpaceId{}, app::SpaceId{app::ViewSpace::Screen},
                                     app::SpaceId{app::ViewSpace::Light, 0}, app::SpaceId{app::ViewSpace::Point}}) {
        narrow.setSpace(space);
        ASSERT_TRUE(QTest::qWaitFor(
            [&] { return narrow.view().space().id().space == space.space && !narrow.view().space().isMoving(); },
            20000));
        for (const double scale : {1.0, 1.25, 1.5, 2.0}) {
            app::Theme::current().setScale(scale);
            const int least = std::max(282, int(250 * scale));
            for (int width = least; width <= least + 500; width += 20) {
                narrow.resize(width, 400);
                narrow.layout()->activate();
                header->layout()->activate();
                for (const auto* button : header->findChildren<QToolButton*>()) {
                    if (button->isHidden()) continue;
                    EXPECT_GE(button->width(), button->sizeHint().width())
                        << button->accessibleName().toStdString() << ", " << width << " wide, " << scale;
                    EXPECT_LE(button->geometry().right(), width);
                    wasShort = wasShort || button->text() == "World";
                    wasLong = wasLong || button->text() == "World space";
                }
                // What can be chosen: as a button or in the menu, never in both.
                for (const char* name : {"Lights", "Normals", "Vectors", "Orthographic"}) {
                    const auto actions = narrow.menu()->actions();
                    const auto entry = std::ranges::find(actions, QString(name), &QAction::text);
                    ASSERT_NE(entry, actions.end()) << name;
                    const auto buttons = header->findChildren<QToolButton*>();
                    const auto button = std::ranges::find(buttons, QString(name), &QToolButton::accessibleName);
                    ASSERT_NE(button, buttons.end()) << name;
                    EXPECT_EQ((*entry)->isVisible(), (*button)->isHidden()) << name << ", " << width;
                }
            }
        }
    }
    app::Theme::current().setScale(1);
    EXPECT_TRUE(wasShort && wasLong);
}

// A view too low for the legend has its lower edge for the cube; in a narrow one with a legend the cube is above it.
TEST_F(View3dHeader, TheCubeIsInTheCornerOfALowView) {
    openPyramid();
    QWidget host;
    app::View3dPanel narrow(document, &host);
    host.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&host));
    ASSERT_TRUE(QTest::qWaitFor([&] { return narrow.view().space().content() != nullptr; }, 20000));
    const auto* legend = narrow.findChild<QWidget*>("legend");
    const auto* cube = narrow.view().findChild<app::ViewCorner*>("cube");
    ASSERT_TRUE(legend && cube);
    const auto resize = [&](int height) {
        narrow.resize(500, height);
        narrow.layout()->activate();
    };
    app::Theme::current().setScale(2);
    const int margin = app::Theme::current().px(8);
    resize(400);
    EXPECT_FALSE(legend->isVisible());
    EXPECT_EQ(narrow.view().height() - cube->height() - cube->y(), margin);
    resize(1200);
    EXPECT_TRUE(legend->isVisible());
    EXPECT_EQ(legend->y() - cube->height() - cube->y(), margin);
    resize(400);
    EXPECT_EQ(narrow.view().height() - cube->height() - cube->y(), margin);
    app::Theme::current().setScale(1);
}

}  // namespace
