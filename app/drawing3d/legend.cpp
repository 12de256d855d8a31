#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/drawing3d/overlay.h"

namespace app {

namespace {

struct Entry {
    VectorCode code;
    const char* letter;
};
constexpr std::array<Entry, 5> kEntries{
    {{VectorCode::N, "N"}, {VectorCode::L, "L"}, {VectorCode::V, "V"}, {VectorCode::R, "R"}, {VectorCode::H, "H"}}};
constexpr double kEntryWidth = 62, kHeight = 32, kPadding = 10;
constexpr double kLastGap = 8;  // beyond the last letter, which the padding has already

// The tip in the plane, in pixels of the design: what the solid of the 3D view looks like from the side.
void paintTip(QPainter& painter, VectorCode code, const QColor& ink, const QColor& back) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    switch (code) {
        case VectorCode::N: painter.drawPolygon(QPolygonF({QPointF(), QPointF(-12, -4.5), QPointF(-12, 4.5)})); break;
        case VectorCode::L: painter.drawEllipse(QPointF(-4.5, 0), 4.5, 4.5); break;
        case VectorCode::V:
            painter.setPen(QPen(ink, 2.2));
            painter.setBrush(back);
            painter.drawEllipse(QPointF(-4.5, 0), 3.6, 3.6);
            break;
        case VectorCode::R:
            painter.setPen(QPen(ink, 2.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            painter.setBrush(Qt::NoBrush);
            painter.drawPolyline(QPolygonF({QPointF(-7, -5.5), QPointF(), QPointF(-7, 5.5)}));
            break;
        case VectorCode::H:
            painter.drawPolygon(QPolygonF({QPointF(), QPointF(-5.5, -4.5), QPointF(-11, 0), QPointF(-5.5, 4.5)}));
            break;
        case VectorCode::None: break;
    }
}

// The cube's faces: outward direction, and what their four corners are found from, in order.
struct Side {
    CubeFace face;
    Vec3d out, across;
};
constexpr std::array<Side, 6> kSides{{{CubeFace::X, {1, 0, 0}, {0, 1, 0}},
                                      {CubeFace::Y, {0, 1, 0}, {0, 0, 1}},
                                      {CubeFace::Z, {0, 0, 1}, {1, 0, 0}},
                                      {CubeFace::MinusX, {-1, 0, 0}, {0, 0, 1}},
                                      {CubeFace::MinusY, {0, -1, 0}, {1, 0, 0}},
                                      {CubeFace::MinusZ, {0, 0, -1}, {0, 1, 0}}}};

QPointF onCube(const QRectF& box, const OrbitCamera& camera, Vec3d p) {
    const double s = box.width() * 0.27;  // a cube's corner reaches √3 from its middle
    return box.center() + s * QPointF(glm::dot(p, camera.right), -glm::dot(p, camera.up));
}

QPolygonF outline(const QRectF& box, const OrbitCamera& camera, const Side& side) {
    const Vec3d u = side.across, v = glm::cross(side.out, u);
    QPolygonF polygon;
    for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        polygon << onCube(box, camera, side.out + double(a) * u + double(b) * v);
    return polygon;
}

bool faces(const OrbitCamera& camera, const Side& side) { return glm::dot(side.out, camera.forward) < -1e-9; }

}  // namespace

void paintVectorSample(QPainter& painter, const QRectF& box, VectorCode code, bool shown) {
    const Theme& theme = Theme::current();
    const ThemeColors& colors = theme.colors();
    const QColor ink = shown ? theme.vector(code) : colors.text3;
    const double s = theme.scale();
    const QPointF end(box.left() + 30 * s, box.center().y());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setOpacity(shown ? 1 : 0.6);
    // The arrow grows as the letter does.
    painter.save();
    painter.translate(end);
    painter.scale(s, s);
    QPen pen(ink, 2.4, Qt::SolidLine, code == VectorCode::H ? Qt::RoundCap : Qt::FlatCap);
    if (const auto dash = Theme::dash(code); !dash.isEmpty()) pen.setDashPattern(dash);
    painter.setPen(pen);
    painter.drawLine(QPointF(-30, 0), QPointF(code == VectorCode::R ? -2 : -9, 0));
    paintTip(painter, code, ink, colors.surface);
    painter.restore();
    QFont font = theme.formula(17);
    font.setBold(true);
    font.setItalic(true);
    font.setStrikeOut(!shown);
    for (const Entry& entry : kEntries)
        if (entry.code == code) {
            painter.setFont(font);
            painter.setPen(ink);
            painter.drawText(QRectF(end.x() + 6 * s, box.top(), box.right() - end.x(), box.height()),
                             Qt::AlignLeft | Qt::AlignVCenter, QString::fromUtf8(entry.letter));
        }
    painter.restore();
}

QSizeF legendSize(double room, int count) {
    const double s = Theme::current().scale();
    const auto sizeOf = [&](int columns) {
        const int rows = (count + columns - 1) / columns;
        return QSizeF(s * (kEntryWidth * columns + 2 * kPadding - kLastGap), s * kHeight * rows);
    };
    const QSizeF row = sizeOf(count);
    return row.width() <= room ? row : sizeOf((count + 1) / 2);
}

QRectF legendEntry(VectorCode code, const QRectF& legend) {
    const double s = Theme::current().scale();
    const int columns = int(std::lround((legend.width() / s - 2 * kPadding + kLastGap) / kEntryWidth));
    for (int i = 0; i < int(kEntries.size()); ++i)
        if (kEntries[std::size_t(i)].code == code)
            return {legend.topLeft() + s * QPointF(kPadding + kEntryWidth * (i % columns), kHeight * (i / columns)),
                    s * QSizeF(kEntryWidth, kHeight)};
    return {};
}

QRectF legendAt(glm::dvec2 size) {
    constexpr double kMargin = 12;
    const QSizeF legend = legendSize(size.x - 2 * kMargin);
    return {QPointF(kMargin, size.y - kMargin - legend.height()), legend};
}

void paintLegend(QPainter& painter, const QRectF& legend, const ViewOptions& options,
                 const std::optional<std::vector<VectorCode>>& only) {
    const ThemeColors& colors = Theme::current().colors();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colors.line, 1));
    painter.setBrush(colors.surface);
    painter.drawRoundedRect(legend.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    std::size_t next = 0;  // the places follow each other
    for (const Entry& entry : kEntries)
        if (!only || std::ranges::find(*only, entry.code) != only->end())
            paintVectorSample(painter, legendEntry(kEntries[next++].code, legend), entry.code,
                              options.shows(entry.code));
    painter.restore();
}

QString letterOf(CubeFace face, ViewSpace space) {
    for (const Side& side : kSides)
        if (side.face == face)
            for (const SpaceAxis& axis : axesOf(space)) {
                const double along = glm::dot(axis.direction, side.out);
                if (along > 0.5) return QString::fromUtf8(axis.name);
                if (along < -0.5) return QStringLiteral("−") + QString::fromUtf8(axis.name);
            }
    return {};
}

void paintCube(QPainter& painter, const QRectF& box, const OrbitCamera& camera, ViewSpace space) {
    const Theme& theme = Theme::current();
    const ThemeColors& colors = theme.colors();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colors.line, 1));
    painter.setBrush(colors.surface);
    painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    QFont font = theme.formula(13);
    font.setItalic(true);
    painter.setFont(font);
    const double s = theme.scale();
    for (const Side& side : kSides) {
        if (!faces(camera, side)) continue;
        const QPolygonF polygon = outline(box, camera, side);
        painter.setPen(QPen(colors.outline, 1.3 * s, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(colors.raised);
        painter.drawPolygon(polygon);
        // A face seen from the edge has no room for its letter.
        if (glm::dot(side.out, camera.forward) > -0.35) continue;
        painter.setPen(colors.text);
        const QPointF middle = onCube(box, camera, side.out);
        painter.drawText(QRectF(middle - s * QPointF(12, 12), s * QSizeF(24, 24)), Qt::AlignCenter,
                         letterOf(side.face, space));
    }
    painter.restore();
}

CubeFace cubeFaceAt(const QRectF& box, const OrbitCamera& camera, QPointF point) {
    if (!box.contains(point)) return CubeFace::None;
    const QPointF d = point - box.center();
    if (std::hypot(d.x(), d.y()) < 0.07 * box.width()) return CubeFace::Middle;
    for (const Side& side : kSides)
        if (faces(camera, side) && outline(box, camera, side).containsPoint(point, Qt::OddEvenFill)) return side.face;
    return CubeFace::None;
}

}  // namespace app
