// Handles under the cursor, and what a drag makes of them.
#include "app/view3d/handle_drag.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {

namespace {

constexpr double kReach = 13, kTipReach = 10, kRingReach = 7, kArmLength = 46;  // pixels of the design
constexpr int kRingPieces = 64;

// World units that a pixel spans at a point.
double unitAt(const HandleView& handles, Vec3d point) {
    return handles.view.camera.unitsPerPixelAt(point, handles.view.size.y);
}

// Where a ray meets the plane through a point that faces along the camera's axis.
std::optional<Vec3d> onScreenPlane(const Ray& ray, const OrbitCamera& camera, Vec3d point) {
    const double along = glm::dot(ray.direction, camera.forward);
    if (!(along > 0)) return {};
    return ray.origin + glm::dot(point - ray.origin, camera.forward) / along * ray.direction;
}

// The point of the axis that the ray passes nearest; nothing where they are parallel.
std::optional<Vec3d> onAxis(const Ray& ray, Vec3d point, Vec3d axis) {
    const double cosine = glm::dot(ray.direction, axis), across = 1 - cosine * cosine;
    constexpr double kLeast = 1e-4;  // about half a degree: there a pixel would move it out of sight
    if (!(across > kLeast)) return {};
    const Vec3d d = ray.origin - point;
    return point + (glm::dot(d, axis) - glm::dot(d, ray.direction) * cosine) / across * axis;
}

// The point of the sphere on the ray, on the side of the sphere that `now` is on; past its edge, the edge.
Vec3d onSphere(const Ray& ray, Vec3d centre, Vec3d now) {
    const double radius = glm::length(now - centre);
    const Vec3d d = ray.origin - centre;
    const double nearest = -glm::dot(d, ray.direction);
    const Vec3d foot = d + nearest * ray.direction;
    const double rest = radius * radius - glm::dot(foot, foot);
    if (!(rest > 0)) return centre + (glm::length(foot) > 0 ? radius / glm::length(foot) * foot : now - centre);
    const bool far = glm::dot(now - centre, ray.direction) > 0;
    return centre + foot + (far ? 1.0 : -1.0) * std::sqrt(rest) * ray.direction;
}

double shareOf(DragStep step) { return step == DragStep::Fine ? 0.1 : 1; }

double stepOf(DragStep step, double usual, double coarse) {
    return step == DragStep::Coarse ? coarse : usual * shareOf(step);
}

// In clip and screen space: through the point of the drawing, and back to the world.
Vec3d movedFlat(const Handle& handle, const HandleView& view, glm::dvec2 moved, DragStep step) {
    const OrbitCamera& camera = view.view.camera;
    const Vec3d begin = view.map.toSpace(handle.at);
    const glm::dvec2 at = project(camera, view.view.size, begin).at;
    const auto under = [&](glm::dvec2 pixel) -> std::optional<Vec3d> {
        const auto found = onScreenPlane(rayThrough(camera, view.view.size, pixel), camera, begin);
        if (!found) return {};
        const Vec3d world = view.map.toWorld(*found);
        // Past the horizon of the division by z the way back leads behind the eye.
        if (!finite(world) || depthOf(view.map.view, world) < view.map.view.near) return {};
        return world;
    };
    const auto beside = under(at + glm::dvec2(1, 0)), to = under(at + moved);
    if (!to || !beside || *beside == handle.at) return handle.value;
    const double usual = stepBelow(glm::length(*beside - handle.at));
    return roundedTo(*to, stepOf(step, usual, 10 * usual));
}

Vec3d turnedDirection(const Handle& handle, const Ray& ray, DragStep step) {
    const Vec3d found = onSphere(ray, handle.centre, handle.at);
    if (step != DragStep::Coarse) return found;
    constexpr double kStep = std::numbers::pi / 12;
    const Vec3d d = found - handle.centre;
    const double length = glm::length(d);
    const double around = std::round(std::atan2(d.y, d.x) / kStep) * kStep;
    const double above = std::round(std::asin(std::clamp(d.z / length, -1.0, 1.0)) / kStep) * kStep;
    return handle.centre +
           length * Vec3d(std::cos(above) * std::cos(around), std::cos(above) * std::sin(around), std::sin(above));
}

Vec3d moved(const Handle& handle, std::optional<std::size_t> arm, const HandleView& view, glm::dvec2 by,
            DragStep step) {
    const ViewFrame& frame = view.view;
    const Ray ray = rayThrough(frame.camera, frame.size, placeOf(view, handle.at).at + by);
    if (handle.isDirection()) return turnedDirection(handle, ray, step);
    const auto found =
        arm ? onAxis(ray, handle.at, handle.arms[*arm].axis) : onScreenPlane(ray, frame.camera, handle.at);
    if (!found || !finite(*found)) return handle.value;
    const double usual = stepBelow(unitAt(view, handle.at));
    const Vec3d result = roundedTo(*found, stepOf(step, usual, 10 * usual));
    if (!arm) return result;
    Vec3d only = handle.value;  // the other two stay as they were, to the last bit
    const auto i = int(*arm);
    only[i] = result[i];
    return only;
}

// Degrees around the arm: between the two points of its plane, or where that is seen from its edge, as far
// as the ring would go.
double turnBetween(const Handle& handle, std::size_t arm, const HandleView& view, glm::dvec2 from, glm::dvec2 to) {
    const Vec3d axis = handle.arms[arm].axis;
    const auto onPlane = [&](glm::dvec2 pixel) -> std::optional<Vec3d> {
        const Ray ray = rayThrough(view.view.camera, view.view.size, pixel);
        const double along = glm::dot(ray.direction, axis);
        constexpr double kLeast = 0.17;  // about 10 degrees
        if (!(std::abs(along) > kLeast)) return {};
        return ray.origin + glm::dot(handle.at - ray.origin, axis) / along * ray.direction - handle.at;
    };
    const auto a = onPlane(from), b = onPlane(to);
    if (a && b) return glm::degrees(std::atan2(glm::dot(glm::cross(*a, *b), axis), glm::dot(*a, *b)));
    const std::vector<Vec3d> ring = armRing(handle, arm, view);
    const auto distance = [&](Vec3d p) { return glm::length(placeOf(view, p).at - from); };
    // The nearer one of its two sides: what is beneath the cursor of both is the front.
    const auto nearest = std::ranges::min_element(ring, [&](Vec3d p, Vec3d q) {
        const auto rate = [&](Vec3d r) { return distance(r) + 0.05 * placeOf(view, r).depth / unitAt(view, r); };
        return rate(p) < rate(q);
    });
    const auto next = nearest + 1 == ring.end() ? ring.begin() + 1 : nearest + 1;
    const glm::dvec2 along = placeOf(view, *next).at - placeOf(view, *nearest).at;
    const double square = glm::dot(along, along);
    return square > 0 ? glm::dot(to - from, along) / square * 360 / kRingPieces : 0;
}

Vec3d turned(const Handle& handle, std::size_t arm, const HandleView& view, glm::dvec2 from, glm::dvec2 by,
             DragStep step) {
    const double degrees = shareOf(step) * turnBetween(handle, arm, view, from, from + by);
    if (!std::isfinite(degrees)) return handle.value;
    const double least = stepOf(step, 1, 15);
    Vec3d result = handle.value;
    result[int(arm)] = std::round((result[int(arm)] + degrees) / least) * least;
    return result;
}

double scaled(double scale, double factor, DragStep step) {
    if (scale == 0) scale = 1, factor -= 1;  // what is flat grows from nothing
    const double decade = stepBelow(std::abs(scale));
    const double least = decade * stepOf(step, 0.01, 0.1);
    const double size = std::round(std::abs(scale) * factor / least) * least;
    return std::copysign(std::max(size, least), scale);
}

Vec3d scaled(const Handle& handle, std::optional<std::size_t> arm, const HandleView& view, glm::dvec2 by,
             DragStep step) {
    Vec3d result = handle.value;
    if (!arm) {
        const double factor =
            1 + shareOf(step) * (by.x - by.y) / (kArmLength * view.view.scale);  // to the right and up it grows
        for (int i = 0; i < 3; ++i) result[i] = scaled(result[i], factor, step);
        return result;
    }
    const glm::dvec2 along = armTips(handle, view)[*arm] - placeOf(view, handle.at).at;
    const double length = glm::length(along);
    constexpr double kLeast = 3;  // seen from its end an arm has no direction on the screen
    if (!(length > kLeast)) return result;
    const double factor = 1 + shareOf(step) * glm::dot(by, along) / (length * length);
    result[int(*arm)] = scaled(result[int(*arm)], factor, step);
    return result;
}

double distanceToRing(const Handle& handle, std::size_t arm, const HandleView& view, glm::dvec2 cursor) {
    double least = 1e300;
    const std::vector<Vec3d> ring = armRing(handle, arm, view);
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        const Projected a = placeOf(view, ring[i]), b = placeOf(view, ring[i + 1]);
        if (!a.inFront || !b.inFront) continue;
        const glm::dvec2 d = b.at - a.at;
        const double square = glm::dot(d, d);
        const double t = square > 0 ? std::clamp(glm::dot(cursor - a.at, d) / square, 0.0, 1.0) : 0;
        least = std::min(least, glm::length(a.at + t * d - cursor));
    }
    return least;
}

