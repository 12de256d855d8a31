#include "app/check/check_plot.h"

#include <QPainter>

#include "app/look/accessible.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/plot_painter.h"

namespace app {

CheckPlot::CheckPlot(QWidget* parent) : QWidget(parent) {
    setObjectName("checkPlot");
    setAccessibleRole(*this, QAccessible::Chart);
    setAccessibleName(tr("Errors of both forms over the range"));
    followTheme(this, [this] {
        updateGeometry();
        layOutAgain();
    });
}

QSize CheckPlot::minimumSizeHint() const { return {Theme::current().px(360), Theme::current().px(220)}; }

void CheckPlot::setPlot(KnobPlot plot) {
    m_plot = std::move(plot);
    QString words;
    if (m_plot.which && m_plot.now) {
        const auto number = [this](double error) {
            return toQString(pipeline::check::measured(error, m_plot.which->unit));
        };
        words = tr("%1 %2: naive %3, ours %4, bound %5")
                    .arg(toQString(m_plot.which->knob.label), QString::number(m_plot.now->at, 'g', 3),
                         number(m_plot.now->naive), number(m_plot.now->ours), number(m_plot.which->bound));
    }
    setAccessibleDescription(words);
    layOutAgain();
}

void CheckPlot::layOutAgain() {
    const double text = Theme::current().px(14);
    m_drawing = {};
    if (m_plot.which) m_drawing = layOut(m_plot, {std::max(width(), 320) * 1.0, std::max(height(), 200) * 1.0, text});
    update();
}

void CheckPlot::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.fillRect(rect(), theme.colors().view);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const pipeline::PlotLine& line : m_drawing.lines) draw(painter, line);
    for (const pipeline::PlotMarker& marker : m_drawing.markers) draw(painter, marker);
    for (const pipeline::PlotText& text : m_drawing.texts) draw(painter, text);
    if (m_plot.which && m_plot.curve.empty()) {
        painter.setPen(theme.colors().text2);
        painter.setFont(theme.text(14));
        painter.drawText(rect(), Qt::AlignCenter, tr("The curves are being computed."));
    }
}

void CheckPlot::resizeEvent(QResizeEvent*) { layOutAgain(); }

}  // namespace app
