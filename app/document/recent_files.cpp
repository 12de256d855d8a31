#include "app/document/recent_files.h"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>

#include "app/look/shown_name.h"

namespace app {

std::vector<RecentFile> recentFiles() {
    std::vector<RecentFile> files;
    QSettings settings;
    const int n = settings.beginReadArray("recent");
    for (int i = 0; i < n; ++i) {
        settings.setArrayIndex(i);
        RecentFile entry{settings.value("file").toString(), settings.value("when").toDateTime(),
                         settings.value("where").toString(), settings.value("state").toString(),
                         settings.value("title").toString()};
        if (QFileInfo::exists(entry.file)) files.push_back(std::move(entry));
    }
    return files;
}

namespace {

void writeRecentFiles(const std::vector<RecentFile>& files) {
    QSettings settings;
    settings.remove("recent");
    settings.beginWriteArray("recent", int(files.size()));
    for (std::size_t i = 0; i < files.size(); ++i) {
        settings.setArrayIndex(int(i));
        settings.setValue("file", files[i].file);
        settings.setValue("when", files[i].when);
        settings.setValue("where", files[i].where);
        settings.setValue("state", files[i].state);
        settings.setValue("title", files[i].title);
    }
    settings.endArray();
}

}  // namespace

QString nameOf(const RecentFile& recent) { return recent.title.isEmpty() ? shownName(recent.file) : recent.title; }

QStringList recentNames(const std::vector<RecentFile>& files) {
    QStringList names, all;
    for (const RecentFile& recent : files) names += nameOf(recent);
    for (qsizetype i = 0; i < names.size(); ++i)
        all += names.count(names[i]) == 1
                   ? names[i]
                   : QStringLiteral("%1  –  %2").arg(names[i], QFileInfo(files[std::size_t(i)].file).path());
    return all;
}

void addRecentFile(const QString& file, const QString& title) {
    RecentFile entry{.file = QFileInfo(file).absoluteFilePath(), .when = QDateTime::currentDateTime(), .title = title};
    std::vector<RecentFile> files = recentFiles();
    const auto before = std::ranges::find(files, entry.file, &RecentFile::file);
    if (before != files.end()) {
        entry.where = before->where, entry.state = before->state;
        files.erase(before);
    }
    files.insert(files.begin(), std::move(entry));
    if (files.size() > std::size_t(kMaxRecentFiles)) files.resize(kMaxRecentFiles);
    writeRecentFiles(files);
}

void rememberPlace(const QString& file, const QString& where, const QString& state) {
    std::vector<RecentFile> files = recentFiles();
    const auto entry = std::ranges::find(files, file, &RecentFile::file);
    if (entry == files.end()) return;
    entry->where = where, entry->state = state;
    writeRecentFiles(files);
}

}  // namespace app
