#pragma once
#include <QString>
#include <optional>

#include "lessons/state/window_state.h"

namespace app {

// The session of the last run: a state in the program's own file. While it is restored, the file has another name, so
// that a session that crashes the program is not tried again. A session that was not restored is kept beside it.
class SessionFile {
public:
    explicit SessionFile(const QString& folder);

    static QString usualFolder();
    static bool isWanted();  // the user's switch; on by default
    static void setWanted(bool wanted);

    struct Left {
        std::optional<lessons::WindowState> state;
        pipeline::Errors errors;  // why there is no session although there was a file
        QString aside;            // where that file is now, or empty
    };
    Left take();
    Left leave();          // restores nothing; a session that crashed the program is moved aside
    bool isTried() const;  // it is being restored
    void settle();         // restoring succeeded
    void giveBack();       // restoring did not happen; it may be tried again
    bool write(const lessons::WindowState& state);  // whole or not at all
    void remove();
    const QString& file() const { return m_file; }

private:
    QString setAside(const QString& file);
    void keepPrevious();

    QString m_file, m_tried, m_previous;
    bool m_isOwn = false;  // this run has written the file
};

}  // namespace app
