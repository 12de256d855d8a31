#include "app/drawing3d/arrow_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace app {

namespace {

// A surface of revolution about z: rings of `sides` points with the given radii and heights, from
// the foot to the top, closed with a fan where the end's radius is 0.
Solid turned(std::span<const glm::dvec2> profile, int sides) {
    Solid solid;
    for (const glm::dvec2& p : profile)
        for (int i = 0; i < sides; ++i) {
            const double a = 2 * std::numbers::pi * i / sides;
            solid.positions.emplace_back(p.x * std::cos(a), p.x * std::sin(a), p.y);
        }
    const auto n = static_cast<unsigned>(sides);
    for (unsigned row = 0; row + 1 < profile.size(); ++row)
        for (unsigned i = 0; i < n; ++i) {
            const unsigned a = row * n + i, b = row * n + (i + 1) % n;
            solid.triangles.emplace_back(a, b, b + n);
            solid.triangles.emplace_back(a, b + n, a + n);
        }
    return solid;
}

Solid octahedron(double centre, double halfWidth, double halfLength) {
    const std::array<glm::dvec2, 3> profile{{{0, centre - halfLength}, {halfWidth, centre}, {0, centre + halfLength}}};
    return turned(profile, 4);
}

// The tips' sizes in pixels for a shaft of radius 2, from the drawn design; they grow with the shaft.
struct TipSize {
    double length, halfWidth;
};
TipSize tipSize(VectorCode code) {
    switch (code) {
        case VectorCode::N: return {17, 6.5};
        case VectorCode::L: return {13, 6.5};
        case VectorCode::V: return {13, 6.5};
        case VectorCode::R: return {14, 6.0};
        case VectorCode::H: return {15, 6.0};
        case VectorCode::None: break;
    }
    return {0, 0};
}

Solid tip(VectorCode code, double length, double radius) {
    const double s = radius / 2;
    const TipSize size = tipSize(code);
    const double back = length - s * size.length;
    switch (code) {
        case VectorCode::N: {
            const std::array<glm::dvec2, 3> cone{{{0, back}, {s * size.halfWidth, back}, {0, length}}};
            return turned(cone, 24);
        }
        case VectorCode::L: return ball({0, 0, length - s * size.halfWidth}, s * size.halfWidth, 20);
        case VectorCode::V: break;  // faces the eye, so it is made where the eye is known
        case VectorCode::R: {
            // Each bar leans 40° off the shaft.
            const double lean = s * size.length * std::tan(40 * std::numbers::pi / 180);
            Solid solid = tube({0, 0, length - radius}, {lean, 0, back}, radius);
            append(solid, tube({0, 0, length - radius}, {-lean, 0, back}, radius));
            append(solid, ball({0, 0, length - radius}, radius, 12));
            return solid;
        }
        case VectorCode::H: return octahedron(length - s * size.length / 2, s * size.halfWidth, s * size.length / 2);
        case VectorCode::None: break;
    }
    return {};
}

}  // namespace

// With the axis that it is farthest from.
Vec3d across(Vec3d along) {
    const Vec3d a = glm::abs(along);
    const Vec3d least = a.x <= a.y && a.x <= a.z ? Vec3d(1, 0, 0) : a.y <= a.z ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
    return glm::normalize(glm::cross(along, least));
}

void append(Solid& solid, const Solid& more) {
    const auto first = static_cast<unsigned>(solid.positions.size());
    solid.positions.insert(solid.positions.end(), more.positions.begin(), more.positions.end());
    for (const glm::uvec3& t : more.triangles) solid.triangles.push_back(t + first);
}

Solid placed(Solid solid, const ShapePlacement& placement) {
    // x lies in the screen, across the arrow; where the arrow points at the eye any x does.
    const Vec3d x0 = glm::cross(placement.along, placement.towardsEye);
    const double length = glm::length(x0);
    const Vec3d x = length > 1e-6 ? x0 / length : across(placement.along);
    const Vec3d y = glm::cross(placement.along, x);
    for (Vec3d& p : solid.positions)
        p = placement.origin + placement.scale * (p.x * x + p.y * y + p.z * placement.along);
    return solid;
}

