#pragma once
#include <optional>
#include <span>

#include "pipeline/core/real.h"

namespace pipeline {

// The smallest box along the axes that holds points, and a small sphere that does: lecture 2's
// bounding boxes and bounding spheres. In the space and unit of the points.
struct BoundingBox {
    Vec3d min{0.0}, max{0.0};
    bool operator==(const BoundingBox&) const = default;
};
struct BoundingSphere {
    Vec3d centre{0.0};
    double radius = 0;
    bool operator==(const BoundingSphere&) const = default;
};

// Nothing without points. The coordinates must be finite.
std::optional<BoundingBox> boundingBox(std::span<const Vec3d> points);

// The smaller of two spheres: J. Ritter, "An efficient bounding sphere", Graphics Gems, 1990, and the
// one around the box's middle. Both end with the distance of the farthest point as the radius, so
// that none lies outside by a rounding error. At most some tenths larger than the smallest one.
std::optional<BoundingSphere> boundingSphere(std::span<const Vec3d> points);

}  // namespace pipeline
