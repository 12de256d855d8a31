#include "app/document/renderer_watch.h"

#include <QDir>
#include <utility>

#include "app/document/renderer_files.h"

namespace app {
namespace {

constexpr int kFilesRest = 300, kFilesAbsent = 1000;  // milliseconds

}  // namespace

RendererWatch::RendererWatch() {
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, &RendererWatch::look);
}

void RendererWatch::setPaths(const QStringList& paths) {
    m_paths = paths;
    if (paths.isEmpty()) m_rest.stop();
    follow();
}

// Folders tell of files that come and go, files of being written.
void RendererWatch::follow() {
    if (m_paths.isEmpty()) return m_watcher.reset();
    if (!m_watcher) {
        m_watcher = std::make_unique<QFileSystemWatcher>();
        const auto rest = [this] { m_rest.start(kFilesRest); };
        connect(m_watcher.get(), &QFileSystemWatcher::fileChanged, this, rest);
        connect(m_watcher.get(), &QFileSystemWatcher::directoryChanged, this, rest);
    }
    QStringList wanted = m_paths;
    for (const QString& path : m_paths)
        for (const QFileInfo& file : QDir(path).entryInfoList(QDir::Files)) wanted += file.absoluteFilePath();
    QStringList watched = m_watcher->files() + m_watcher->directories(), added;
    for (const QString& one : wanted)
        if (!watched.removeOne(one) && QFileInfo::exists(one)) added += one;
    if (!watched.isEmpty()) m_watcher->removePaths(watched);
    if (!added.isEmpty()) m_watcher->addPaths(added);
}

void RendererWatch::take() { m_known = m_seen = stampOf(m_paths); }

void RendererWatch::look() {
    if (m_paths.isEmpty()) return;
    follow();
    const QString now = stampOf(m_paths);
    if (now.isEmpty()) m_rest.start(kFilesAbsent);  // a folder that is gone may come back
    if (now == m_known || now.isEmpty()) return;
    if (std::exchange(m_seen, now) != now) return m_rest.start(kFilesRest);
    emit changed();
}

}  // namespace app
