// What a 3D view shows is drawn beside the window, which goes on meanwhile.
#include <mutex>

#include "app/vtk/vtk_mutex.h"
#include "tests/app/large_scene.h"
#include "tests/app/view3d/shown_view3d.h"

namespace {

using app::SceneView;

class View3dBeside : public ShownView3d {
protected:
    void SetUp() override {
        ShownView3d::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        openPyramid();
        ASSERT_TRUE(waitUntilDrawn());
    }
    void turn() {
        app::OrbitCamera camera = view.camera().now();
        app::orbit(camera, 30, 0);
        view.camera().set(camera);
    }

    const app::VtkWidget& vtk = *view.findChild<app::VtkWidget*>();
};

// Whoever has VTK's turn here keeps it from drawing, as a picture would that takes for ever.
TEST_F(View3dBeside, TheWindowDoesNotWaitForAPicture) {
    auto* working = view.findChild<QWidget*>("working");
    const auto before = vtk.shown();
    {
        const std::lock_guard turnOfVtk(app::vtkMutex());
        turn();
        document.pointing().pick(glm::ivec2{268, 281});
        ASSERT_TRUE(QTest::qWaitFor([&] { return working->isVisible(); }, 5000)) << "it says that it is at work";
        EXPECT_FALSE(view.isDrawn());
        EXPECT_EQ(vtk.shown(), before) << "letters stay at what the picture shows";
    }
    ASSERT_TRUE(waitUntilDrawn());
    EXPECT_FALSE(working->isVisible());
    EXPECT_EQ(vtk.shown()->content, view.space().content());
    EXPECT_EQ(vtk.shown()->view.camera, view.camera().now());
}

// Whoever presses Esc to leave a talk that has just begun leaves no empty view behind.
TEST_F(View3dBeside, TheFirstPictureIsNotStopped) {
    app::View3dPanel other(document);
    other.resize(400, 300);
    const auto& drawing = *other.findChild<app::VtkWidget*>();
    {
        const std::lock_guard turnOfVtk(app::vtkMutex());
        other.show();
        QTest::qWait(600);  // other work is listed by then, and cancel() stops it; a first picture is not listed
        EXPECT_FALSE(drawing.shown());
        document.work().cancel();
    }
    EXPECT_TRUE(QTest::qWaitFor([&] { return drawing.shown() != nullptr; }, 10000));
}

TEST_F(View3dBeside, OfManyChangesMeanwhileTheNewestAloneIsDrawn) {
    int drawn = 0;
    QObject::connect(&view, &SceneView::drawn, [&] { ++drawn; });
    {
        const std::lock_guard turnOfVtk(app::vtkMutex());
        for (int i = 0; i < 10; ++i) {
            turn();
            QTest::qWait(5);
        }
        drawn = 0;
    }
    ASSERT_TRUE(waitUntilDrawn());
    EXPECT_LE(drawn, 3) << "the one that had begun, the newest, and that with smooth edges";
    EXPECT_EQ(vtk.shown()->view.camera, view.camera().now());
}

// On its way to another space it shows the one before; the last one that was asked for counts, and a camera asked for
// with it is there when it is.
TEST_F(View3dBeside, TheWindowDoesNotWaitForALargeMeshToBeMoved) {
    using app::ViewSpace;
    document.setScene(test::manyPolygons());
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return view.space().content() && view.space().content()->mesh->faces.size() > 60000; }, 20000));
    const auto comesTo = [&](ViewSpace space) {
        return QTest::qWaitFor([&] { return view.space().id().space == space; }, 20000);
    };
    panel.setSpace({ViewSpace::Eye});
    EXPECT_EQ(view.space().id().space, ViewSpace::World);
    ASSERT_TRUE(comesTo(ViewSpace::Eye));
    EXPECT_EQ(view.space().shown()->world, view.space().content()->mesh);
    panel.setSpace({ViewSpace::Clip});
    panel.setSpace({ViewSpace::World});
    QTest::qWait(300);
    EXPECT_EQ(view.space().id().space, ViewSpace::World);
    lessons::SpaceShown asked;
    asked.space = "screen";
    asked.camera.emplace();
    asked.camera->distance = 77;
    EXPECT_TRUE(panel.lookAt(asked).empty());
    ASSERT_TRUE(comesTo(ViewSpace::Screen));
    EXPECT_EQ(view.camera().now().distance, 77);
}

}  // namespace

// As a driver does that gives no context beside the window. Whoever hears of it sets another view.
TEST(View3dWithoutOpenGl, IsToldOnce) {
    if (app::openGlProblem().isEmpty()) GTEST_SKIP() << "this machine has OpenGL 3.2";
    app::VtkWidget widget;
    int told = 0;
    QObject::connect(&widget, &app::VtkWidget::unusable, [&] {
        ++told;
        widget.setView({}, {});
    });
    widget.resize(100, 100);
    widget.show();
    ASSERT_TRUE(QTest::qWaitFor([&] { return told > 0; }, 5000));
    QTest::qWait(300);
    EXPECT_EQ(told, 1);
}
