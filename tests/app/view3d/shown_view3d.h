#pragma once
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "app/document/document.h"
#include "app/view3d/view3d_panel.h"
#include "tests/support/scenes.h"

// The real panel of a 3D view on the screen. Needs a display with OpenGL, and is left out where there is none.
class ShownView3d : public testing::Test {
protected:
    void SetUp() override {
        if (!app::openGlProblem().isEmpty()) GTEST_SKIP() << "no OpenGL 3.2 here";
        panel.resize(640, 480);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    }
    void openPyramid() {
        QSignalSpy ready(&document.frames(), &app::FrameFeed::frameReady);
        document.setScene(test::pyramid());
        ASSERT_TRUE(ready.wait());
    }
    // Its picture is the newest.
    bool waitUntilDrawn() {
        QTest::qWait(30);
        return QTest::qWaitFor([this] { return view.isDrawn(); }, 20000);
    }

    app::Document document;
    app::View3dPanel panel{document};
    app::SceneView& view = panel.view();
};
