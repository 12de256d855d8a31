#pragma once
#include <QDateTime>
#include <QString>
#include <vector>

namespace app {

// The files opened last, newest first, kept in the program's settings.
struct RecentFile {
    QString file;    // absolute path
    QDateTime when;  // opened last
};

inline constexpr int kMaxRecentFiles = 8;

std::vector<RecentFile> recentFiles();  // those that still exist
void addRecentFile(const QString& file);

}  // namespace app
