#pragma once
#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "app/document/document.h"

namespace app {

// Watches whether another program writes to the file of the document's scene after it was read or saved.
class FileWatch : public QObject {
    Q_OBJECT
public:
    explicit FileWatch(Document& document);

    bool hasChanged() const { return m_changed; }
    // The user's switch for automatic reloading; off by default.
    static bool readsAgain();
    static void setReadsAgain(bool reads);

signals:
    void changed();  // hasChanged(), or another change of the file

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
    QTimer m_rest;  // programs write a file in several steps
    KeptScene m_kept;
    Stamp m_known, m_told;
    bool m_changed = false;
};

}  // namespace app
