#include "app/canvas/palette_bar.h"

#include <QHelpEvent>
#include <QInputDialog>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "app/look/accessible.h"
#include "app/look/numbers.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/text/text_scanner.h"

namespace app {

using pipeline::PaletteRange;

double barHeight(int count, int most, bool logarithmic) {
    if (count <= 0 || most <= 0) return 0;
    return logarithmic ? std::log1p(count) / std::log1p(most) : double(count) / most;
}

PaletteBar::PaletteBar(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleRole(*this, QAccessible::Chart);
    setToolTip(
        tr("Drag a handle to choose what the palette's ends stand for, between them to move both; "
           "double-click to type. ← → move the first end, Shift+← → the last"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    followTheme(this, [this] {
        updateGeometry();
        update();
    });
}

QSize PaletteBar::sizeHint() const { return {Theme::current().px(180), Theme::current().px(44)}; }
QSize PaletteBar::minimumSizeHint() const { return {Theme::current().px(60), Theme::current().px(44)}; }

void PaletteBar::setScale(Scale scale) {
    m_scale = std::move(scale);
    const auto [least, most] = std::minmax(m_scale.range.first, m_scale.range.last);
    setAccessibleName(tr("Range of the palette: %1 to %2").arg(least).arg(most));
    update();
}

QRectF PaletteBar::bar() const {
    const double margin = 7;
    const QString axis = axisText();
    const double left =
        axis.isEmpty() ? margin : margin + QFontMetricsF(Theme::current().mono(12)).horizontalAdvance(axis) + 4;
    return {left, height() - 12.0, width() - left - margin, 7};
}

int PaletteBar::most() const {
    return m_scale.histogram.empty() ? 0 : *std::max_element(m_scale.histogram.begin(), m_scale.histogram.end());
}

QString PaletteBar::axisText() const {
    const QString text = count(most());
    const double width = QFontMetricsF(Theme::current().mono(12)).horizontalAdvance(text);
    constexpr double kShare = 0.4;  // of the bar, at most
    return most() > 0 && width < kShare * this->width() ? text : QString();
}

QString PaletteBar::binText(QPointF point) const {
    const QRectF area = bar();
    const auto bins = double(m_scale.histogram.size());
    if (bins == 0 || point.x() < area.left() || point.x() >= area.right() || point.y() > area.top()) return {};
    const double i = std::floor((point.x() - area.left()) / area.width() * bins);
    const double step = (m_scale.high - m_scale.low) / bins;
    const int decimals = step > 0 ? std::clamp(1 - int(std::floor(std::log10(step))), 0, 9) : 0;
    return tr("%1 to %2: %3")
        .arg(number(m_scale.low + i * step, decimals), number(m_scale.low + (i + 1) * step, decimals),
             count(m_scale.histogram[std::size_t(i)]));
}

bool PaletteBar::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    auto* help = static_cast<QHelpEvent*>(event);
    const QString bin = binText(help->pos());
    QToolTip::showText(help->globalPos(), bin.isEmpty() ? toolTip() : bin, this);
    return true;
}

double PaletteBar::xOf(double value) const {
    const double length = m_scale.high - m_scale.low;
    return bar().left() + (length > 0 ? std::clamp((value - m_scale.low) / length, 0.0, 1.0) : 0) * bar().width();
}

double PaletteBar::valueAt(double x) const {
    return m_scale.low + (x - bar().left()) / bar().width() * (m_scale.high - m_scale.low);
}

// From no pixel to the fullest bin, with a tick at every power of ten where the axis is logarithmic.
void PaletteBar::paintAxis(QPainter& painter, double x, double foot, double room) const {
    const QString top = axisText();
    if (top.isEmpty()) return;
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    painter.setPen(QPen(c.outline, 1));
    painter.drawLine(QPointF(x - 2, foot), QPointF(x - 2, foot - room));
    const auto tick = [&](int count) {
        const double y = foot - room * barHeight(count, most(), m_scale.logarithmic);
        painter.drawLine(QPointF(x - 5, y), QPointF(x - 2, y));
    };
    tick(0);
    tick(most());
    for (qint64 ten = 1; m_scale.logarithmic && ten < most(); ten *= 10) tick(int(ten));
    const QFont font = theme.mono(12);
    const QFontMetricsF metrics(font);
    painter.setFont(font);
    painter.setPen(c.text2);
    const QRectF column(0, 0, x - 7, height());
    painter.drawText(column, Qt::AlignRight | Qt::AlignTop, top);
    const double half = metrics.height() / 2;
    painter.drawText(QRectF(column.left(), std::min(foot - half, height() - 2 * half), column.width(), 2 * half),
                     Qt::AlignRight | Qt::AlignVCenter, "0");
}

void PaletteBar::paintEvent(QPaintEvent*) {
    const ThemeColors& c = Theme::current().colors();
    QPainter painter(this);
    const QRectF area = bar();
    if (!m_scale.histogram.empty()) {
        const double step = area.width() / double(m_scale.histogram.size()), room = area.top() - 3;
        paintAxis(painter, area.left(), area.top() - 1, room);
        const int fullest = most();
        for (std::size_t i = 0; i < m_scale.histogram.size(); ++i) {
            const double h = room * barHeight(m_scale.histogram[i], fullest, m_scale.logarithmic);
            painter.fillRect(QRectF(area.left() + step * double(i), area.top() - 1 - h, std::max(1.0, step - 0.5), h),
                             c.text3);
        }
    }
    for (int x = 0; x < int(area.width()); ++x) {
        const double value = m_scale.low + x / area.width() * (m_scale.high - m_scale.low);
        const pipeline::Color8 color = paletteColor(m_scale.palette, value, m_scale.range.first, m_scale.range.last);
        painter.fillRect(QRectF(area.left() + x, area.top(), 1, area.height()), QColor(color.r, color.g, color.b));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(c.raised);
    painter.setPen(QPen(c.text2, 1.2));
    for (const double value : {m_scale.range.first, m_scale.range.last}) {
        const double x = xOf(value), y = area.top() - 2;
        QPainterPath handle;
        handle.moveTo(x, y);
        handle.lineTo(x + 5, y + 4.5);
        handle.lineTo(x + 5, y + 12);
        handle.lineTo(x - 5, y + 12);
        handle.lineTo(x - 5, y + 4.5);
        handle.closeSubpath();
        painter.drawPath(handle);
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(c.focus, 2));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    }
}

PaletteBar::Handle PaletteBar::handleAt(double x) const {
    const double toFirst = std::abs(x - xOf(m_scale.range.first)), toLast = std::abs(x - xOf(m_scale.range.last));
    if (std::min(toFirst, toLast) > 9) return Handle::Both;
    return toFirst <= toLast ? Handle::First : Handle::Last;
}

void PaletteBar::moveHandle(Handle handle, double by, PaletteRange from) {
    const bool centred = m_scale.palette == pipeline::Palette::Diverging;
    if (handle != Handle::Last) from.first += by;
    if (handle != Handle::First) from.last += by;
    // A diverging palette keeps 0 in its middle: its ends move against each other.
    if (centred && handle == Handle::First) from.last = -from.first;
    if (centred && handle == Handle::Last) from.first = -from.last;
    if (centred && handle == Handle::Both) return;
    if (from.first != from.last) emit rangeChosen(from);
}

void PaletteBar::mousePressEvent(QMouseEvent* event) {
    m_handle = handleAt(event->position().x());
    m_pressedAt = event->position().x();
    m_pressedRange = m_scale.range;
}

void PaletteBar::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton)
        moveHandle(m_handle, valueAt(event->position().x()) - valueAt(m_pressedAt), m_pressedRange);
}

void PaletteBar::mouseDoubleClickEvent(QMouseEvent* event) {
    const double first = xOf(m_scale.range.first), last = xOf(m_scale.range.last), x = event->position().x();
    const Handle handle = std::abs(x - first) <= std::abs(x - last) ? Handle::First : Handle::Last;
    const double before = handle == Handle::First ? m_scale.range.first : m_scale.range.last;
    // As text: a spin box has a fixed number of digits behind the point, and 3e-8 none of them.
    bool entered = false;
    QString text = toQString(pipeline::shortestText(before));
    do {
        text = QInputDialog::getText(this, tr("Range"), tr("Value at this end of the palette"), QLineEdit::Normal, text,
                                     &entered);
        const auto value = pipeline::parseNumber(text.trimmed().toStdString());
        if (entered && value) return moveHandle(handle, *value - before, m_scale.range);
    } while (entered);
}

void PaletteBar::keyPressEvent(QKeyEvent* event) {
    const int direction = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    if (direction == 0) return QWidget::keyPressEvent(event);
    const Handle handle = event->modifiers() & Qt::ShiftModifier ? Handle::Last : Handle::First;
    moveHandle(handle, direction * (m_scale.high - m_scale.low) / 50, m_scale.range);
}

}  // namespace app
