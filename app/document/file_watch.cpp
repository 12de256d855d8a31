#include "app/document/file_watch.h"

#include <QFileInfo>
#include <QSettings>
#include <utility>

#include "app/document/own_file.h"

namespace app {

constexpr int kQuietMilliseconds = 300, kAbsentMilliseconds = 1000;

bool FileWatch::readsAgain() { return QSettings().value("files/readAgain", false).toBool(); }
void FileWatch::setReadsAgain(bool reads) { QSettings().setValue("files/readAgain", reads); }

FileWatch::FileWatch(Document& document) : m_document(document) {
    m_rest.setSingleShot(true);
    connect(&document, &Document::keptChanged, this, &FileWatch::settle);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, [this] { m_rest.start(kQuietMilliseconds); });
    connect(&m_rest, &QTimer::timeout, this, &FileWatch::look);
}

FileWatch::Stamp FileWatch::stampOf(const QString& file) {
    const QFileInfo info(file);
    return info.isFile() ? Stamp{info.lastModified(), info.size()} : Stamp{};
}

// The scene is another, or its file is what this program has just read or written.
void FileWatch::settle() {
    const KeptScene& kept = m_document.kept();
    if (kept.scene == m_kept.scene && kept.file == m_kept.file) return;
    m_kept = kept;
    if (!m_watcher.files().isEmpty()) m_watcher.removePaths(m_watcher.files());
    if (!m_kept.file.isEmpty()) m_watcher.addPath(m_kept.file);
    m_known = m_told = stampOf(m_kept.file);
    if (std::exchange(m_changed, false)) emit changed();
}

void FileWatch::look() {
    settle();
    if (m_kept.file.isEmpty()) return;
    const Stamp now = stampOf(m_kept.file);
    // A file that is gone may come back: some programs remove it and write another a while later. Looked for, not
    // watched: its folder may be gone with it.
    if (now.size < 0) return m_rest.start(kAbsentMilliseconds);
    // The watch ended with the file before.
    if (!m_watcher.files().contains(m_kept.file)) m_watcher.addPath(m_kept.file);
    if (now == m_told) return;
    m_told = now;
    if (!ownFile(m_document).isEmpty()) m_known = now;  // it holds what this program wrote there
    m_changed = now != m_known;
    emit changed();
}

}  // namespace app
