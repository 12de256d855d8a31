#include "app/talk/talk_pointer.h"

#include <QApplication>
#include <QMouseEvent>
#include <QWidget>
#include <utility>

#include "app/talk/pen_layer.h"

namespace app {
namespace {

constexpr int kRestMs = 2000;

}  // namespace

TalkPointer::TalkPointer(QWidget& talk, PenLayer& pen) : m_talk(talk), m_pen(pen) {
    m_restTime.setSingleShot(true);
    m_restTime.setInterval(kRestMs);
    connect(&m_restTime, &QTimer::timeout, this, [this] {
        if (!std::exchange(m_isHidden, true)) QApplication::setOverrideCursor(Qt::BlankCursor);
    });
    qApp->installEventFilter(this);
    m_restTime.start();
}

TalkPointer::~TalkPointer() { showCursor(); }

void TalkPointer::showCursor() {
    if (std::exchange(m_isHidden, false)) QApplication::restoreOverrideCursor();
}

bool TalkPointer::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseMove) {
        if (auto* widget = qobject_cast<QWidget*>(watched); widget && widget->window() == &m_talk) {
            m_pen.pointAt(widget->mapTo(&m_talk, static_cast<QMouseEvent*>(event)->position().toPoint()));
            showCursor();
            m_restTime.start();
        }
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace app
