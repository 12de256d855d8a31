#include "app/drawing3d/aids_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/core/numerics.h"

namespace app {

namespace {

constexpr int kCirclePieces = 72;

void addCircle(Vec3d centre, Vec3d a, Vec3d b, Ink ink, float strength, std::vector<InkedLine>& lines) {
    const auto at = [&](int i) {
        const double angle = 2 * std::numbers::pi * i / kCirclePieces;
        return centre + std::cos(angle) * a + std::sin(angle) * b;
    };
    for (int i = 0; i < kCirclePieces; ++i) lines.push_back({at(i), at(i + 1), ink, strength, strength});
}

}  // namespace

void addBox(const pipeline::BoundingBox& box, Ink ink, std::vector<InkedLine>& lines) {
    const auto corner = [&](unsigned i) {
        return Vec3d((i & 1 ? box.max : box.min).x, (i & 2 ? box.max : box.min).y, (i & 4 ? box.max : box.min).z);
    };
    for (unsigned i = 0; i < 8; ++i)
        for (const unsigned axis : {1u, 2u, 4u})
            if (!(i & axis)) lines.push_back({corner(i), corner(i | axis), ink, 1, 1});
}

void addSphere(const pipeline::BoundingSphere& sphere, Ink ink, const OrbitCamera& observer,
               std::vector<InkedLine>& lines) {
    const double r = sphere.radius;
    constexpr float kFaint = 0.55f;
    addCircle(sphere.centre, {r, 0, 0}, {0, r, 0}, ink, kFaint, lines);
    addCircle(sphere.centre, {0, r, 0}, {0, 0, r}, ink, kFaint, lines);
    addCircle(sphere.centre, {0, 0, r}, {r, 0, 0}, ink, kFaint, lines);
    // Where the lines of sight touch it: a circle nearer than the middle, and smaller.
    const Vec3d d = observer.position() - sphere.centre;
    const double distance = glm::length(d);
    const bool far = observer.orthographic || !(distance > 0);
    if (!far && !(distance > r)) return;  // seen from inside it has no outline
    const Vec3d axis = far ? -observer.forward : d / distance;
    const double height = far ? 0 : r * r / distance;
    const double radius = std::sqrt(std::max(0.0, r * r - height * height));
    const Vec3d across = pipeline::normalized(observer.up - glm::dot(observer.up, axis) * axis);
    addCircle(sphere.centre + height * axis, radius * across, radius * glm::cross(axis, across), ink, 1, lines);
}

std::array<Vec3d, 8> frustumCorners(const pipeline::View& eye) {
    std::array<Vec3d, 8> corners;
    const auto near = pictureCorners(eye, eye.near), far = pictureCorners(eye, eye.far);
    std::ranges::copy(near, corners.begin());
    std::ranges::copy(far, corners.begin() + 4);
    return corners;
}

void addFrustum(const pipeline::View& eye, Drawing& drawing) {
    const auto corners = frustumCorners(eye);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        drawing.lines.push_back({corners[i], corners[next], Ink::V, 1, 1});
        drawing.lines.push_back({corners[i + 4], corners[next + 4], Ink::V, 1, 1});
        drawing.lines.push_back({corners[i], corners[i + 4], Ink::V, 1, 1});
        if (eye.perspective) drawing.lines.push_back({eye.eye, corners[i], Ink::V, 0.6f, 0.6f});
    }
    const auto label = [&](std::size_t corner, std::string text) {
        drawing.labels.push_back({.kind = Label::Kind::Plane,
                                  .at = corners[corner],
                                  .foot = (corners[corner] + corners[(corner & 4) + ((corner + 2) & 3)]) / 2.0,
                                  .text = std::move(text),
                                  .distance = {},
                                  .ink = Ink::V});
    };
    label(0, "near " + threeDigits(eye.near));
    label(5, "far " + threeDigits(eye.far));
}

void addMarkedPoint(const ViewContent& content, Drawing& drawing) {
    drawing.vertex = content.markedVertex;
    if (!content.stepRay) return;
    const auto& [pixel, from, to] = *content.stepRay;
    const Vec3d begin = content.eye.perspective && content.map.keepsLengths() ? content.eye.eye : from;
    drawing.lines.push_back({begin, to, Ink::V, 1, 1});
    drawing.obstacles.push_back({begin, to});
    drawing.labels.push_back({.kind = Label::Kind::Caption,
                              .at = to,
                              .foot = begin,
                              .text = "ray of " + std::to_string(pixel.x) + ", " + std::to_string(pixel.y),
                              .distance = {},
                              .ink = Ink::V});
    if (!drawing.vertex) drawing.vertex = to;
}

}  // namespace app
