#pragma once
#include <QString>

namespace app {

struct WindowStart {
    QString file = {};    // empty: the last session, else the start page
    bool session = true;  // whether it is restored, and kept
};
// Opens the window and runs it until it is closed. Gives the program's exit status.
int runWindow(int argc, char** argv, const WindowStart& start);

// What must be set before the QApplication is made, and the settings' place and name.
void prepareApplication();

}  // namespace app
