#include "app/study/study_plot.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "app/look/accessible.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/plot_painter.h"

namespace app {

using pipeline::PlotLine;
using pipeline::PlotMarker;
using pipeline::PlotText;

StudyPlot::StudyPlot(QWidget* parent) : QWidget(parent) {
    setObjectName("studyPlot");
    setAccessibleRole(*this, QAccessible::Chart);
    setAccessibleName(tr("Plot of error against run time"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    followTheme(this, [this] { layOut(); });
}

QSize StudyPlot::minimumSizeHint() const { return {Theme::current().px(360), Theme::current().px(170)}; }

void StudyPlot::setPlot(pipeline::Plot plot, QStringList tips) {
    m_plot = std::move(plot);
    m_tips = std::move(tips);
    m_hovered.reset();
    layOut();
}

void StudyPlot::select(std::optional<std::size_t> point) {
    m_selected = point;
    update();
}

void StudyPlot::layOut() {
    const double text = Theme::current().px(14);
    m_drawing = pipeline::layOut(m_plot, {std::max(width(), 320) * 1.0, std::max(height(), 240) * 1.0, text});
    update();
}

std::optional<QPointF> StudyPlot::placeOf(std::size_t point) const {
    for (const PlotMarker& marker : m_drawing.markers)
        if (marker.point == point) return QPointF(marker.at.x, marker.at.y);
    return std::nullopt;
}

// The nearest within the size of a marker.
std::optional<std::size_t> StudyPlot::pointAt(QPointF place) const {
    std::optional<std::size_t> nearest;
    double best = 0;
    for (const PlotMarker& marker : m_drawing.markers) {
        const double distance = std::hypot(marker.at.x - place.x(), marker.at.y - place.y());
        if (!marker.point || distance > marker.size || (nearest && distance >= best)) continue;
        nearest = marker.point;
        best = distance;
    }
    return nearest;
}

bool StudyPlot::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const auto point = pointAt(help->pos());
    if (point && qsizetype(*point) < m_tips.size())
        QToolTip::showText(help->globalPos(), m_tips[qsizetype(*point)], this);
    else
        QToolTip::hideText();
    return true;
}

void StudyPlot::paintEvent(QPaintEvent*) {
    const ThemeColors& colors = Theme::current().colors();
    QPainter painter(this);
    painter.fillRect(rect(), colors.view);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const PlotLine& line : m_drawing.lines) draw(painter, line);
    for (const PlotMarker& marker : m_drawing.markers) {
        if (!marker.point) continue;
        const QPointF at(marker.at.x, marker.at.y);
        if (marker.point == m_selected) {
            painter.setPen(QPen(colors.focus, marker.size / 6));
            painter.drawEllipse(at, marker.size, marker.size);
        }
        if (marker.point == m_hovered) {
            painter.setPen(QPen(colors.accent, 1));
            painter.drawEllipse(at, marker.size * 0.8, marker.size * 0.8);
        }
    }
    for (const PlotMarker& marker : m_drawing.markers) draw(painter, marker);
    for (const PlotText& text : m_drawing.texts) draw(painter, text);
    if (hasFocus()) {
        painter.setPen(QPen(colors.focus, 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void StudyPlot::resizeEvent(QResizeEvent*) { layOut(); }

void StudyPlot::mouseMoveEvent(QMouseEvent* event) {
    const auto point = pointAt(event->position());
    if (point == m_hovered) return;
    m_hovered = point;
    setCursor(point ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

void StudyPlot::leaveEvent(QEvent*) {
    m_hovered.reset();
    update();
}

void StudyPlot::mousePressEvent(QMouseEvent* event) {
    if (const auto point = pointAt(event->position()); point && event->button() == Qt::LeftButton) emit chosen(*point);
}

void StudyPlot::keyPressEvent(QKeyEvent* event) {
    const bool back = event->key() == Qt::Key_Left, on = event->key() == Qt::Key_Right;
    std::vector<const PlotMarker*> order;
    for (const PlotMarker& marker : m_drawing.markers)
        if (marker.point) order.push_back(&marker);
    if ((!back && !on) || order.empty()) return QWidget::keyPressEvent(event);
    std::ranges::stable_sort(order, {}, [](const PlotMarker* marker) { return marker->at.x; });
    const auto now = std::ranges::find_if(order, [this](const PlotMarker* m) { return m->point == m_selected; });
    auto next = now;
    if (now == order.end())
        next = order.begin();
    else if (back && now != order.begin())
        --next;
    else if (on && now + 1 != order.end())
        ++next;
    if (next != now) emit chosen(*(*next)->point);
}

}  // namespace app
