#pragma once
#include <QMainWindow>
#include <QStringList>
#include <optional>

namespace app {

constexpr int kLayoutVersion = 2;  // of what stands in the window; another one makes old layouts void

// The places and sizes of the docks, kept per size of the screen.
void saveLayout(const QMainWindow& window);
bool restoreLayout(QMainWindow& window);  // false where there is none
void forgetLayout(const QMainWindow& window);

// Saves a window's position, size and whether it is maximised; restores them within an existing screen.
void saveWindowPlace(const QWidget& window);
bool restoreWindowPlace(QWidget& window);  // false where there is none, or none for such a screen
void takeFirstWindowPlace(QWidget& window);

// A layout that the user has named.
struct KeptLayout {
    QByteArray panels;    // QMainWindow::saveState
    QString arrangement;  // ViewArea::arrangement, with its sizes
    bool thumbnails = false;
    bool operator==(const KeptLayout&) const = default;
};
QStringList keptLayouts();                                       // their names, sorted
void keepLayout(const QString& name, const KeptLayout& layout);  // in place of one of that name; none without a name
std::optional<KeptLayout> keptLayout(const QString& name);
void dropLayout(const QString& name);

// Theme and font scales, kept for the program.
void saveTheme();
void restoreTheme();  // the desktop's light or dark at the first start

// How numbers are written, kept for the program.
void saveNumbers();
void restoreNumbers();

}  // namespace app
