#include "app/core/application.h"

#include <QEvent>
#include <QLabel>
#include <new>

#include "app/core/memory_notice.h"

namespace app {

namespace {

// Qt polishes a label before it lays out its text, also one that it makes itself: of a tooltip, a message box, a form.
void keepPlain(QObject& receiver) {
    auto* label = qobject_cast<QLabel*>(&receiver);
    if (label && label->textFormat() == Qt::AutoText) label->setTextFormat(Qt::PlainText);
}

}  // namespace

bool Application::notify(QObject* receiver, QEvent* event) {
    if (event->type() == QEvent::Polish) keepPlain(*receiver);
    try {
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
