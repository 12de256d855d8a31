#pragma once
#include <QDateTime>
#include <QStringList>
#include <vector>

namespace app {

// The files opened last, newest first, kept in the program's settings.
struct RecentFile {
    QString file;    // absolute path
    QDateTime when;  // opened last
    QString where =
        {};  // "z-buffer/polygon=2 · pixel 268, 281": where the window stood when it was closed; may be empty
    QString state = {};  // the same as TOML: lessons/state/window_state.h
};

inline constexpr int kMaxRecentFiles = 8;

std::vector<RecentFile> recentFiles();  // those that still exist
// Their names, with the folder where two have the same.
QStringList recentNames(const std::vector<RecentFile>& files);
void addRecentFile(const QString& file);
// Of a file in the list; does nothing for any other.
void rememberPlace(const QString& file, const QString& where, const QString& state);

}  // namespace app
