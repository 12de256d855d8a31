#pragma once
#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "app/core/document.h"

namespace app {

// Watches the file of the document's scene: whether another program has written to it since it was read or saved.
class FileWatch : public QObject {
    Q_OBJECT
public:
    explicit FileWatch(Document& document);

    bool hasChanged() const { return m_changed; }
    // The user's switch, for reading it again without being asked; off to begin with.
    static bool readsAgain();
    static void setReadsAgain(bool reads);

signals:
    void changed();  // hasChanged(), or the file has changed once more

private:
    struct Stamp {
        QDateTime time;
        qint64 size = -1;
        bool operator==(const Stamp&) const = default;
    };
    static Stamp stampOf(const QString& file);
    void settle();
    void look();

    Document& m_document;
    QFileSystemWatcher m_watcher;
    QTimer m_rest;  // programs write in several goes
    KeptScene m_kept;
    Stamp m_known, m_told;
    bool m_changed = false;
};

}  // namespace app
