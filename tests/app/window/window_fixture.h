#pragma once
#include <gtest/gtest.h>

#include <QImage>
#include <QTemporaryDir>

#include "app/desktop/main_window.h"
#include "app/desktop/scene_files.h"
#include "app/desktop/shown_state.h"
#include "app/desktop/window_cues.h"
#include "app/desktop/window_lessons.h"
#include "app/docks/panel_docks.h"
#include "app/docks/window_layout.h"

namespace app {

class BufferCanvas;

// The program's window on the screen, in its light theme, with settings of its own. Tests drive it
// with the mouse and the keys, and look at the pictures that result.
class WindowTest : public testing::Test {
protected:
    WindowTest();

    Document& document() { return window.document(); }
    void openPyramid();
    // Until the newest frame is there and nothing is left to compute.
    bool waitForFrame();
    // Presses keys in the widget that has the focus: "Ctrl+Right".
    void press(const char* keys);

    // Presses a button of the question that `act` asks.
    void answer(const QString& button, const std::function<void()>& act);

    template <class Widget>
    Widget* find(const QString& name) {
        Widget* found = window.findChild<Widget*>(name);
        EXPECT_NE(found, nullptr) << "no widget is named " << name.toStdString();
        return found;
    }
    BufferCanvas* canvas();    // of the first buffer view
    QImage pictureOnScreen();  // what the first buffer view shows
    // Where the picture's pixel stands in the canvas.
    QPoint onCanvas(glm::ivec2 pixel);
    // The colour that the canvas shows for a pixel of the picture.
    QColor shownColor(const QImage& canvasPicture, glm::ivec2 pixel);
    QColor frameColor(glm::ivec2 pixel);

    QTemporaryDir folder;
    MainWindow window;
};

QString resourceScene(const char* name);  // "pyramid.scene"
// A scene of the program copied into a folder, with the pyramid's mesh: a file of the user's own.
QString ownScene(const char* name, const QString& folder);

}  // namespace app
