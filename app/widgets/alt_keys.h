#pragma once
#include <QApplication>
#include <QKeyEvent>
#include <QWidget>
#include <functional>

namespace app {

// Handles Alt with a key for a whole widget, before the child that has the focus: fields, buttons and scroll areas use
// letters and arrows themselves.
class AltKeys : public QObject {
public:
    // take(): returns whether it handled the key.
    AltKeys(QWidget* within, std::function<bool(QKeyEvent*)> take)
        : QObject(within), m_within(within), m_take(std::move(take)) {
        qApp->installEventFilter(this);
    }
    bool eventFilter(QObject* to, QEvent* event) override {
        if (event->type() != QEvent::KeyPress) return false;
        auto* const key = static_cast<QKeyEvent*>(event);
        auto* const widget = qobject_cast<QWidget*>(to);
        const bool isInside = widget && (widget == m_within || m_within->isAncestorOf(widget));
        return key->modifiers() == Qt::AltModifier && isInside && m_take(key);
    }

private:
    QWidget* m_within;
    std::function<bool(QKeyEvent*)> m_take;
};

}  // namespace app
