#pragma once
#include <optional>
#include <span>

#include <glm/glm.hpp>

#include "pipeline/core/real.h"
#include "pipeline/core/triangle_tree.h"
#include "pipeline/scene/view.h"

namespace app {

using pipeline::Vec3d;

// The observer of a 3D view: who looks at the scene, its eye included. World space, right-handed.
// Lengths are in world units, positions on the screen in pixels, y down, from the top left.
struct OrbitCamera {
    Vec3d target{0.0};                                    // what it turns around
    double distance = 1;                                  // from position to target, > 0
    Vec3d right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0};  // orthonormal, right × up = −forward
    double fovY = 30;  // vertical field of view, degrees; an orthographic camera shows the same at the target
    bool orthographic = false;
    bool operator==(const OrbitCamera&) const = default;

    Vec3d position() const { return target - distance * forward; }
    // World units that a pixel spans at the target, in a view `height` pixels high.
    double unitsPerPixel(double height) const;
    double unitsPerPixelAt(Vec3d point, double height) const;  // and at a point's depth
};

// Where a point appears. `depth` is the distance along forward; behind the camera (perspective
// only) `inFront` is false and x, y say on which side of the view it lies.
struct Projected {
    glm::dvec2 at{0.0};
    double depth = 0;
    bool inFront = true;
};
Projected project(const OrbitCamera& camera, glm::dvec2 size, Vec3d point);

using Ray = pipeline::rays::Ray<double>;  // its direction has unit length
Ray rayThrough(const OrbitCamera& camera, glm::dvec2 size, glm::dvec2 pixel);

// Turns about the world's z axis and about the camera's right, both through the target; degrees.
// Stops where it looks straight down or up.
void orbit(OrbitCamera& camera, double aroundZ, double overTop);
// Moves the picture by `pixels`: what is at the target's depth stays under the cursor.
void pan(OrbitCamera& camera, glm::dvec2 pixels, glm::dvec2 size);
// Changes the distance by `factor`; what is at the target's depth under `cursor` stays there.
void zoomAt(OrbitCamera& camera, double factor, glm::dvec2 cursor, glm::dvec2 size);

// Looks along `forward`, upright, at the target it has.
void lookAlong(OrbitCamera& camera, Vec3d forward);
// Moves target and distance so that all points lie inside the view, with `margin` of its shorter
// side left free on every side (0 to 0.45), and `foot` pixels at least below, where something else lies on the view. A
// single point is framed as if it had the size 1.
void frame(OrbitCamera& camera, std::span<const Vec3d> points, glm::dvec2 size, double margin = 0.12, double foot = 0);

// The camera that sees what the scene's own camera sees: the picture fits into the view.
OrbitCamera fromEye(const pipeline::View& view, Vec3d target, glm::dvec2 size);

// Part way from one camera to another, t from 0 to 1.
OrbitCamera between(const OrbitCamera& from, const OrbitCamera& to, double t);

}  // namespace app
