#include "app/view3d/overlay.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/core/text.h"

namespace app {

namespace {

constexpr double kLetterGap = 21, kTipGap = 17, kBeyondTip = 14, kBorder = 16, kHalo = 5;

QPointF toPoint(glm::dvec2 p) { return {p.x, p.y}; }

glm::dvec2 unit(glm::dvec2 v, glm::dvec2 otherwise) {
    const double length = glm::length(v);
    return length > 0 ? v / length : otherwise;
}

QFont fontOf(Label::Kind kind) {
    const Theme& theme = Theme::current();
    switch (kind) {
        case Label::Kind::Letter: {
            QFont font = theme.formula(21);
            font.setBold(true);
            font.setItalic(true);
            return font;
        }
        case Label::Kind::Axis: {
            QFont font = theme.formula(16);
            font.setItalic(true);
            return font;
        }
        case Label::Kind::Note:
        case Label::Kind::Plane: return theme.mono(12);
        case Label::Kind::Caption: break;
    }
    return theme.text(12);
}

// Text with a halo in the view's colour, so that it reads on any picture. `at` is its middle.
void paintText(QPainter& painter, glm::dvec2 at, const QString& text, const QFont& font, const QColor& ink,
               double halo) {
    const QFontMetricsF metrics(font);
    const QRectF tight = metrics.tightBoundingRect(text);
    QPainterPath path;
    path.addText(toPoint(at) - tight.center(), font, text);
    QColor back = Theme::current().colors().view;
    back.setAlphaF(0.88f);
    painter.strokePath(path, QPen(back, halo, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, ink);
}

// A few steps that push letters off each other and off tips; each step moves by what is missing.
void relax(std::vector<PlacedLabel>& labels, const std::vector<glm::dvec2>& tips, double scale) {
    for (int step = 0; step < 24; ++step)
        for (PlacedLabel& a : labels) {
            if (a.label.kind != Label::Kind::Letter) continue;
            glm::dvec2 push{0.0};
            for (const PlacedLabel& b : labels) {
                if (&a == &b || b.label.kind != Label::Kind::Letter) continue;
                const glm::dvec2 d = a.at - b.at;
                const double missing = kLetterGap * scale - glm::length(d);
                // Two letters in one place part sideways, in the order of the list.
                if (missing > 0) push += 0.5 * missing * unit(d, {&a < &b ? -1.0 : 1.0, 0});
            }
            for (const glm::dvec2& tip : tips) {
                const glm::dvec2 d = a.at - tip;
                const double missing = kTipGap * scale - glm::length(d);
                if (missing > 0) push += missing * unit(d, {0, -1});
            }
            a.at += 0.6 * push;
        }
}

// Where the way from the middle of the view to a point crosses the border.
glm::dvec2 borderPoint(const Projected& p, glm::dvec2 size) {
    const glm::dvec2 middle = size / 2.0, half = middle - kBorder;
    glm::dvec2 d = p.at - middle;
    if (!std::isfinite(d.x) || !std::isfinite(d.y) || glm::length(d) == 0) d = {0, 1};
    const double reach = std::max(std::abs(d.x) / half.x, std::abs(d.y) / half.y);
    return middle + d / std::max(reach, 1e-300);
}

void placeCaption(PlacedLabel& placed, const ViewFrame& view) {
    const Projected p = project(view.camera, view.size, placed.label.at);
    placed.mark = p.at;
    placed.atBorder = !p.inFront || p.at.x < kBorder || p.at.y < kBorder || p.at.x > view.size.x - kBorder ||
                      p.at.y > view.size.y - kBorder;
    QString text = toQString(placed.label.text);
    if (placed.atBorder) {
        text += toQString(placed.label.distance);
        placed.label.text = text.toStdString();
        placed.mark = borderPoint(p, view.size);
    }
    const QFontMetricsF metrics(fontOf(Label::Kind::Caption));
    const double width = metrics.horizontalAdvance(text), gap = 14;
    if (placed.atBorder) {
        // Inwards: beside the mark at a side, under or over it at the top or the foot.
        const bool right = placed.mark.x > view.size.x / 2;
        placed.at = placed.mark + glm::dvec2((right ? -1 : 1) * (width / 2 + gap), 0);
    } else {
        placed.at = placed.mark - glm::dvec2(0, gap + 4);
    }
    placed.at.x = std::clamp(placed.at.x, width / 2 + 8, std::max(width / 2 + 8, view.size.x - width / 2 - 8));
    placed.at.y = std::clamp(placed.at.y, 12.0, std::max(12.0, view.size.y - 12));
}

// Captions make room for letters, upwards; those that lie on each other part upwards and
// downwards, and one at the border stays.
void partCaptions(std::vector<PlacedLabel>& labels) {
    const QFontMetricsF metrics(fontOf(Label::Kind::Caption));
    const auto width = [&](const PlacedLabel& p) { return metrics.horizontalAdvance(toQString(p.label.text)); };
    const double line = metrics.height();
    for (PlacedLabel& caption : labels)
        for (const PlacedLabel& letter : labels) {
            if (caption.label.kind != Label::Kind::Caption || letter.label.kind != Label::Kind::Letter) continue;
            const glm::dvec2 d = glm::abs(caption.at - letter.at);
            if (!caption.atBorder && d.x < width(caption) / 2 + 8 && d.y < line)
                caption.at.y = letter.at.y - 1.3 * line;
        }
    for (PlacedLabel& a : labels)
        for (PlacedLabel& b : labels) {
            if (&a <= &b || a.label.kind != Label::Kind::Caption || b.label.kind != Label::Kind::Caption) continue;
            const glm::dvec2 d = a.at - b.at;
            if (std::abs(d.x) > (width(a) + width(b)) / 2 + 6 || std::abs(d.y) > line) continue;
            PlacedLabel& moved = a.atBorder ? b : a;
            const PlacedLabel& stays = a.atBorder ? a : b;
            moved.at.y = stays.at.y + (moved.at.y < stays.at.y && stays.at.y > 2 * line ? -line : line);
        }
}

void paintBorderMark(QPainter& painter, const PlacedLabel& placed) {
    const ThemeColors& colors = Theme::current().colors();
    const QColor ink = colorOf(placed.label.ink, colors);
    painter.setPen(QPen(ink, 2.5));
    painter.setBrush(placed.label.ink == Ink::V ? QBrush(colors.view) : QBrush(ink));
    painter.drawEllipse(toPoint(placed.mark), 5.5, 5.5);
}

// White in black, seen on every picture: a square stands for a pixel, as in the buffer views.
void paintMarker(QPainter& painter, const Drawing::Marker& marker, const ViewFrame& view, bool square) {
    const Projected p = project(view.camera, view.size, marker.at);
    if (!p.inFront) return;
    painter.setPen(QPen(Qt::black, 1.8, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.setBrush(marker.hidden ? Qt::NoBrush : QBrush(Qt::white));
    if (square)
        painter.drawRect(QRectF(p.at.x - 3.5, p.at.y - 3.5, 7, 7));
    else
        painter.drawEllipse(toPoint(p.at), 4.2, 4.2);
}

}  // namespace

std::vector<PlacedLabel> placeLabels(const Drawing& drawing, const ViewFrame& view, double scale) {
    std::vector<PlacedLabel> result;
    std::vector<glm::dvec2> tips;
    for (const Label& label : drawing.labels) {
        PlacedLabel placed{label, {}, {}, false};
        const Projected p = project(view.camera, view.size, label.at);
        if (label.kind == Label::Kind::Caption) {
            placeCaption(placed, view);
            result.push_back(placed);
            continue;
        }
        if (!p.inFront) continue;
        const glm::dvec2 foot = project(view.camera, view.size, label.foot).at;
        placed.mark = p.at;
        placed.at = label.kind == Label::Kind::Note ? p.at : p.at + kBeyondTip * scale * unit(p.at - foot, {0, -1});
        if (label.kind == Label::Kind::Plane) {
            const double width = QFontMetricsF(fontOf(label.kind)).horizontalAdvance(toQString(label.text));
            placed.at.x += (p.at.x < foot.x ? -0.5 : 0.5) * width;
            placed.at.x = std::clamp(placed.at.x, width / 2 + 8, std::max(width / 2 + 8, view.size.x - width / 2 - 8));
            placed.at.y = std::clamp(placed.at.y, 12.0, std::max(12.0, view.size.y - 12));
        }
        if (label.kind == Label::Kind::Letter) tips.push_back(p.at);
        result.push_back(placed);
    }
    relax(result, tips, scale);
    partCaptions(result);
    return result;
}

void paintProbe(QPainter& painter, Vec3d point, const ViewFrame& view) {
    const Projected p = project(view.camera, view.size, point);
    if (!p.inFront) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(Qt::black, 3), QPen(Qt::white, 1.5)}) {
        painter.setPen(pen);
        painter.drawEllipse(toPoint(p.at), 5, 5);
    }
    painter.restore();
}

void paintOverlay(QPainter& painter, const Drawing& drawing, const ViewFrame& view) {
    const Theme& theme = Theme::current();
    const ThemeColors& colors = theme.colors();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (drawing.point) paintMarker(painter, *drawing.point, view, true);
    if (drawing.foot) paintMarker(painter, *drawing.foot, view, false);
    if (drawing.vertex) paintProbe(painter, *drawing.vertex, view);
    std::vector<PlacedLabel> labels = placeLabels(drawing, view, theme.scale());
    // Letters over captions.
    std::ranges::stable_partition(labels, [](const PlacedLabel& p) { return p.label.kind == Label::Kind::Caption; });
    for (const PlacedLabel& placed : labels) {
        const Label::Kind kind = placed.label.kind;
        if (placed.atBorder) paintBorderMark(painter, placed);
        const bool quiet = kind == Label::Kind::Caption;
        paintText(painter, placed.at, toQString(placed.label.text), fontOf(kind),
                  quiet ? colors.text2 : colorOf(placed.label.ink, colors), kHalo);
    }
    painter.restore();
}

}  // namespace app
