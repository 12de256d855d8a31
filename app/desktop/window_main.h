#pragma once
#include <QString>

namespace app {

// Opens the window, on `file` where it is not empty, else on the start page, and runs it until it
// is closed. Gives the program's exit status.
int runWindow(int argc, char** argv, const QString& file);

// What must be set before the QApplication is made, and the settings' place and name.
void prepareApplication();

}  // namespace app
