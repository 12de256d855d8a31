#pragma once
#include <QString>

namespace app {

struct WindowStart {
    QString cues = {}, cue = {};  // a talk to present, from this cue on; its name may be empty
    QString file = {};            // empty: the last session, else the start page
    bool session = true;          // whether it is restored, and kept
};
// Opens the window and runs it until it is closed. Gives the program's exit status.
int runWindow(int argc, char** argv, const WindowStart& start);

// What must be set before the QApplication is made, and the settings' place and name.
void prepareApplication();

}  // namespace app
