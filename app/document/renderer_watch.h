#pragma once
#include <QFileSystemWatcher>
#include <QStringList>
#include <QTimer>
#include <memory>

namespace app {

// Watches the files of another renderer, or its folder, and says when they have other contents. Renderers write in
// several goes, so two looks in a row must have seen the same.
class RendererWatch : public QObject {
    Q_OBJECT
public:
    RendererWatch();

    void setPaths(const QStringList& paths);  // none: watches nothing
    void follow();                            // files that have come or gone in a folder
    void take();                              // what the files hold now is known

signals:
    void changed();

private:
    void look();

    QStringList m_paths;
    std::unique_ptr<QFileSystemWatcher> m_watcher;
    QTimer m_rest;
    QString m_known, m_seen;  // stamps of the files
};

}  // namespace app
