#pragma once
#include <QObject>
#include <QTimer>
#include <functional>

#include "app/document/session_file.h"

namespace app {

class Document;

// Keeps what the window shows in the session's file: a few seconds after every change, so that little is lost when the
// program ends by accident, and when it is told to.
class Session : public QObject {
    Q_OBJECT
public:
    // state: what the window shows now; nothing where it shows no scene.
    Session(Document& document, const QString& folder, std::function<std::optional<lessons::WindowState>()> state,
            QObject* parent);

    SessionFile& file() { return m_file; }
    // Changes do not put the write off: while something plays it would never come.
    void saveSoon() {
        if (!m_soon.isActive()) m_soon.start();
    }
    // What was read has been shown, or could not be.
    void begin();
    // withChanges: what was not saved too; else the next session begins with the file. False where nothing is shown, or
    // the file cannot be written: it stays as it is.
    bool save(bool withChanges = true);
    // Writes at the program's end. A session that is still being restored stays in its file for the next start.
    void end(bool withChanges);
    void forget();  // the scene has been closed

private:
    Document& m_document;
    SessionFile m_file;
    std::function<std::optional<lessons::WindowState>()> m_state;
    QTimer m_soon;
    bool m_toldOfFailure = false;
};

}  // namespace app
