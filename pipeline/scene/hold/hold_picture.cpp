#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/scene/hold/hold_solve.h"
#include "pipeline/scene/object_matrix.h"

// Places of a scene in its picture.

namespace pipeline {

namespace {

constexpr double kLeastRadius = 24, kMostRadius = 0.45;  // of a lamp's 90°: pixels, and of the picture's height

// Of the objects' vertices, or of one object's.
template <class Visit>
void eachVertex(const Scene& scene, std::optional<std::size_t> only, Visit visit) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (only && *only != i) continue;
        const ObjectMatrix matrix = makeObjectMatrix(scene.objects[i].transform);
        for (const Vec3d& position : scene.objects[i].mesh->positions) visit(toWorld(matrix, position));
    }
}

}  // namespace

Vec3d middleOf(const Scene& scene, std::size_t object) {
    Vec3d low(std::numeric_limits<double>::infinity()), high = -low;
    eachVertex(scene, object, [&](const Vec3d& p) { low = glm::min(low, p), high = glm::max(high, p); });
    return low.x <= high.x ? low + (high - low) / 2.0 : scene.objects[object].transform.translation;
}
double radiusAround(const Scene& scene, const View& view, Vec3d point, std::optional<std::size_t> only) {
    const auto middle = projected(view, point);
    double radius = kLeastRadius;
    if (middle)
        eachVertex(scene, only, [&](const Vec3d& p) {
            if (const auto at = projected(view, p)) radius = std::max(radius, glm::length(*at - *middle));
        });
    return std::min(radius, kMostRadius * view.size.y);
}
double reachOf(const Scene& scene) {
    Vec3d low(-1.0), high(1.0);
    eachVertex(scene, {}, [&](const Vec3d& p) { low = glm::min(low, p), high = glm::max(high, p); });
    return 2 * glm::length(high - low);
}

std::optional<glm::dvec2> projected(const View& view, Vec3d world) {
    const Vec3d p = toView(view, world);
    if (view.perspective && !(p.z > 0)) return {};
    const double w = view.perspective ? p.z : 1;
    const glm::dvec2 at{view.centre.x + view.scale.x * p.x / w, view.centre.y - view.scale.y * p.y / w};
    return std::isfinite(at.x) && std::isfinite(at.y) ? std::optional(at) : std::nullopt;
}
std::optional<HoldPlace> placeInPicture(const Scene& scene, const Vec3d& world) {
    const auto at = projected(makeView(scene), world);
    return at ? std::optional(HoldPlace{*at}) : std::nullopt;
}

Scene withValues(Scene scene, const Assignments& values) {
    for (const auto& [key, value] : values)
        if (const auto ref = findSetting(scene, key)) ref->set(scene, value);
    return scene;
}

}  // namespace pipeline
