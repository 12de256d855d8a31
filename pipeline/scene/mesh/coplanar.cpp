#include "pipeline/scene/mesh/coplanar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pipeline/core/numerics.h"
#include "pipeline/core/text.h"
#include "pipeline/scene/object_matrix.h"
#include "pipeline/scene/opacity.h"

namespace pipeline {
namespace {

constexpr std::size_t kMostPairs = 4'000'000;  // that are compared: some tenths of a second
constexpr double kApart = 1e-9;                // of the scene's size, and of a normal: what rounding explains

struct PlaneTriangle {
    std::array<std::int64_t, 4> plane;  // its normal and distance, in steps of kApart
    std::uint32_t object = 0;
    std::array<glm::dvec2, 3> corners;  // along the plane, in shares of the scene's size
};

// Whether a line along an edge of the first parts them, but for what rounding explains.
bool isParted(const PlaneTriangle& a, const PlaneTriangle& b) {
    for (int i = 0; i < 3; ++i) {
        const glm::dvec2 from = a.corners[i], along = a.corners[(i + 1) % 3] - from;
        const auto side = [&](const glm::dvec2& p) { return along.x * (p.y - from.y) - along.y * (p.x - from.x); };
        const double own = side(a.corners[(i + 2) % 3]), sign = own < 0 ? -1 : 1;
        const double most = std::max({sign * side(b.corners[0]), sign * side(b.corners[1]), sign * side(b.corners[2])});
        if (most <= 1e3 * kApart * glm::length(along)) return true;
    }
    return false;
}

std::vector<PlaneTriangle> trianglesOf(const Scene& scene, StopCheck& check) {
    std::vector<Vec3d> places;
    double size = 0;
    std::vector<PlaneTriangle> triangles;
    for (const bool measures : {true, false})  // the size is known once all have been seen
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            const Object& object = scene.objects[i];
            if (isTransparent(object, scene.settings)) continue;
            const ObjectMatrix matrix = makeObjectMatrix(object.transform);
            places.clear();
            for (const Vec3d& p : object.mesh->positions) {
                if (check.stopped()) return {};
                places.push_back(toWorld(matrix, p));
                if (measures) size = std::max(size, largestComponent(places.back()));
            }
            if (measures || !(size > 0)) continue;
            for (const Triangle& triangle : object.mesh->triangles) {
                if (check.stopped(3)) return {};
                const auto corner = [&](int k) { return places[triangle.vertices[k]] / size; };
                const Vec3d a = corner(0), b = corner(1), c = corner(2);
                const Vec3d normal = normalized(glm::cross(b - a, c - a)) * (matrix.mirrors ? -1.0 : 1.0);
                if (normal == Vec3d(0)) continue;
                const Vec3d length = glm::abs(normal);
                const int axis = length.x > length.y && length.x > length.z ? 0 : length.y > length.z ? 1 : 2;
                const auto flat = [&](const Vec3d& p) { return glm::dvec2(p[(axis + 1) % 3], p[(axis + 2) % 3]); };
                const auto steps = [](double value) { return std::llround(value / (1e3 * kApart)); };
                triangles.push_back({{steps(normal.x), steps(normal.y), steps(normal.z), steps(glm::dot(normal, a))},
                                     std::uint32_t(i),
                                     {flat(a), flat(b), flat(c)}});
            }
        }
    std::ranges::stable_sort(triangles, {}, &PlaneTriangle::plane);
    return triangles;
}

}  // namespace

void remarkOnCoplanar(const Scene& scene, StopCheck& check, AlikeRemarks& remarks) {
    std::size_t all = 0;
    for (const Object& object : scene.objects) all += object.mesh->triangles.size();
    if (scene.objects.size() < 2 || all > kMostCoplanarTriangles) return;
    const std::vector<PlaneTriangle> triangles = trianglesOf(scene, check);
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t k = i + 1; k < triangles.size() && triangles[k].plane == triangles[i].plane; ++k) {
            if (check.stopped() || ++pairs > kMostPairs) return;
            const PlaneTriangle &a = triangles[i], &b = triangles[k];
            if (a.object == b.object || found.contains({a.object, b.object}) || isParted(a, b) || isParted(b, a))
                continue;
            found.insert({a.object, b.object});
            const std::string first = inQuotes(scene.objects[a.object].name),
                              second = inQuotes(scene.objects[b.object].name);
            remarks.add(
                "coplanar", first + " and " + second,
                {scene.objects[b.object].name,
                 fmt::format("Polygons of {} and {} lie in the same plane and overlap: rounding decides at each "
                             "pixel which is seen (z-fighting). Move one of them a little.",
                             first, second)});
        }
}

}  // namespace pipeline
