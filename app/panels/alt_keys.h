#pragma once
#include <QApplication>
#include <QKeyEvent>
#include <QWidget>
#include <functional>

namespace app {

// Takes Alt with a key before the part of a widget that has the focus: fields, buttons and scroll areas have uses of their
// own for letters and arrows.
class AltKeys : public QObject {
public:
    // take: whether it has taken the key.
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
