#include "app/jobs/application.h"

#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <new>

#include "app/jobs/memory_notice.h"

namespace app {

namespace {

// Qt polishes a label before it lays out its text, also one that it makes itself: of a tooltip, a message box, a form.
void keepPlain(QObject& receiver) {
    auto* label = qobject_cast<QLabel*>(&receiver);
    if (label && label->textFormat() == Qt::AutoText) label->setTextFormat(Qt::PlainText);
}

// Enter presses the button that has the focus, as Space does; Qt does so in dialogs alone. True: it was pressed.
bool pressByEnter(QObject& receiver, const QKeyEvent& key) {
    const bool isEnter = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    auto* button = qobject_cast<QAbstractButton*>(&receiver);
    if (!isEnter || !button || !button->hasFocus() || (key.modifiers() & ~Qt::KeypadModifier)) return false;
    auto* tool = qobject_cast<QToolButton*>(button);
    if (!tool && !qobject_cast<QPushButton*>(button)) return false;  // a choice is made by Space, and Enter takes it
    if (key.isAutoRepeat()) return true;
    if (tool && tool->menu() && tool->popupMode() == QToolButton::InstantPopup)
        tool->showMenu();
    else
        button->click();
    return true;
}

}  // namespace

bool Application::notify(QObject* receiver, QEvent* event) {
    if (event->type() == QEvent::Polish) keepPlain(*receiver);
    try {
        if (event->type() == QEvent::KeyPress && pressByEnter(*receiver, static_cast<QKeyEvent&>(*event))) return true;
        return QApplication::notify(receiver, event);
    } catch (const std::bad_alloc&) {
        event->ignore();  // above all of a window that was to be closed and could not be saved first
        try {
            emit MemoryNotice::instance().gaveUp();
        } catch (const std::bad_alloc&) {  // not even for that: it is left unsaid
        }
        return true;
    }
}

}  // namespace app
