#include "app/core/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace app {

std::vector<RecentFile> recentFiles() {
    std::vector<RecentFile> files;
    QSettings settings;
    const int n = settings.beginReadArray("recent");
    for (int i = 0; i < n; ++i) {
        settings.setArrayIndex(i);
        RecentFile entry{settings.value("file").toString(), settings.value("when").toDateTime()};
        if (QFileInfo::exists(entry.file)) files.push_back(std::move(entry));
    }
    return files;
}

void addRecentFile(const QString& file) {
    const QString path = QFileInfo(file).absoluteFilePath();
    std::vector<RecentFile> files = recentFiles();
    std::erase_if(files, [&](const RecentFile& entry) { return entry.file == path; });
    files.insert(files.begin(), RecentFile{path, QDateTime::currentDateTime()});
    if (files.size() > std::size_t(kMaxRecentFiles)) files.resize(kMaxRecentFiles);
    QSettings settings;
    settings.beginWriteArray("recent", int(files.size()));
    for (std::size_t i = 0; i < files.size(); ++i) {
        settings.setArrayIndex(int(i));
        settings.setValue("file", files[i].file);
        settings.setValue("when", files[i].when);
    }
    settings.endArray();
}

}  // namespace app
