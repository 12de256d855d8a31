#include "app/widgets/value_slider.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>

#include "app/widgets/follow_theme.h"

namespace app {

ValueSlider::ValueSlider(double low, double high, double step, QWidget* parent)
    : QWidget(parent), m_low(low), m_high(high), m_step(step), m_value(low) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    speak(*this);
    followTheme(this, [this] { updateGeometry(), update(); });
}

QSize ValueSlider::sizeHint() const { return {Theme::current().px(48), Theme::current().px(24)}; }

void ValueSlider::setValue(double value) {
    if (value == m_value) return;
    m_value = value;
    sayValue(*this);
    update();
}

AccessibleSlider::Scale ValueSlider::spoken() const {
    return {m_value, m_low, m_high, std::max(m_step, (m_high - m_low) / 100)};
}

void ValueSlider::slideTo(double value) {
    setValue(snapped(value));
    emit released(m_value);
}

void ValueSlider::setMark(std::optional<double> before) {
    if (before == m_mark) return;
    m_mark = before;
    update();
}

QPointF ValueSlider::position(double value) const {
    const double r = Theme::current().px(8);  // room for the knob at both ends
    const double t = m_high > m_low ? std::clamp((value - m_low) / (m_high - m_low), 0.0, 1.0) : 0;
    return {r + t * (width() - 2 * r), height() / 2.0};
}

double ValueSlider::valueAt(double x) const {
    const double left = position(m_low).x(), right = position(m_high).x();
    const double t = right > left ? std::clamp((x - left) / (right - left), 0.0, 1.0) : 0;
    return snapped(m_low + t * (m_high - m_low));
}

// A drag stops at numbers that a person would write: three digits of the range.
double ValueSlider::snapped(double value) const {
    const double grid = m_step > 0 ? m_step : std::pow(10.0, std::floor(std::log10(m_high - m_low)) - 2);
    // Dividing by 10^k gives the shortest decimals; multiplying by 0.01 would not.
    value =
        grid < 1 ? std::round(value * std::round(1 / grid)) / std::round(1 / grid) : std::round(value / grid) * grid;
    return std::clamp(value, m_low, m_high);
}

void ValueSlider::stepBy(double steps) {
    const double value = snapped(std::clamp(m_value, m_low, m_high) + steps * spoken().step);
    if (value != m_value) slideTo(value);
}

void ValueSlider::setRinged(bool ringed) {
    if (ringed == m_ringed) return;
    m_ringed = ringed;
    update();
}

void ValueSlider::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF left = position(m_low), knob = position(m_value), right = position(m_high);
    const double track = theme.px(4), radius = theme.px(6);
    const auto bar = [&](double from, double to, const QColor& color) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        painter.drawRoundedRect(QRectF(from, left.y() - track / 2, to - from, track), track / 2, track / 2);
    };
    const QColor accent = isEnabled() ? c.accent : c.outline;
    bar(left.x(), right.x(), c.hover);
    bar(left.x(), knob.x(), accent);
    if (m_mark) {
        const double x = position(*m_mark).x();
        painter.fillRect(QRectF(x - 1, left.y() - theme.px(5), 2, theme.px(10)), c.text3);
    }
    if (hasFocus() || m_ringed) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(hasFocus() ? c.focus : c.accent, 2));
        painter.drawEllipse(knob, radius + 3, radius + 3);
    }
    painter.setPen(QPen(accent, 2));
    painter.setBrush(m_dragged ? accent : c.raised);
    painter.drawEllipse(knob, radius, radius);
}

void ValueSlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    m_dragged = true;
    update();
    setValue(valueAt(event->position().x()));
    emit moved(m_value);
}

void ValueSlider::mouseMoveEvent(QMouseEvent* event) {
    if (!m_dragged) return;
    const double value = valueAt(event->position().x());
    if (value == m_value) return;
    setValue(value);
    emit moved(value);
}

void ValueSlider::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_dragged) return;
    m_dragged = false;
    update();
    emit released(m_value);
}

void ValueSlider::keyPressEvent(QKeyEvent* event) {
    switch (event->modifiers() ? 0 : event->key()) {
        case Qt::Key_Left:
        case Qt::Key_Down: return stepBy(-1);
        case Qt::Key_Right:
        case Qt::Key_Up: return stepBy(1);
        case Qt::Key_PageDown: return stepBy(-10);
        case Qt::Key_PageUp: return stepBy(10);
        case Qt::Key_Home: return stepBy(-1e6);
        case Qt::Key_End: return stepBy(1e6);
        default: QWidget::keyPressEvent(event);
    }
}

// Scrolling the panel must not change what happens to lie under the cursor.
void ValueSlider::wheelEvent(QWheelEvent* event) {
    const int turn = event->angleDelta().y();
    if (!hasFocus() || turn == 0) return event->ignore();  // 0: sideways
    stepBy(turn > 0 ? 1 : -1);
}

}  // namespace app
