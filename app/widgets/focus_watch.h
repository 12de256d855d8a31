#pragma once
#include <QApplication>
#include <QObject>

namespace app {

// Tells a widget, of which it is a member, where the keyboard's focus goes. As a member it ends before the widget's
// children do: one of those that has the focus loses it as it goes, when there is nobody left to be told.
class FocusWatch {
public:
    template <class Tell>
    void begin(Tell tell) {  // tell(QWidget* now)
        QObject::connect(qApp, &QApplication::focusChanged, &m_listener, [tell](QWidget*, QWidget* now) { tell(now); });
    }
    void end() { QObject::disconnect(qApp, nullptr, &m_listener, nullptr); }

private:
    QObject m_listener;
};

}  // namespace app
