#include "app/look/working_bar.h"

#include <QEvent>
#include <QPainter>
#include <utility>

#include "app/look/theme.h"

namespace app {

WorkingBar::WorkingBar(QWidget* view) : QWidget(view) {
    constexpr int kMomentMilliseconds = 100;
    setObjectName("working");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
    m_slow.setSingleShot(true);
    m_slow.setInterval(kMomentMilliseconds);
    connect(&m_slow, &QTimer::timeout, this, &WorkingBar::showState);
    view->installEventFilter(this);
}

void WorkingBar::setWorking(bool works) {
    if (works == std::exchange(m_works, works)) return;
    works ? m_slow.start() : m_slow.stop();
    showState();
}

void WorkingBar::setStopped(bool stopped) {
    if (stopped != std::exchange(m_stopped, stopped)) showState();
}

void WorkingBar::showState() {
    setVisible(m_stopped || (m_works && !m_slow.isActive()));
    raise();
    update();
}

bool WorkingBar::eventFilter(QObject*, QEvent* event) {
    constexpr int kHeight = 3;
    if (event->type() == QEvent::Resize) setGeometry(0, 0, parentWidget()->width(), kHeight);
    return false;
}

void WorkingBar::paintEvent(QPaintEvent*) {
    const ThemeColors& colors = Theme::current().colors();
    QPainter painter(this);
    if (m_works) return painter.fillRect(rect(), colors.accent);
    QPen dashes(colors.failed, height(), Qt::CustomDashLine, Qt::FlatCap);
    dashes.setDashPattern({4, 2});
    painter.setPen(dashes);
    painter.drawLine(QLineF(0, height() / 2.0, width(), height() / 2.0));
}

}  // namespace app
