#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/scene/hold/hold_kinds.h"
#include "pipeline/scene/object_matrix.h"

namespace pipeline {

namespace {

// Of the angle at which a plane is seen: below, it has no place for a hand.
constexpr double kLeastSine = 0.05;
constexpr int kHalvings = 24;
constexpr double kStepsOfObject = 100, kCoarse = 10;

// Twice the signed area of a polygon in the picture, with a vertex of it elsewhere. Nothing where one is behind the eye.
std::optional<double> areaWith(const Scene& scene, const Hold& hold, std::size_t polygon, const Vec3d& at) {
    const Object& object = scene.objects[hold.index];
    const View view = makeView(scene);
    const ObjectMatrix matrix = makeObjectMatrix(object.transform);
    std::vector<glm::dvec2> corners;
    for (const std::uint32_t v : object.mesh->polygon(polygon)) {
        const auto corner = projected(view, toWorld(matrix, v == hold.vertex ? at : object.mesh->positions[v]));
        if (!corner) return {};
        corners.push_back(*corner);
    }
    double area = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const glm::dvec2 a = corners[i] - corners[0], b = corners[i + 1] - corners[0];
        area += a.x * b.y - a.y * b.x;
    }
    return area;
}

// Whether no polygon of the vertex turns over in the picture when it goes there.
bool keepsSides(const Scene& scene, const Hold& hold, const Vec3d& to) {
    const Mesh& mesh = *scene.objects[hold.index].mesh;
    for (std::size_t p = 0; p < mesh.polygonCount(); ++p) {
        if (std::ranges::find(mesh.polygon(p), std::uint32_t(hold.vertex)) == mesh.polygon(p).end()) continue;
        const auto before = areaWith(scene, hold, p, mesh.positions[hold.vertex]), after = areaWith(scene, hold, p, to);
        if (before && *before != 0 && !(after && *after * *before > 0)) return false;
    }
    return true;
}

Vec3d vertexInWorld(const Scene& scene, const Hold& hold) {
    const Object& object = scene.objects[hold.index];
    return toWorld(makeObjectMatrix(object.transform), object.mesh->positions[hold.vertex]);
}
std::optional<HoldPlace> vertexPlace(const Scene& scene, const Hold& hold) {
    return placeInPicture(scene, vertexInWorld(scene, hold));
}

// Moves the vertex in its plane to where `to` is seen, or as near to it as its polygons allow.
Assignments vertexAt(const Scene& scene, const Hold& hold, glm::dvec2 to, bool coarse) {
    const Object& object = scene.objects[hold.index];
    const View view = makeView(scene);
    const ObjectMatrix matrix = makeObjectMatrix(object.transform);
    const Vec3d own = object.mesh->positions[hold.vertex], now = toWorld(matrix, own);
    const bool isInPicture = hold.axis == Vec3d(0);
    const Vec3d normal = isInPicture ? view.forward : normalMatrix(matrix) * hold.axis;
    // The line of sight through the pixel meets the plane.
    const Vec3d start = worldPoint(view, to, 0), way = worldPoint(view, to, 1) - start;
    const double steep = glm::dot(normal, way), t = glm::dot(normal, now - start) / steep;
    const bool isSeen = std::abs(steep) >= kLeastSine * glm::length(normal) * glm::length(way);
    const Vec3d there = glm::inverse(matrix.linear) * (start + t * way - matrix.translation);
    Vec3d best = own;
    if (isSeen && (t > 0 || !view.perspective) && std::isfinite(there.x + there.y + there.z)) {
        const double step = powerBelow(2 * hold.high / kStepsOfObject) * (coarse ? kCoarse : 1);
        const auto rounded = [&](double share) {
            Vec3d at;
            for (int i = 0; i < 3; ++i)
                at[i] = hold.axis[i] != 0 ? own[i]
                                          : roundedTo(std::clamp(own[i] + share * (there[i] - own[i]),
                                                                 hold.point[i] - hold.high, hold.point[i] + hold.high),
                                                      step);
            return at;
        };
        double low = 0, high = 1;
        best = rounded(1);
        if (!hold.turnsOver && !keepsSides(scene, hold, best)) {
            best = own;
            for (int i = 0; i < kHalvings; ++i) {
                const double middle = (low + high) / 2;
                const Vec3d at = rounded(middle);
                const bool keeps = keepsSides(scene, hold, at);
                (keeps ? low : high) = middle;
                if (keeps) best = at;
            }
        }
    }
    return {{hold.keys[0], best.x}, {hold.keys[1], best.y}, {hold.keys[2], best.z}};
}
Assignments vertexDragged(const Scene& start, const Hold& hold, const Drag& drag) {
    return vertexAt(start, hold, drag.target(), drag.isCoarse);
}
Assignments vertexNudged(const Scene& scene, const Hold& hold, glm::ivec2 by, bool coarse) {
    const auto place = vertexPlace(scene, hold);
    if (!place) return valuesOf(scene, hold);
    const double half = radiusAround(scene, makeView(scene), middleOf(scene, hold.index), hold.index);
    return vertexAt(scene, hold, place->at + glm::dvec2(by) * (coarse ? 0.4 : 0.1) * half, false);
}
std::string vertexWords(const Scene& scene, const Hold& hold) {
    std::string words = hold.axis == Vec3d(0) ? fmt::format("{}: ", hold.vertex) : "";
    for (std::size_t i = 0; i < 3; ++i)
        if (hold.axis[int(i)] == 0) words += valueText(scene, hold, i) + ", ";
    words.resize(words.size() - 2);
    return words;
}

}  // namespace

const HoldKindRow kVertex{"vertex", vertexPlace, vertexDragged, vertexNudged, vertexWords};

}  // namespace pipeline
