#include "app/drawing3d/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/quaternion.hpp>

namespace app {

namespace {

// How far apart, against the coordinates that they come from, points of double precision count as two.
constexpr double kCoincident = 0x1p-46;

double tanHalf(const OrbitCamera& camera) { return std::tan(glm::radians(camera.fovY) / 2); }

Vec3d turned(Vec3d v, Vec3d axis, double degrees) { return glm::angleAxis(glm::radians(degrees), axis) * v; }

void turn(OrbitCamera& camera, Vec3d axis, double degrees) {
    camera.forward = glm::normalize(turned(camera.forward, axis, degrees));
    // Gram-Schmidt, so that a thousand small turns do not add up to a skewed picture.
    const Vec3d up = turned(camera.up, axis, degrees);
    camera.right = glm::normalize(glm::cross(camera.forward, up));
    camera.up = glm::cross(camera.right, camera.forward);
}

double elevation(const OrbitCamera& camera) {
    return glm::degrees(std::asin(std::clamp(-camera.forward.z, -1.0, 1.0)));
}

}  // namespace

double OrbitCamera::unitsPerPixel(double height) const { return 2 * distance * tanHalf(*this) / height; }

double OrbitCamera::unitsPerPixelAt(Vec3d point, double height) const {
    if (orthographic) return unitsPerPixel(height);
    return unitsPerPixel(height) * std::max(glm::dot(point - position(), forward) / distance, 1e-3);
}

Projected project(const OrbitCamera& camera, glm::dvec2 size, Vec3d point) {
    const Vec3d d = point - camera.position();
    Projected result;
    result.depth = glm::dot(d, camera.forward);
    // At the camera itself, where the scene's own eye may stand, rounding alone decides on depth and place.
    const double least = kCoincident * (glm::length(point) + glm::length(camera.position()) + camera.distance);
    result.inFront = camera.orthographic || result.depth > least;
    // Behind the camera the signs of x and y turn over; |depth| keeps the side the point is on.
    const double scale = camera.orthographic ? camera.distance : std::max(std::abs(result.depth), least);
    const double pixelsPerUnit = size.y / (2 * tanHalf(camera) * scale);
    result.at = {size.x / 2 + pixelsPerUnit * glm::dot(d, camera.right),
                 size.y / 2 - pixelsPerUnit * glm::dot(d, camera.up)};
    return result;
}

Ray rayThrough(const OrbitCamera& camera, glm::dvec2 size, glm::dvec2 pixel) {
    const double units = camera.unitsPerPixel(size.y);
    const Vec3d aside = (pixel.x - size.x / 2) * units * camera.right + (size.y / 2 - pixel.y) * units * camera.up;
    if (camera.orthographic) return {camera.position() + aside, camera.forward};
    return {camera.position(), glm::normalize(camera.distance * camera.forward + aside)};
}

void orbit(OrbitCamera& camera, double aroundZ, double overTop) {
    turn(camera, {0, 0, 1}, aroundZ);
    // `up` points below the horizon only when a roll of the scene's camera turned it over.
    if (camera.up.z < -1e-6) {
        turn(camera, camera.right, overTop);
        return;
    }
    const double now = elevation(camera);
    turn(camera, camera.right, -(std::clamp(now + overTop, -90.0, 90.0) - now));
}

void pan(OrbitCamera& camera, glm::dvec2 pixels, glm::dvec2 size) {
    const double units = camera.unitsPerPixel(size.y);
    camera.target += units * (pixels.y * camera.up - pixels.x * camera.right);
}

void zoomAt(OrbitCamera& camera, double factor, glm::dvec2 cursor, glm::dvec2 size) {
    const glm::dvec2 fromCentre = cursor - size / 2.0;
    const double units = camera.unitsPerPixel(size.y) * (1 - factor);
    camera.target += units * (fromCentre.x * camera.right - fromCentre.y * camera.up);
    camera.distance *= factor;
}

void lookAlong(OrbitCamera& camera, Vec3d forward) {
    camera.forward = glm::normalize(forward);
    // Straight down +y is up on the screen; straight up it is −y.
    const Vec3d sky =
        std::abs(camera.forward.z) < 1 - 1e-9 ? Vec3d(0, 0, 1) : Vec3d(0, camera.forward.z < 0 ? 1 : -1, 0);
    camera.right = glm::normalize(glm::cross(camera.forward, sky));
    camera.up = glm::cross(camera.right, camera.forward);
}

void frame(OrbitCamera& camera, std::span<const Vec3d> points, glm::dvec2 size, double margin, double foot) {
    if (points.empty()) return;
    const double aspect = size.x / size.y;
    const double free = 2 * margin * std::min(1.0, aspect);  // of the height
    const double tanTop = tanHalf(camera) * (1 - free);
    const double tanFoot = tanHalf(camera) * (1 - std::max(free, 2 * std::min(foot / size.y, 0.45)));
    const double tanX = tanHalf(camera) * (aspect - free);

    // In perspective each point p asks depth(p) + d >= |x(p) − cx| / tanX: the tightest frame is found
    // side by side, from the slopes of the four planes through the camera (no search needed).
    double left = -std::numeric_limits<double>::infinity(), rightSide = left, top = left, bottom = left;
    double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest, reach = 0;
    for (const Vec3d& p : points) {
        const double x = glm::dot(p, camera.right), y = glm::dot(p, camera.up);
        const double z = camera.orthographic ? 0 : glm::dot(p, camera.forward);
        left = std::max(left, -x / tanX - z);
        rightSide = std::max(rightSide, x / tanX - z);
        bottom = std::max(bottom, -y - tanFoot * z);
        top = std::max(top, y - tanTop * z);
        nearest = std::min(nearest, glm::dot(p, camera.forward));
        farthest = std::max(farthest, glm::dot(p, camera.forward));
        reach = std::max(reach, glm::length(p));
    }
    const double x = (rightSide - left) / 2 * tanX;
    const double back = std::max((left + rightSide) / 2, (top + bottom) / (tanTop + tanFoot));  // −z of the camera
    const double y = (top - bottom + (tanFoot - tanTop) * back) / 2;
    const double middle = (nearest + farthest) / 2;
    double distance = camera.orthographic ? back : middle + back;
    // What rounding leaves of a scene without extent is not an extent.
    if (!(distance > 1e-12 * reach)) distance = 1 / (2 * tanHalf(camera));
    camera.target = x * camera.right + y * camera.up + middle * camera.forward;
    camera.distance = distance;
}

OrbitCamera fromEye(const pipeline::View& view, Vec3d target, glm::dvec2 size) {
    OrbitCamera camera;
    camera.right = view.right;
    camera.up = view.up;
    camera.forward = view.forward;
    camera.orthographic = !view.perspective;
    // Half the picture's height and width in view units at z_view = 1; the larger demand wins.
    const glm::dvec2 half = glm::dvec2(view.size) / (2.0 * view.scale);
    const double tall = std::max(half.y, half.x * size.y / size.x);
    const double depth = glm::dot(target - view.eye, view.forward);
    if (camera.orthographic) {
        camera.distance = tall / tanHalf(camera);
        camera.target = view.eye + depth * view.forward;
        return camera;
    }
    camera.fovY = glm::degrees(2 * std::atan(tall));
    camera.distance = depth > 0 ? depth : 1;
    camera.target = view.eye + camera.distance * view.forward;
    return camera;
}

OrbitCamera between(const OrbitCamera& from, const OrbitCamera& to, double t) {
    if (t >= 1) return to;
    OrbitCamera camera = t < 0.5 ? from : to;  // orthographic switches half way
    const auto basis = [](const OrbitCamera& c) { return glm::quat_cast(glm::dmat3(c.right, c.up, -c.forward)); };
    const glm::dmat3 axes = glm::mat3_cast(glm::slerp(basis(from), basis(to), t));
    camera.right = axes[0];
    camera.up = axes[1];
    camera.forward = -axes[2];
    camera.target = glm::mix(from.target, to.target, t);
    camera.distance = from.distance * std::pow(to.distance / from.distance, t);
    camera.fovY = glm::mix(from.fovY, to.fovY, t);
    return camera;
}

}  // namespace app
