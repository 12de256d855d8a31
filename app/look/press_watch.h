#pragma once
#include <QEvent>
#include <QObject>
#include <QWidget>
#include <functional>
#include <utility>

namespace app {

// Reports every press of a mouse button on a widget or on a part of it, before they handle it. Not in the menus of its
// parts.
class PressWatch : public QObject {
public:
    PressWatch(QWidget& widget, std::function<void()> tell) : QObject(&widget), m_tell(std::move(tell)) {
        widget.installEventFilter(this);
        for (QWidget* part : widget.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
            part->installEventFilter(this);
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::MouseButtonPress) m_tell();
        return QObject::eventFilter(watched, event);
    }

private:
    std::function<void()> m_tell;
};

}  // namespace app
