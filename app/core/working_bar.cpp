#include "app/core/working_bar.h"

#include <QEvent>
#include <QPainter>

#include "app/core/theme.h"

namespace app {

WorkingBar::WorkingBar(QWidget* view) : QWidget(view) {
    constexpr int kMomentMilliseconds = 100;
    setObjectName("working");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
    m_slow.setSingleShot(true);
    m_slow.setInterval(kMomentMilliseconds);
    connect(&m_slow, &QTimer::timeout, this, [this] {
        raise();
        show();
    });
    view->installEventFilter(this);
}

void WorkingBar::setWorking(bool works) {
    if (works == (m_slow.isActive() || isVisibleTo(parentWidget()))) return;
    if (works) return m_slow.start();
    m_slow.stop();
    hide();
}

bool WorkingBar::eventFilter(QObject*, QEvent* event) {
    constexpr int kHeight = 3;
    if (event->type() == QEvent::Resize) setGeometry(0, 0, parentWidget()->width(), kHeight);
    return false;
}

void WorkingBar::paintEvent(QPaintEvent*) { QPainter(this).fillRect(rect(), Theme::current().colors().accent); }

}  // namespace app
