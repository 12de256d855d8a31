#include "app/tables/scanline_plot_view.h"

#include <QMouseEvent>
#include <QPainter>

#include "app/look/accessible.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/plot_painter.h"

namespace app {

ScanlinePlotView::ScanlinePlotView(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleRole(*this, QAccessible::Chart);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Section along a row"));
    followTheme(this, [this] {
        updateGeometry();
        layOutAgain();
    });
}

QSize ScanlinePlotView::sizeHint() const { return {Theme::current().px(900), Theme::current().px(300)}; }
QSize ScanlinePlotView::minimumSizeHint() const { return {200, 170}; }

pipeline::PlotSize ScanlinePlotView::plotSize() const {
    return {double(width()), double(height()), double(Theme::current().px(13.5))};
}

void ScanlinePlotView::setSection(std::shared_ptr<const pipeline::ScanlineSection> section, int channel) {
    m_section = std::move(section);
    m_channel = channel;
    layOutAgain();
}

void ScanlinePlotView::setSentence(const QString& sentence) {
    m_sentence = sentence;
    update();
}

void ScanlinePlotView::setMarks(std::optional<int> picked, std::optional<int> hovered) {
    if (picked == m_picked && hovered == m_hovered) return;
    m_picked = picked;
    m_hovered = hovered;
    layOutAgain();
}

void ScanlinePlotView::layOutAgain() {
    m_drawing = {};
    if (m_section && !m_section->empty())
        m_drawing = layOut(pipeline::ScanlinePlot{m_section.get(), m_channel, m_picked, m_hovered}, plotSize());
    update();
}

void ScanlinePlotView::resizeEvent(QResizeEvent*) { layOutAgain(); }

void ScanlinePlotView::paintEvent(QPaintEvent*) {
    const ThemeColors& c = Theme::current().colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), c.view);
    for (const pipeline::PlotLine& line : m_drawing.lines) draw(painter, line);
    for (const pipeline::PlotMarker& marker : m_drawing.markers) draw(painter, marker);
    for (const pipeline::PlotText& text : m_drawing.texts) draw(painter, text);
    if (m_drawing.lines.empty()) {
        painter.setFont(Theme::current().text(13));
        painter.setPen(c.text2);
        painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, m_sentence);
    }
    if (hasFocus()) {
        painter.setPen(QPen(c.focus, 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

std::optional<int> ScanlinePlotView::pixelAt(double x) const {
    if (!m_section || m_section->empty()) return std::nullopt;
    const pipeline::ScanlineAxis axis = axesOf(*m_section, plotSize()).at(x);
    if (x < axis.left || x > axis.right) return std::nullopt;
    return axis.pixelAt(x);
}

void ScanlinePlotView::mouseMoveEvent(QMouseEvent* event) {
    const auto pixel = pixelAt(event->position().x());
    emit hovered(pixel);
    if (pixel && event->buttons() & Qt::LeftButton) emit picked(*pixel);
}

void ScanlinePlotView::mousePressEvent(QMouseEvent* event) {
    if (const auto pixel = pixelAt(event->position().x()); pixel && event->button() == Qt::LeftButton)
        emit picked(*pixel);
}

void ScanlinePlotView::leaveEvent(QEvent*) { emit hovered(std::nullopt); }

void ScanlinePlotView::wheelEvent(QWheelEvent* event) {
    m_wheel += event->angleDelta().y();
    const int steps = m_wheel / 120;
    m_wheel -= steps * 120;
    if (steps != 0) emit rowAsked(-steps);
    event->accept();
}

void ScanlinePlotView::keyPressEvent(QKeyEvent* event) {
    const int step = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    const auto aside = [&](int by) {
        if (m_section && m_picked) emit picked(std::clamp(*m_picked + by, 0, m_section->width - 1));
    };
    switch (event->key()) {
        case Qt::Key_Up: return emit rowAsked(-step);
        case Qt::Key_Down: return emit rowAsked(step);
        case Qt::Key_Left: return aside(-step);
        case Qt::Key_Right: return aside(step);
        default: QWidget::keyPressEvent(event);
    }
}

}  // namespace app
