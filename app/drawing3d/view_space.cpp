#include "app/drawing3d/view_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

using pipeline::View;

namespace {

Vec3d toView(const View& view, Vec3d world) {
    const Vec3d d = world - view.eye;
    return {glm::dot(d, view.right), glm::dot(d, view.up), glm::dot(d, view.forward)};
}

Vec3d inWorld(const View& view, Vec3d p) { return view.eye + p.x * view.right + p.y * view.up + p.z * view.forward; }

// 0 at the near plane, 1 at the far plane: a − b / z in perspective.
double toDepth(const View& view, double z) {
    const double range = view.far - view.near;
    return view.perspective ? view.far / range - view.far * view.near / (range * z) : (z - view.near) / range;
}

double fromDepth(const View& view, double depth) {
    const double range = view.far - view.near;
    return view.perspective ? view.far * view.near / (view.far - depth * range) : view.near + depth * range;
}

}  // namespace

std::string nameOf(SpaceId id) {
    switch (id.space) {
        case ViewSpace::World: return "World space";
        case ViewSpace::Eye: return "Eye space";
        case ViewSpace::Clip: return "Clip space";
        case ViewSpace::Screen: return "Screen space";
        case ViewSpace::Light: {
            const std::string name = "Light " + std::to_string(id.light) + "'s space";
            return id.face < 0 ? name : name + ", face " + nameOfFace(id.face);
        }
        case ViewSpace::Point: break;
    }
    return "At the point";
}

std::string shortNameOf(SpaceId id) {
    switch (id.space) {
        case ViewSpace::World: return "World";
        case ViewSpace::Eye: return "Eye";
        case ViewSpace::Clip: return "Clip";
        case ViewSpace::Screen: return "Screen";
        case ViewSpace::Light: return "Light " + std::to_string(id.light);
        case ViewSpace::Point: break;
    }
    return "Point";
}

std::string nameOfFace(int face) {
    static constexpr std::array<const char*, kLightFaces> kNames{"+x", "−x", "+y", "−y", "+z", "−z"};
    return kNames[std::size_t(face) % kNames.size()];
}

double depthOf(const View& view, Vec3d world) { return glm::dot(world - view.eye, view.forward); }

Vec3d SpaceMap::toSpace(Vec3d world) const {
    if (space == ViewSpace::World || space == ViewSpace::Point) return world;
    const Vec3d p = toView(view, world);
    if (keepsLengths()) return {p.x, p.z, p.y};
    const double spread = view.perspective ? p.z : 1, depth = toDepth(view, p.z);
    const glm::dvec2 pixel{view.centre.x + view.scale.x * p.x / spread, view.centre.y - view.scale.y * p.y / spread};
    const glm::dvec2 size(view.size);
    if (space == ViewSpace::Clip) return {2 * pixel.x / size.x - 1, 2 * depth - 1, 1 - 2 * pixel.y / size.y};
    return {pixel.x, depth * size.y, size.y - pixel.y};
}

Vec3d SpaceMap::toWorld(Vec3d shown) const {
    if (space == ViewSpace::World || space == ViewSpace::Point) return shown;
    if (keepsLengths()) return inWorld(view, {shown.x, shown.z, shown.y});
    const glm::dvec2 size(view.size);
    const bool clip = space == ViewSpace::Clip;
    const double z = fromDepth(view, clip ? (shown.y + 1) / 2 : shown.y / size.y);
    const glm::dvec2 pixel = clip ? glm::dvec2((shown.x + 1) / 2 * size.x, (1 - shown.z) / 2 * size.y)
                                  : glm::dvec2(shown.x, size.y - shown.z);
    return pipeline::worldPoint(view, pixel, z);
}

Vec3d SpaceMap::turned(Vec3d direction) const {
    if (space == ViewSpace::World || space == ViewSpace::Point) return direction;
    return {glm::dot(direction, view.right), glm::dot(direction, view.forward), glm::dot(direction, view.up)};
}

View SpaceMap::turned(const View& other) const {
    View result = other;
    result.eye = toSpace(other.eye);
    result.right = turned(other.right);
    result.up = turned(other.up);
    result.forward = turned(other.forward);
    return result;
}

std::optional<SpaceMap::WorldRay> SpaceMap::toWorld(const Ray& shown, double farthest) const {
    constexpr double kForEver = std::numeric_limits<double>::infinity();
    if (space == ViewSpace::World || space == ViewSpace::Point) return WorldRay{shown, kForEver};
    if (keepsLengths()) {
        const Vec3d d = shown.direction;
        return WorldRay{{toWorld(shown.origin), d.x * view.right + d.z * view.up + d.y * view.forward}, kForEver};
    }
    // Depth is drawn along y. Before the near plane, and beyond all that is far, there is nothing.
    const double low = space == ViewSpace::Clip ? -1 : 0, range = space == ViewSpace::Clip ? 2 : view.size.y;
    const double high = low + range * toDepth(view, farthest);
    const double y = shown.origin.y, d = shown.direction.y;
    double begin = 0, end = kForEver;
    if (d != 0) {
        const auto [first, last] = std::minmax({(low - y) / d, (high - y) / d});
        begin = std::max(begin, first), end = last;
    } else if (!(low <= y && y <= high)) {
        return {};
    }
    if (!(farthest > view.near && begin < end)) return {};
    const bool ends = std::isfinite(end);
    const Vec3d from = toWorld(shown.at(begin)), to = toWorld(shown.at(ends ? end : begin + range));
    const double length = glm::length(to - from);
    if (!(length > 0)) return {};
    return WorldRay{{from, (to - from) / length}, ends ? length : kForEver};
}

SpaceBox visibleBox(const SpaceMap& map) {
    if (map.space == ViewSpace::Clip) return {Vec3d(-1.0), Vec3d(1.0)};
    const glm::dvec2 size(map.view.size);
    return {Vec3d(0.0), {size.x, size.y, size.y}};
}

View flatEye(const SpaceMap& map) {
    const SpaceBox box = visibleBox(map);
    const Vec3d middle = (box.min + box.max) / 2.0, extent = box.max - box.min;
    View eye;
    eye.right = {1, 0, 0};
    eye.up = {0, 0, 1};
    eye.forward = {0, 1, 0};
    eye.perspective = false;
    eye.size = map.view.size;
    eye.centre = glm::dvec2(eye.size) / 2.0;
    eye.scale = glm::dvec2(eye.size) / glm::dvec2(extent.x, extent.z);
    eye.near = 0.6 * extent.y;  // the picture's distance from the box
    eye.far = eye.near + extent.y;
    eye.eye = {middle.x, box.min.y - eye.near, middle.z};
    return eye;
}

std::array<SpaceAxis, 3> axesOf(ViewSpace space) {
    const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    switch (space) {
        case ViewSpace::World:
        case ViewSpace::Point: return {{{"x", x}, {"y", y}, {"z", z}}};
        case ViewSpace::Screen: return {{{"x", x}, {"y", -z}, {"z", y}}};
        case ViewSpace::Light: return {{{"x", x}, {"y", z}, {"z′", y}}};
        case ViewSpace::Eye:
        case ViewSpace::Clip: break;
    }
    return {{{"x", x}, {"y", z}, {"z", y}}};
}

}  // namespace app
