#pragma once
#include <QMainWindow>

namespace app {

// The places and sizes of the docks, kept per size of the screen.
void saveLayout(const QMainWindow& window);
bool restoreLayout(QMainWindow& window);  // false where there is none
void forgetLayout(const QMainWindow& window);

// Theme and font scales, kept for the program.
void saveTheme();
void restoreTheme();  // the desktop's light or dark at the first start

}  // namespace app
