#include "app/inspector/gain_bar.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/look/theme.h"
#include "pipeline/inspect/term_mix.h"

namespace app {

using pipeline::kMostGain;

GainBar::GainBar(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::SizeHorCursor);
    speak(*this);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("What the term adds. Drag for its gain, from 0 to 4; a double click makes it 1."));
}

QSize GainBar::sizeHint() const { return {Theme::current().px(120), Theme::current().px(20)}; }

void GainBar::show(double share, double gain, bool isOff) {
    m_share = share;
    const bool isOther = std::exchange(m_gain, gain) != gain;
    m_off = isOff;
    setAccessibleDescription(tr("gain %1").arg(gain));
    if (isOther) sayValue(*this);
    update();
}

AccessibleSlider::Scale GainBar::spoken() const { return {m_gain, 0, kMostGain, 0.1}; }

void GainBar::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double thick = theme.px(10);
    const QRectF track(1, (height() - thick) / 2, width() - 2, thick);
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.hover);
    painter.drawRoundedRect(track, 2, 2);
    if (m_share > 0) {
        QRectF bar = track;
        bar.setWidth(std::max(1.0, track.width() * std::min(1.0, m_share)));
        painter.setBrush(c.text2);
        painter.drawRect(bar);
    }
    // The mark of the gain; at 1 it is no news and stands back.
    const double x = track.left() + track.width() * m_gain / kMostGain;
    const QColor mark = m_off ? c.outline : m_gain == 1 ? c.outline : c.accent;
    painter.setBrush(mark);
    painter.setPen(QPen(c.surface, 1));
    painter.drawRoundedRect(QRectF(x - 2.5, track.top() - 4, 5, thick + 8), 2, 2);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(c.focus, 2));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 3, 3);
    }
}

void GainBar::drag(double x) {
    const double share = std::clamp((x - 1) / std::max(1, width() - 2), 0.0, 1.0);
    double gain = std::round(share * kMostGain * 20) / 20;
    if (std::abs(gain - 1) < 0.08) gain = 1;  // it is easily found again
    emit moved(gain);
}

void GainBar::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) drag(event->position().x());
}

void GainBar::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton) drag(event->position().x());
}

void GainBar::mouseDoubleClickEvent(QMouseEvent*) { emit moved(1); }

void GainBar::keyPressEvent(QKeyEvent* event) {
    const auto to = [this](double gain) { emit moved(std::clamp(std::round(gain * 10) / 10, 0.0, kMostGain)); };
    switch (event->modifiers() & ~Qt::KeypadModifier ? 0 : event->key()) {
        case Qt::Key_Left:
        case Qt::Key_Down: return to(m_gain - 0.1);
        case Qt::Key_Right:
        case Qt::Key_Up: return to(m_gain + 0.1);
        case Qt::Key_Home:
        case Qt::Key_0: return to(0);
        case Qt::Key_End: return to(kMostGain);
        case Qt::Key_1: return to(1);
        default: QWidget::keyPressEvent(event);
    }
}

}  // namespace app