std::optional<Grip> armAt(const Handle& handle, std::size_t index, const HandleView& view, glm::dvec2 cursor) {
    std::optional<Grip> best;
    if (handle.tool == HandleTool::Turn) {
        // Where rings cross, the one that is seen more open.
        double nearest = 1e300;
        for (std::size_t i = 0; i < handle.arms.size(); ++i) {
            const double distance = distanceToRing(handle, i, view, cursor);
            if (!(distance < kRingReach * view.view.scale)) continue;
            const double rate = distance - 4 * std::abs(glm::dot(handle.arms[i].axis, view.view.camera.forward));
            if (rate < nearest) nearest = rate, best = Grip{index, i};
        }
        return best;
    }
    const auto tips = armTips(handle, view);
    const bool onRing = glm::length(cursor - placeOf(view, handle.at).at) <= kReach * view.view.scale / 2;
    for (std::size_t i = 0; i < tips.size() && !best; ++i)
        if (glm::length(tips[i] - cursor) < kTipReach * view.view.scale && !onRing) best = Grip{index, i};
    return best;
}

}  // namespace

HandleView handleView(const ViewFrame& shown, const SpaceMap& map) {
    if (!map.keepsLengths()) return {shown, map};
    HandleView result{shown, {}};
    OrbitCamera& camera = result.view.camera;
    const auto back = [&](Vec3d direction) { return map.toWorld(direction) - map.toWorld(Vec3d(0.0)); };
    camera.target = map.toWorld(camera.target);
    camera.right = back(camera.right);
    camera.up = back(camera.up);
    camera.forward = back(camera.forward);
    return result;
}

