#pragma once
#include <QDateTime>
#include <QStringList>
#include <vector>

namespace app {

// The last opened files, newest first, stored in the program's settings.
struct RecentFile {
    QString file;        // absolute path
    QDateTime when;      // of the last opening
    QString where = {};  // "z-buffer/polygon=2 · pixel 268, 281": the window's place when it was closed, what was found
    QString state = {};  // the same as TOML: lessons/state/window_state.h; of a list of cues the cue's name, of a
                         // renderer's folder the scene that it was compared with
    QString title = {};  // of a lesson or a list of cues
};

inline constexpr int kMaxRecentFiles = 8;

std::vector<RecentFile> recentFiles();  // files that still exist
// Their names, with the folder if two names are equal.
QStringList recentNames(const std::vector<RecentFile>& files);
QString nameOf(const RecentFile& recent);  // its title, else its file's name
void addRecentFile(const QString& file, const QString& title = {});
// For a file in the list; does nothing for other files.
void rememberPlace(const QString& file, const QString& where, const QString& state);

}  // namespace app
