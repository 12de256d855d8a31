#pragma once
#include <QFrame>
#include <QPointer>

#include "app/widgets/focus_watch.h"

namespace app {

// A box over the window. Esc or a click elsewhere closes it, and the focus returns to where it was.
class Popover : public QFrame {
    Q_OBJECT
public:
    explicit Popover(QWidget* window);

    void open(QWidget* focus);  // at the top third of the window
    void close();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

    void place();  // its size hint, where the window has room for it

private:
    QPointer<QWidget> m_before;
    FocusWatch m_focus;
};

}  // namespace app