Projected placeOf(const HandleView& view, Vec3d world) {
    if (!view.map.keepsLengths() && depthOf(view.map.view, world) < view.map.view.near) return {.inFront = false};
    return project(view.view.camera, view.view.size, view.map.toSpace(world));
}

std::vector<glm::dvec2> armTips(const Handle& handle, const HandleView& view) {
    std::vector<glm::dvec2> tips;
    const double length = kArmLength * view.view.scale * unitAt(view, handle.at);
    for (const HandleArm& arm : handle.arms) tips.push_back(placeOf(view, handle.at + length * arm.axis).at);
    return tips;
}

std::vector<Vec3d> armRing(const Handle& handle, std::size_t arm, const HandleView& view) {
    const Vec3d axis = handle.arms[arm].axis, u = across(axis), v = glm::cross(axis, u);
    const double radius = kArmLength * view.view.scale * unitAt(view, handle.at);
    std::vector<Vec3d> ring;
    for (int i = 0; i <= kRingPieces; ++i) {
        const double a = 2 * std::numbers::pi * i / kRingPieces;
        ring.push_back(handle.at + radius * (std::cos(a) * u + std::sin(a) * v));
    }
    return ring;
}

std::optional<Grip> gripAt(std::span<const Handle> handles, std::optional<std::size_t> hot, const HandleView& view,
                           glm::dvec2 cursor) {
    if (hot && *hot < handles.size())
        if (const auto grip = armAt(handles[*hot], *hot, view, cursor)) return grip;
    std::optional<Grip> best;
    double nearest = kReach * view.view.scale;
    for (std::size_t i = 0; i < handles.size(); ++i) {
        const Projected p = placeOf(view, handles[i].at);
        if (!p.inFront || glm::length(p.at - cursor) >= nearest) continue;
        nearest = glm::length(p.at - cursor);
        best = Grip{i, {}};
    }
    return best;
}

bool holds(const Handle& handle, std::optional<std::size_t> arm) {
    return handle.tool != HandleTool::Turn || (arm && *arm < handle.arms.size());
}

Vec3d draggedTo(const Handle& handle, std::optional<std::size_t> arm, const HandleView& view, glm::dvec2 from,
                glm::dvec2 by, DragStep step) {
    if (arm && *arm >= handle.arms.size()) arm.reset();
    if (by == glm::dvec2(0.0) || !holds(handle, arm)) return handle.value;
    if (!view.map.keepsLengths()) return movedFlat(handle, view, shareOf(step) * by, step);
    switch (handle.tool) {
        case HandleTool::Turn: return turned(handle, *arm, view, from, by, step);
        case HandleTool::Scale: return scaled(handle, arm, view, by, step);
        case HandleTool::Move: break;
    }
    return moved(handle, arm, view, shareOf(step) * by, step);
}

}  // namespace app
