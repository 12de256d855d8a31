#include "app/canvas/shape_picture.h"

#include <algorithm>
#include <functional>
#include <span>

#include "pipeline/stages/cull.h"

namespace app {

using pipeline::AnyBuffer;
using pipeline::Domain;
using pipeline::Palette;

namespace {

// None for a row without a value.
QColor colorOf(const AnyBuffer& buffer, std::size_t row, const BufferLook& look) {
    if (buffer.hasValue && !(*buffer.hasValue)[row]) return {};
    const pipeline::Color8 c =
        buffer.channels() == 3 && look.channel == lessons::ShownChannel::All
            ? elementColor(buffer, 0, row, look.range)
            : paletteColor(shownPalette(*buffer.info, look.channel), buffer.value(0, row, firstOf(look.channel)),
                           look.range.first, look.range.last);
    return {c.r, c.g, c.b};
}

QString rowText(const AnyBuffer& buffer, std::size_t row, lessons::ShownChannel channel) {
    const QStringList values = elementText(buffer, 0, row, channel);
    return values.size() == 1 ? values[0] : '(' + values.join(", ") + ')';
}

QRectF boxAround(const ShapePicture& picture, std::size_t polygon) {
    const auto corners = picture.topology->corners(polygon);
    QPointF least = picture.places[corners[0]], most = least;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const QPointF& at = picture.places[corners[i]];
        least = {std::min(least.x(), at.x()), std::min(least.y(), at.y())};
        most = {std::max(most.x(), at.x()), std::max(most.y(), at.y())};
    }
    return {least, most};
}

// Farthest first, so that the nearest lies on top.
void addPoints(ProjectedPolygons& projected, const AnyBuffer& buffer, const BufferLook& look,
               const std::stop_token& stop, ShapePicture& picture) {
    const bool isColor = buffer.info->palette == Palette::Color || buffer.info->unit.empty();
    std::ranges::stable_sort(projected.vertices, std::greater(),
                             [&](std::uint32_t v) { return projected.distances[v]; });
    for (const std::uint32_t v : projected.vertices) {
        if (stop.stop_requested()) return;
        if (v < buffer.rows())
            picture.points.push_back({picture.places[v], int(v), isColor ? colorOf(buffer, v, look) : QColor()});
    }
}

}  // namespace

Qt::BrushStyle hatchOfVerdict(char letter) {
    switch (letter) {
        case 'B': return Qt::BDiagPattern;
        case 'D': return Qt::Dense6Pattern;
        case 'C': return Qt::FDiagPattern;
        case 'O': return Qt::CrossPattern;
        case 'T': return Qt::DiagCrossPattern;
        default: return Qt::NoBrush;
    }
}

QPolygonF ShapePicture::outline(const Shape& shape) const {
    const auto corners = topology->corners(shape.outline.polygon);
    QPolygonF polygon;
    for (std::size_t i = 0; i < corners.size(); ++i) polygon << places[corners[i]];
    return polygon;
}

ShapePicture shapePicture(const pipeline::Frame& frame, const AnyBuffer& buffer, const BufferLook& look, bool isSmall,
                          const std::stop_token& stop) {
    ProjectedPolygons projected = projectPolygons(frame, stop);
    const auto kept =
        std::ranges::stable_partition(projected.polygons, std::logical_not(), &ProjectedPolygon::goesOn).begin();
    for (const auto& part : {std::span(projected.polygons.begin(), kept), std::span(kept, projected.polygons.end())}) {
        if (stop.stop_requested()) return {};
        std::ranges::stable_sort(part, std::greater(), &ProjectedPolygon::distance);
    }
    ShapePicture picture;
    picture.topology = std::move(projected.topology);
    picture.places = std::move(projected.places);
    picture.isSmall = isSmall;
    picture.shapes.reserve(projected.polygons.size());
    if (!isSmall) picture.boxes.reserve(projected.polygons.size());
    const bool onPolygons = buffer.info->domain == Domain::Polygon;
    const bool areVerdicts = onPolygons && buffer.info->palette == Palette::Verdict;
    picture.value = [buffer, areVerdicts, channel = look.channel](std::size_t row) {
        return areVerdicts ? QString::number(row) : rowText(buffer, row, channel);
    };
    for (const ProjectedPolygon& polygon : projected.polygons) {
        if (stop.stop_requested()) break;
        Shape& shape = picture.shapes.emplace_back(Shape{.outline = polygon, .fill = {}});
        if (onPolygons) shape.fill = colorOf(buffer, polygon.polygon, look);
        if (areVerdicts) shape.letter = pipeline::letter(pipeline::Verdict(int(buffer.flat(polygon.polygon))));
        if (!isSmall) picture.boxes.push_back(boxAround(picture, polygon.polygon));
    }
    if (buffer.info->domain == Domain::Vertex) addPoints(projected, buffer, look, stop, picture);
    return picture;
}

QRectF ShapePicture::boxOf(std::size_t shape) const {
    return boxes.empty() ? boxAround(*this, shapes[shape].outline.polygon) : boxes[shape];
}

int nearestPolygonAt(const ShapePicture& picture, QPointF at) {
    const Shape* nearest = nullptr;
    const auto isBefore = [](const ProjectedPolygon& a, const ProjectedPolygon& b) {
        return std::pair(!a.goesOn, a.distance) < std::pair(!b.goesOn, b.distance);
    };
    for (std::size_t i = 0; i < picture.shapes.size(); ++i) {
        if (!picture.boxOf(i).contains(at)) continue;
        const Shape& shape = picture.shapes[i];
        if (nearest && !isBefore(shape.outline, nearest->outline)) continue;
        if (picture.outline(shape).containsPoint(at, Qt::OddEvenFill)) nearest = &shape;
    }
    return nearest ? int(nearest->outline.polygon) : -1;
}

}  // namespace app
