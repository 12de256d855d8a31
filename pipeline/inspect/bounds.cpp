#include "pipeline/inspect/bounds.h"

#include <algorithm>

namespace pipeline {
namespace {

const Vec3d& farthestFrom(const Vec3d& from, std::span<const Vec3d> points) {
    return *std::ranges::max_element(points, {}, [&](const Vec3d& p) { return glm::length(p - from); });
}

BoundingSphere around(const Vec3d& centre, std::span<const Vec3d> points) {
    return {centre, glm::length(farthestFrom(centre, points) - centre)};
}

Vec3d ritterCentre(std::span<const Vec3d> points) {
    const Vec3d a = farthestFrom(points[0], points), b = farthestFrom(a, points);
    BoundingSphere sphere{(a + b) / 2.0, glm::length(b - a) / 2};
    for (const Vec3d& p : points) {
        const double distance = glm::length(p - sphere.centre);
        if (!(distance > sphere.radius)) continue;
        // Grows to touch the point and the far side of the sphere so far.
        const double radius = (sphere.radius + distance) / 2;
        sphere = {sphere.centre + (distance - radius) / distance * (p - sphere.centre), radius};
    }
    return sphere.centre;
}

}  // namespace

std::optional<BoundingBox> boundingBox(std::span<const Vec3d> points) {
    if (points.empty()) return {};
    BoundingBox box{points[0], points[0]};
    for (const Vec3d& p : points) box = {glm::min(box.min, p), glm::max(box.max, p)};
    return box;
}

std::optional<BoundingSphere> boundingSphere(std::span<const Vec3d> points) {
    const auto box = boundingBox(points);
    if (!box) return {};
    const BoundingSphere ritter = around(ritterCentre(points), points);
    const BoundingSphere boxed = around(box->min + (box->max - box->min) / 2.0, points);
    return ritter.radius < boxed.radius ? ritter : boxed;
}

}  // namespace pipeline
