#pragma once
#include <QWidget>
#include <optional>

#include "pipeline/check/case.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace app {

class FittingChoice;

// The top of the stiff cases: how many hold or how far a run is, which group is on show, and the buttons for all of them.
class CheckBar : public QWidget {
    Q_OBJECT
public:
    explicit CheckBar(QWidget* parent);

    struct State {
        bool isRunning = false;
        std::size_t arrived = 0, asked = 0;  // of the cases that run now
        std::size_t known = 0, hold = 0;     // of all cases
        double seconds = 0;                  // of the newest run of all; 0: there was none
    };
    void showState(const State& state);
    void setGroup(std::optional<pipeline::check::Group> group);  // nothing: all
    void setNarrow(bool narrow);                                 // then the groups are a list

signals:
    void groupChosen(std::optional<pipeline::check::Group> group);
    void runAsked();
    void copyAsked();

private:
    QLabel* m_head;
    QProgressBar* m_progress;
    FittingChoice* m_groups;
    QPushButton *m_copy, *m_runAll;
};

}  // namespace app
