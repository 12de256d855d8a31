#pragma once
#include <QString>
#include <optional>

#include "lessons/state/window_state.h"

namespace app {

// The session of the last run: a state in a file of the program's own. While it is being restored it stands under
// another name, so that one which ends the program is not tried again. One that was not restored is kept beside it.
class SessionFile {
public:
    explicit SessionFile(const QString& folder);

    static QString usualFolder();
    static bool isWanted();  // the user's switch; on to begin with
    static void setWanted(bool wanted);

    struct Left {
        std::optional<lessons::WindowState> state;
        pipeline::Errors errors;  // why there is none although there was a file
        QString aside;            // where that file is now; else empty
    };
    Left take();
    Left leave();          // restores none; one that ended the program while it was restored goes aside
    bool isTried() const;  // it is being restored
    void settle();         // it has been
    void giveBack();       // it has not, and may be tried again
    bool write(const lessons::WindowState& state);  // whole or not at all
    void remove();
    const QString& file() const { return m_file; }

private:
    QString setAside(const QString& file);
    void keepPrevious();

    QString m_file, m_tried, m_previous;
    bool m_isOwn = false;  // what stands in the file is of this run
};

}  // namespace app
