#include "app/view3d/handles.h"

#include <algorithm>
#include <cmath>

#include "app/core/numbers.h"
#include "app/view3d/world_drawing.h"

namespace app {

namespace {

constexpr double kReach = 13, kTipReach = 10, kAxisLength = 46;  // logical pixels
constexpr std::array<Vec3d, 3> kAxes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

double unitAt(const ViewFrame& view, Vec3d point) {
    const OrbitCamera& camera = view.camera;
    const double unit = camera.unitsPerPixel(view.size.y);
    if (camera.orthographic) return unit;
    return unit * std::max(glm::dot(point - camera.position(), camera.forward) / camera.distance, 1e-3);
}

double stepBelow(double unit) { return std::pow(10.0, std::floor(std::log10(unit))); }

Vec3d rounded(Vec3d p, double step) { return glm::round(p / step) * step; }

bool finite(Vec3d v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

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

std::string three(const char* a, const char* b, const char* c, Vec3d v, int decimals) {
    const auto part = [&](const char* name, double value) {
        return name + (' ' + number(value, decimals)).toStdString();
    };
    return part(a, v.x) + "  " + part(b, v.y) + "  " + part(c, v.z);
}

// As many decimals as tell a thousandth of the largest apart.
int decimalsOf(Vec3d v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return largest > 0 ? std::clamp(2 - int(std::floor(std::log10(largest))), 0, 9) : 0;
}

}  // namespace

std::vector<Handle> handlesOf(const pipeline::Scene& scene, const ViewContent& world,
                              std::optional<std::size_t> object) {
    std::vector<Handle> handles;
    using Kind = Handle::Kind;
    for (const LightMark& mark : world.lights) {
        const auto k = std::size_t(mark.light);
        if (k >= scene.lights.size()) continue;
        // One that stands in eye space moves with the camera.
        const bool withEye =
            scene.settings.model == pipeline::Model::OpenGl && scene.lights[k].gl.space == pipeline::LightSpace::Eye;
        if (withEye) continue;
        const std::string name = "light " + std::to_string(k);
        if (mark.atInfinity)
            handles.push_back({Kind::LightDirection, k, lightDisc(mark, world), world.bounds.centre(), name});
        else
            handles.push_back({Kind::Light, k, mark.position, {}, name});
    }
    handles.push_back({Kind::Eye, 0, world.eye.eye, {}, "camera"});
    if (scene.camera.kind == pipeline::CameraKind::LookAt)
        handles.push_back({Kind::Target, 0, scene.camera.target, {}, "camera's target"});
    if (object && *object < scene.objects.size() && *object < world.mesh->objects.size()) {
        const pipeline::BoundingBox& box = world.mesh->objects[*object].box;
        handles.push_back({Kind::Object, *object, (box.min + box.max) / 2.0, {}, scene.objects[*object].name});
    }
    std::erase_if(handles, [](const Handle& handle) { return !finite(handle.at); });
    return handles;
}

std::array<glm::dvec2, 3> axisTips(const Handle& handle, const ViewFrame& view) {
    std::array<glm::dvec2, 3> tips;
    const double unit = unitAt(view, handle.at);
    for (std::size_t i = 0; i < 3; ++i)
        tips[i] = project(view.camera, view.size, handle.at + kAxisLength * unit * kAxes[i]).at;
    return tips;
}

std::optional<Grip> gripAt(std::span<const Handle> handles, std::optional<std::size_t> hot, const ViewFrame& view,
                           glm::dvec2 cursor) {
    if (hot && *hot < handles.size() && handles[*hot].kind != Handle::Kind::LightDirection) {
        const auto tips = axisTips(handles[*hot], view);
        const glm::dvec2 middle = project(view.camera, view.size, handles[*hot].at).at;
        for (std::size_t i = 0; i < 3; ++i)
            if (glm::length(tips[i] - cursor) < kTipReach && glm::length(cursor - middle) > kReach / 2)
                return Grip{*hot, DragAxis(i + 1)};
    }
    std::optional<Grip> best;
    double nearest = kReach;
    for (std::size_t i = 0; i < handles.size(); ++i) {
        const Projected p = project(view.camera, view.size, handles[i].at);
        if (!p.inFront || glm::length(p.at - cursor) >= nearest) continue;
        nearest = glm::length(p.at - cursor);
        best = Grip{i, DragAxis::Screen};
    }
    return best;
}

Vec3d draggedTo(const Handle& handle, DragAxis axis, const ViewFrame& view, glm::dvec2 moved) {
    if (moved == glm::dvec2(0.0)) return handle.at;
    const glm::dvec2 begin = project(view.camera, view.size, handle.at).at;
    const Ray ray = rayThrough(view.camera, view.size, begin + moved);
    if (handle.kind == Handle::Kind::LightDirection) return onSphere(ray, handle.centre, handle.at);
    const std::optional<Vec3d> found = axis == DragAxis::Screen ? onScreenPlane(ray, view.camera, handle.at)
                                                                : onAxis(ray, handle.at, kAxes[std::size_t(axis) - 1]);
    if (!found || !finite(*found)) return handle.at;
    const Vec3d result = rounded(*found, stepBelow(unitAt(view, handle.at)));
    if (axis == DragAxis::Screen) return result;
    Vec3d only = handle.at;  // the other two stay as they were, to the last bit
    const auto i = int(axis) - 1;
    only[i] = result[i];
    return only;
}

pipeline::Scene withHandleAt(const pipeline::Scene& scene, const Handle& handle, Vec3d at) {
    pipeline::Scene result = scene;
    if (at == handle.at) return result;
    switch (handle.kind) {
        case Handle::Kind::Light: result.lights[handle.index].position = at; break;
        case Handle::Kind::LightDirection: {
            Vec3d& direction = result.lights[handle.index].position;
            const double length = glm::length(direction);
            const Vec3d turned = length * glm::normalize(at - handle.centre);
            // A thousandth of its length is finer than a pixel turns it.
            direction = rounded(turned, stepBelow(length / 300));
            break;
        }
        case Handle::Kind::Target: result.camera.target = at; break;
        case Handle::Kind::Object: result.objects[handle.index].transform.translation += at - handle.at; break;
        case Handle::Kind::Eye: {
            pipeline::Camera& camera = result.camera;
            if (camera.kind == pipeline::CameraKind::LookAt) {
                camera.eye = at;
                break;
            }
            const double rho = glm::length(at);
            if (!(rho > 0)) break;
            const auto tenth = [](double degrees) { return std::round(degrees * 10) / 10; };
            camera.rho = std::round(rho / stepBelow(rho / 300)) * stepBelow(rho / 300);
            camera.phi = tenth(glm::degrees(std::acos(std::clamp(at.z / rho, -1.0, 1.0))));
            // On the axis θ is anything: it stays.
            if (at.x == 0 && at.y == 0) break;
            const double theta = tenth(glm::degrees(std::atan2(at.y, at.x)));
            camera.theta = theta + 360 * std::round((scene.camera.theta - theta) / 360);
            break;
        }
    }
    return result;
}

std::string numbersOf(const pipeline::Scene& scene, const Handle& handle) {
    const auto place = [](Vec3d v) { return three("x", "y", "z", v, decimalsOf(v)); };
    switch (handle.kind) {
        case Handle::Kind::Light:
        case Handle::Kind::LightDirection: return place(scene.lights[handle.index].position);
        case Handle::Kind::Target: return place(scene.camera.target);
        case Handle::Kind::Object: return "translation " + place(scene.objects[handle.index].transform.translation);
        case Handle::Kind::Eye: break;
    }
    const pipeline::Camera& camera = scene.camera;
    if (camera.kind == pipeline::CameraKind::LookAt) return place(camera.eye);
    return "ρ " + number(camera.rho, decimalsOf(Vec3d(camera.rho))).toStdString() + "  θ " +
           angle(camera.theta).toStdString() + "  φ " + angle(camera.phi).toStdString();
}

}  // namespace app