std::vector<Dash> dashes(VectorCode code, double length, double width) {
    std::span<const double> pattern;  // dash, gap, dash, gap …
    static constexpr std::array<double, 2> kLight{4, 1.7}, kMirrored{1.7, 1.25}, kHalfway{0.5, 1.25};
    static constexpr std::array<double, 4> kEye{4, 1.25, 1, 1.25};
    switch (code) {
        case VectorCode::L: pattern = kLight; break;
        case VectorCode::V: pattern = kEye; break;
        case VectorCode::R: pattern = kMirrored; break;
        case VectorCode::H: pattern = kHalfway; break;
        case VectorCode::N:
        case VectorCode::None: return {{0, length}};
    }
    std::vector<Dash> result;
    double at = 0;
    for (std::size_t i = 0; at < length; i = (i + 2) % pattern.size()) {
        result.push_back({at, std::min(at + pattern[i] * width, length)});
        at += (pattern[i] + pattern[i + 1]) * width;
    }
    return result;
}

double tipLength(VectorCode code, double radius) { return radius / 2 * tipSize(code).length; }

Solid arrow(VectorCode code, double length, double radius, const ShapePlacement& placement) {
    // A very short arrow is its tip alone, shrunk to fit.
    const double natural = tipLength(code, radius);
    const bool tipAlone = length < natural;
    if (tipAlone) radius *= length / natural;
    Solid solid;
    if (!tipAlone) {
        // R's chevron is open: its shaft goes on to the end.
        const double shaft = code == VectorCode::R ? length - radius : length - natural;
        for (const Dash& dash : dashes(code, shaft, 2 * radius))
            append(solid, tube({0, 0, dash.begin}, {0, 0, dash.end}, radius));
    }
    append(solid, tip(code, length, radius));
    solid = placed(std::move(solid), placement);
    if (code == VectorCode::V) {
        const double s = radius / 2, half = s * tipSize(code).halfWidth;
        const Vec3d centre = placement.origin + placement.scale * (length - half) * placement.along;
        append(solid,
               placed(ring(half - s * 1.4, s * 1.4), {centre, placement.towardsEye, placement.along, placement.scale}));
    }
    return solid;
}

Solid smallArrow(double length, double radius) {
    constexpr double kTipLength = 9, kTipHalfWidth = 3.4;  // for a radius of 1
    const double tip = std::min(kTipLength * radius, length), width = kTipHalfWidth / kTipLength * tip;
    const double neck = length - tip;
    const std::array<glm::dvec2, 4> profile{{{radius, 0}, {radius, neck}, {width, neck}, {0, length}}};
    return turned(profile, 8);
}

Solid inflated(Solid solid, double distance) {
    // Corners that share a place (a fan's) move together only as far as their normals agree; the
    // gaps are of the order of the distance, and nothing but a rim is drawn of the result.
    std::vector<Vec3d> normals(solid.positions.size(), Vec3d(0.0));
    for (const glm::uvec3& t : solid.triangles) {
        const Vec3d a = solid.positions[t.x], b = solid.positions[t.y], c = solid.positions[t.z];
        const Vec3d normal = glm::cross(b - a, c - a);
        for (int i = 0; i < 3; ++i) normals[t[i]] += normal;
    }
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const double length = glm::length(normals[i]);
        if (length > 0) solid.positions[i] += distance / length * normals[i];
    }
    return solid;
}

Solid tube(Vec3d a, Vec3d b, double radius, int sides) {
    const double length = glm::length(b - a);
    if (!(length > 0)) return {};
    const std::array<glm::dvec2, 4> profile{{{0, 0}, {radius, 0}, {radius, length}, {0, length}}};
    const Vec3d along = (b - a) / length;
    return placed(turned(profile, sides), {a, along, across(along), 1});
}

Solid ball(Vec3d centre, double radius, int around) {
    std::vector<glm::dvec2> profile;
    const int rows = around / 2;
    for (int i = 0; i <= rows; ++i) {
        const double a = std::numbers::pi * i / rows;
        profile.emplace_back(radius * std::sin(a), -radius * std::cos(a));
    }
    Solid solid = turned(profile, around);
    for (Vec3d& p : solid.positions) p += centre;
    return solid;
}

Solid ring(double radius, double tubeRadius) {
    constexpr int kSides = 10;
    std::vector<glm::dvec2> profile;
    for (int i = 0; i <= kSides; ++i) {
        const double a = 2 * std::numbers::pi * i / kSides;
        profile.emplace_back(radius + tubeRadius * std::cos(a), tubeRadius * std::sin(a));
    }
    return turned(profile, 28);
}

}  // namespace app
