#include "app/canvas/edge_painter.h"

#include <QFontMetricsF>
#include <cmath>

#include "app/look/numbers.h"
#include "app/look/theme.h"

namespace app {

using pipeline::EdgeSide;
using pipeline::EdgeView;

namespace {

constexpr double kGrid = double(pipeline::kEdgeUnits);

QPointF toPixels(glm::i64vec2 corner) { return {double(corner.x) / kGrid, double(corner.y) / kGrid}; }

void paintSamples(QPainter& painter, const EdgeView& view, const Placement& placement, QRect pixels) {
    const ThemeColors& c = Theme::current().colors();
    const double radius = std::clamp(placement.zoom / 7, 2.0, 5.0);
    // Below the numbers of a pixel that is large enough for them.
    const double down = placement.zoom >= kWeightsZoom ? 0.36 : 0;
    for (int y = pixels.top(); y <= pixels.bottom(); ++y)
        for (int x = pixels.left(); x <= pixels.right(); ++x) {
            const pipeline::EdgeSample sample = edgesAt(view, {x, y});
            const QPointF centre = placement.toWidget(QPointF(x + 0.5, y + 0.5));
            painter.setPen(QPen(Qt::black, 1));
            painter.setBrush(sample.covered() ? QBrush(c.run) : QBrush(Qt::white));
            if (down == 0) {
                painter.drawEllipse(centre, sample.covered() ? radius : radius * 0.6,
                                    sample.covered() ? radius : radius * 0.6);
                continue;
            }
            for (int i = 0; i < 3; ++i) {  // one mark an edge: inside or not
                painter.setBrush(sample.inside[std::size_t(i)] ? QBrush(c.run) : QBrush(Qt::white));
                painter.drawEllipse(centre + QPointF((i - 1) * 11, down * placement.zoom), 3.5, 3.5);
            }
        }
}

void paintEdge(QPainter& painter, const EdgeView& view, int edge, const Placement& placement) {
    const ThemeColors& c = Theme::current().colors();
    const auto ends = edgeEnds(view, edge);
    const QPointF from = placement.toWidget(toPixels(ends[0])), to = placement.toWidget(toPixels(ends[1]));
    const EdgeSide side = edgeSide(view, edge);
    painter.setPen(QPen(Qt::black, 4));
    painter.drawLine(from, to);
    QPen pen(side == EdgeSide::Other ? QColor(Qt::white) : c.accent, 2);
    if (side == EdgeSide::Other) pen.setDashPattern({4, 3});
    painter.setPen(pen);
    painter.drawLine(from, to);
}

void paintName(QPainter& painter, const EdgeView& view, int edge, const Placement& placement, QRectF seen) {
    const ThemeColors& c = Theme::current().colors();
    const auto ends = edgeEnds(view, edge);
    const QPointF from = placement.toWidget(toPixels(ends[0])), to = placement.toWidget(toPixels(ends[1]));
    // The middle of what is seen of the edge.
    QPointF sum;
    int inside = 0;
    constexpr int kSteps = 200;
    for (int i = 0; i <= kSteps; ++i) {
        const QPointF at = from + (to - from) * i / kSteps;
        if (!seen.contains(at)) continue;
        sum += at;
        ++inside;
    }
    if (inside == 0) return;
    const EdgeSide side = edgeSide(view, edge);
    const QString words = side == EdgeSide::Left ? "left, owns" : side == EdgeSide::Top ? "top, owns" : "owns not";
    const QString name = QString("e%1 %2").arg(QChar(0x2080 + edge)).arg(words);
    painter.setFont(Theme::current().text(12, 600));
    const QFontMetricsF metrics(painter.font());
    QRectF chip(0, 0, metrics.horizontalAdvance(name) + 10, metrics.height() + 4);
    chip.moveCenter(sum / inside);
    chip.moveLeft(std::clamp(chip.left(), seen.left(), std::max(seen.left(), seen.right() - chip.width())));
    chip.moveTop(std::clamp(chip.top(), seen.top(), std::max(seen.top(), seen.bottom() - chip.height())));
    painter.setPen(c.line);
    painter.setBrush(c.surface);
    painter.drawRoundedRect(chip, 4, 4);
    painter.setPen(c.text);
    painter.drawText(chip, Qt::AlignCenter, name);
}

}  // namespace

void paintEdgeView(QPainter& painter, const EdgeView& view, const Placement& placement, QRect pixels) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (placement.zoom >= kEdgeZoom) paintSamples(painter, view, placement, pixels);
    for (int i = 0; i < 3; ++i) paintEdge(painter, view, i, placement);
    const QRectF seen(placement.toWidget(pixels.topLeft()), placement.toWidget(pixels.bottomRight() + QPoint(1, 1)));
    for (int i = 0; i < 3; ++i) paintName(painter, view, i, placement, seen);
    painter.restore();
}

QStringList edgeText(const EdgeView& view, int x, int y) {
    const pipeline::EdgeSample sample = edgesAt(view, {x, y});
    QStringList lines;
    for (std::size_t i = 0; i < 3; ++i) {
        const double weight = double(sample.values[i]) / double(view.area2);
        const QString value = sample.values[i] == 0 ? (sample.inside[i] ? "0 own" : "0 not") : number(weight, 3);
        lines << QString("λ%1 %2").arg(QChar(0x2080 + int(i))).arg(value);
    }
    return lines;
}

}  // namespace app
