#include "app/widgets/popover.h"

#include <algorithm>

#include <QApplication>
#include <QKeyEvent>

namespace app {

Popover::Popover(QWidget* window) : QFrame(window) {
    setProperty("kind", "overlay");
    setAutoFillBackground(true);
    setFocusPolicy(Qt::StrongFocus);
    hide();
}

void Popover::open(QWidget* focus) {
    if (!isVisible()) m_before = QApplication::focusWidget();  // else it is one of its own
    place();
    show();
    raise();
    focus->setFocus(Qt::PopupFocusReason);
    qApp->installEventFilter(this);
    m_focus.begin([this](const QWidget* now) {
        if (now && now != this && !isAncestorOf(now)) close();
    });
}

void Popover::close() {
    if (!isVisible()) return;
    qApp->removeEventFilter(this);
    m_focus.end();
    const bool hadFocus = QApplication::focusWidget() == this || isAncestorOf(QApplication::focusWidget());
    hide();
    if (hadFocus && m_before) m_before->setFocus(Qt::PopupFocusReason);
}

void Popover::place() {
    const QSize room = parentWidget()->size();
    adjustSize();
    resize(std::min(width(), room.width() - 32), std::min(height(), room.height() - 64));
    move((room.width() - width()) / 2, std::min(room.height() / 6, room.height() - height() - 16));
}

bool Popover::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize) place();
    if (event->type() == QEvent::MouseButtonPress) {
        auto* pressed = qobject_cast<QWidget*>(watched);
        if (pressed && pressed != this && pressed->window() == window() && !isAncestorOf(pressed)) close();
    }
    return false;
}

void Popover::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) return close();
    QFrame::keyPressEvent(event);
}

}  // namespace app
