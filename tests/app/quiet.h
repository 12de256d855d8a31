#pragma once
#include <QCoreApplication>
#include <QEvent>
#include <QTest>
#include <utility>

namespace test {

// Counts the events that change what a window shows. Timers count through what they set off.
class ShownChanges : public QObject {
public:
    ShownChanges() { qApp->installEventFilter(this); }
    int count() const { return m_count; }

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        switch (event->type()) {
            case QEvent::MetaCall:
            case QEvent::LayoutRequest:
            case QEvent::UpdateRequest:
            case QEvent::Paint:
            case QEvent::Resize:
            case QEvent::Show:
            case QEvent::Hide:
            case QEvent::DeferredDelete: ++m_count; break;
            default: break;
        }
        return false;
    }

private:
    int m_count = 0;
};

// Runs the event loop until a round of it lays out, paints and calls nothing: what has been done so far is on the screen,
// but for what a timer or another thread has yet to bring. False if that takes longer than 5 s.
inline bool waitUntilQuiet() {
    const ShownChanges changes;
    int before = -1;
    return QTest::qWaitFor([&] { return std::exchange(before, changes.count()) == changes.count(); });
}

}  // namespace test
