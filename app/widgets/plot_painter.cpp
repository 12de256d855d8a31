#include "app/widgets/plot_painter.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>

#include "app/look/text.h"
#include "app/look/theme.h"

namespace app {

using pipeline::PlotInk;
using pipeline::PlotLine;
using pipeline::PlotMarker;
using pipeline::PlotRole;
using pipeline::PlotText;

// The series' colours are the vectors': chosen so that every kind of colour blindness tells them apart.
QColor plotColor(PlotInk ink) {
    const ThemeColors& c = Theme::current().colors();
    const std::array series{c.L, c.V, c.H, c.R, c.N};
    switch (ink.role) {
        case PlotRole::Text: return c.text;
        case PlotRole::Secondary: return c.text2;
        case PlotRole::Grid: return c.line;
        case PlotRole::Front: return c.text;
        case PlotRole::Equal: return c.text3;
        case PlotRole::Failed: return c.failed;
        case PlotRole::Series: return series[ink.series % series.size()];
    }
    return c.text;
}

void draw(QPainter& painter, const PlotLine& line) {
    QPen pen(plotColor(line.ink), line.width);
    const std::vector<double> dashes = pipeline::dashes(line.dash);
    if (!dashes.empty()) pen.setDashPattern(QList<qreal>(dashes.begin(), dashes.end()));
    pen.setCapStyle(line.dash == pipeline::PlotDash::Dotted ? Qt::RoundCap : Qt::FlatCap);
    pen.setJoinStyle(Qt::RoundJoin);
    painter.setPen(pen);
    QPolygonF points;
    for (const auto& point : line.points) points << QPointF(point.x, point.y);
    painter.drawPolyline(points);
}

void draw(QPainter& painter, const PlotMarker& marker) {
    const QColor ink = plotColor(marker.ink), ground = Theme::current().colors().view;
    const double stroke = marker.size / 7, size = marker.filled ? marker.size : marker.size - stroke;
    painter.setBrush(marker.filled ? ink : ground);
    painter.setPen(QPen(marker.filled ? ground : ink, marker.filled ? stroke / 2 : stroke));
    const auto corners = pipeline::outline(marker.shape);
    QPolygonF outline;
    for (const auto& corner : corners) outline << QPointF(marker.at.x + size * corner.x, marker.at.y + size * corner.y);
    if (corners.empty())
        painter.drawEllipse(QPointF(marker.at.x, marker.at.y), size / 2, size / 2);
    else
        painter.drawPolygon(outline);
    painter.setBrush(Qt::NoBrush);
}

void draw(QPainter& painter, const PlotText& text) {
    QFont font = Theme::current().text(13, text.bold ? 600 : 400);
    font.setPixelSize(std::max(1, int(text.size)));
    const QString words = toQString(text.text);
    const double width = QFontMetricsF(font).horizontalAdvance(words);
    const double before = text.anchor == PlotText::Anchor::Start    ? 0
                          : text.anchor == PlotText::Anchor::Middle ? width / 2
                                                                    : width;
    painter.save();
    painter.translate(text.at.x, text.at.y);
    if (text.upwards) painter.rotate(-90);
    QPainterPath path;
    path.addText(-before, 0, font, words);
    // A rim of background keeps lines that cross a text away from its letters.
    painter.strokePath(path, QPen(Theme::current().colors().view, text.size / 4));
    painter.setPen(plotColor(text.ink));
    painter.setFont(font);
    painter.drawText(QPointF(-before, 0), words);
    painter.restore();
}

}  // namespace app
