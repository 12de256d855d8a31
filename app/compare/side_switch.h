#pragma once
#include <QObject>
#include <QTimer>

#include "app/canvas/wipe.h"
#include "app/compare/compare_bar.h"

namespace app {

// Which side of a comparison a view shows: as its mode says, or B as long as a key is held.
class SideSwitch : public QObject {
    Q_OBJECT
public:
    explicit SideSwitch(QObject* parent);

    CompareMode mode() const { return m_mode; }
    void setMode(CompareMode mode);  // the same again: back to A
    double share() const { return m_share; }
    void setShare(double share);  // of the width that A keeps in a wipe
    // Whether they have changed.
    bool holdOther(bool held);     // shows B meanwhile
    bool holdPrevious(bool held);  // shows the stage before meanwhile
    bool holdsPrevious() const { return m_holdsPrevious; }
    bool isHeld() const { return m_holdsOther || m_holdsPrevious; }
    Wipe wipe() const;  // without the names

signals:
    void turned();  // by itself: another side is to be shown

private:
    CompareMode m_mode = CompareMode::A;
    double m_share = 0.5;
    bool m_holdsOther = false, m_holdsPrevious = false, m_blinksToB = false;
    QTimer m_blink;
};

}  // namespace app
