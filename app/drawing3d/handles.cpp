#include "app/drawing3d/handles.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "app/drawing3d/world_drawing.h"
#include "app/look/numbers.h"
#include "pipeline/stages/transform.h"

namespace app {

namespace {

const std::vector<HandleArm> kWorldArms{{"x", {1, 0, 0}}, {"y", {0, 1, 0}}, {"z", {0, 0, 1}}};

std::string three(const char* a, const char* b, const char* c, Vec3d v, int decimals) {
    const auto part = [&](const char* name, double value) {
        return name + (' ' + number(value, decimals)).toStdString();
    };
    return part(a, v.x) + "  " + part(b, v.y) + "  " + part(c, v.z);
}

// As many decimals as tell a thousandth of the largest apart.
int decimalsOf(Vec3d v) { return app::decimalsOf(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)})); }

// Takes directions through these turns.
glm::dmat3 turnedBy(std::span<const pipeline::AxisTurn> turns) {
    pipeline::ObjectTransform transform;
    transform.turns.assign(turns.begin(), turns.end());
    return pipeline::makeObjectMatrix(transform).linear;
}

Vec3d unit(Vec3d v) { return glm::length(v) > 0 ? glm::normalize(v) : Vec3d(0, 0, 1); }

// Each arm changes one number alone: what is written after it turns its axis with the object.
Handle turnHandle(const pipeline::ObjectTransform& transform) {
    Handle handle{.tool = HandleTool::Turn, .at = transform.translation, .name = {}};
    if (transform.turns.empty()) {
        handle.value = transform.rotation;
        pipeline::ObjectTransform outer;
        outer.rotation = {0, 0, transform.rotation.z};
        const Vec3d y = pipeline::makeObjectMatrix(outer).linear[1];
        outer.rotation.y = transform.rotation.y;
        const Vec3d x = pipeline::makeObjectMatrix(outer).linear[0];
        handle.arms = {{"x", x}, {"y", y}, {"z", {0, 0, 1}}};
        return handle;
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(transform.turns.size(), 3); ++i) {
        const std::span before(transform.turns.data(), i);
        handle.value[int(i)] = transform.turns[i].angle;
        handle.arms.push_back({std::to_string(i), unit(turnedBy(before) * transform.turns[i].axis)});
    }
    return handle;
}

Handle scaleHandle(const pipeline::ObjectTransform& transform) {
    pipeline::ObjectTransform turns = transform;
    turns.scale = Vec3d(1.0);
    const glm::dmat3 axes = pipeline::makeObjectMatrix(turns).linear;
    return {.tool = HandleTool::Scale,
            .at = transform.translation,
            .value = transform.scale,
            .arms = {{"x", axes[0]}, {"y", axes[1]}, {"z", axes[2]}},
            .name = {}};
}

Handle moveHandle(Handle::Kind kind, std::size_t index, Vec3d at, std::string name) {
    return {.kind = kind, .index = index, .at = at, .value = at, .arms = kWorldArms, .name = std::move(name)};
}

Handle directionHandle(Handle::Kind kind, std::size_t index, Vec3d at, Vec3d centre, std::string name) {
    return {.kind = kind, .index = index, .at = at, .centre = centre, .value = at, .arms = {}, .name = std::move(name)};
}

// Where a light that is somewhere shines to; nothing where that is all around.
std::optional<Vec3d> facingOf(const pipeline::Scene& scene, const pipeline::Light& light) {
    if (light.kind == pipeline::LightKind::Area) return light.area.facing;
    const bool isSpot = pipeline::modelFacts(scene.settings.model).found.glLights &&
                        light.kind == pipeline::LightKind::Point && light.gl.spotCutoff < 180;
    return isSpot ? std::optional(light.gl.spotDirection) : std::nullopt;
}

void addLights(const pipeline::Scene& scene, const ViewContent& shown, std::vector<Handle>& handles) {
    using Kind = Handle::Kind;
    for (const LightMark& mark : shown.lights) {
        const auto k = std::size_t(mark.light);
        if (k >= scene.lights.size()) continue;
        // One that stands in eye space moves with the camera.
        const bool withEye = pipeline::modelFacts(scene.settings.model).found.glLights &&
                             scene.lights[k].gl.space == pipeline::LightSpace::Eye;
        if (withEye || (shown.map.space == ViewSpace::Light && shown.map.light == mark.light)) continue;
        const std::string name = "light " + std::to_string(k);
        const auto toWorld = [&](Vec3d p) { return shown.map.toWorld(p); };
        if (mark.atInfinity) {
            handles.push_back(directionHandle(Kind::LightDirection, k, toWorld(lightDisc(mark, shown)),
                                              toWorld(shown.bounds.centre()), name));
            continue;
        }
        const Vec3d at = scene.lights[k].position;
        handles.push_back(moveHandle(Kind::Light, k, at, name));
        if (const auto facing = facingOf(scene, scene.lights[k]))
            handles.push_back(directionHandle(Kind::LightFacing, k, at + 0.45 * shown.bounds.radius() * unit(*facing),
                                              at, name + "'s direction"));
    }
}

std::optional<Handle> objectHandle(const pipeline::Scene& scene, const ViewContent& shown, std::size_t index,
                                   HandleTool tool) {
    if (index >= scene.objects.size() || index >= shown.mesh->objects.size()) return {};
    const pipeline::Object& object = scene.objects[index];
    Handle handle;
    if (tool == HandleTool::Move || !shown.map.keepsLengths()) {
        const pipeline::BoundingBox& box = shown.mesh->objects[index].box;
        handle = moveHandle(Handle::Kind::Object, index, (box.min + box.max) / 2.0, {});
    } else {
        handle = tool == HandleTool::Turn ? turnHandle(object.transform) : scaleHandle(object.transform);
    }
    if (!shown.map.keepsLengths()) handle.arms.clear();
    handle.index = index;
    handle.name = object.name;
    return handle;
}

// A direction of the same length; a thousandth of it is finer than a pixel turns it.
Vec3d turnedTo(Vec3d old, Vec3d towards) {
    const double length = glm::length(old) > 0 ? glm::length(old) : 1;
    return roundedTo(length * glm::normalize(towards), stepBelow(length / 300));
}

void moveCamera(pipeline::Camera& camera, Vec3d at) {
    if (camera.kind == pipeline::CameraKind::LookAt) {
        camera.eye = at;
        return;
    }
    const double rho = glm::length(at);
    if (!(rho > 0)) return;
    const auto tenth = [](double degrees) { return std::round(degrees * 10) / 10; };
    camera.rho = std::round(rho / stepBelow(rho / 300)) * stepBelow(rho / 300);
    camera.phi = tenth(glm::degrees(std::acos(std::clamp(at.z / rho, -1.0, 1.0))));
    // On the axis θ is anything: it stays.
    if (at.x == 0 && at.y == 0) return;
    const double theta = tenth(glm::degrees(std::atan2(at.y, at.x)));
    camera.theta = theta + 360 * std::round((camera.theta - theta) / 360);
}

void changeObject(pipeline::ObjectTransform& transform, const Handle& handle, Vec3d value) {
    switch (handle.tool) {
        case HandleTool::Move: transform.translation += value - handle.value; break;
        case HandleTool::Scale: transform.scale = value; break;
        case HandleTool::Turn:
            if (transform.turns.empty()) transform.rotation = value;
            for (std::size_t i = 0; i < std::min<std::size_t>(transform.turns.size(), 3); ++i)
                transform.turns[i].angle = value[int(i)];
            break;
    }
}

std::string degreesOf(const Handle& handle, const pipeline::ObjectTransform& transform) {
    std::string text = transform.turns.empty() ? "rotation" : "turns";
    for (std::size_t i = 0; i < handle.arms.size(); ++i) {
        const double value = transform.turns.empty() ? transform.rotation[int(i)] : transform.turns[i].angle;
        text += (i == 0 ? " " : "  ") + handle.arms[i].name + ' ' + angle(value).toStdString();
    }
    return text;
}

}  // namespace

double stepBelow(double unit) { return std::pow(10.0, std::floor(std::log10(unit))); }

Vec3d roundedTo(Vec3d p, double step) { return glm::round(p / step) * step; }

bool finite(Vec3d v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::vector<Handle> handlesOf(const pipeline::Scene& scene, const ViewContent& shown, std::optional<std::size_t> object,
                              HandleTool tool) {
    std::vector<Handle> handles;
    addLights(scene, shown, handles);
    const ViewSpace space = shown.map.space;
    if (space == ViewSpace::World || space == ViewSpace::Light) {
        handles.push_back(moveHandle(Handle::Kind::Eye, 0, pipeline::makeView(scene).eye, "camera"));
        if (scene.camera.kind == pipeline::CameraKind::LookAt)
            handles.push_back(moveHandle(Handle::Kind::Target, 0, scene.camera.target, "camera's target"));
    }
    if (object)
        if (const auto handle = objectHandle(scene, shown, *object, tool)) handles.push_back(*handle);
    std::erase_if(handles, [](const Handle& handle) { return !finite(handle.at); });
    return handles;
}

bool isIn(const pipeline::Scene& scene, const Handle& handle) {
    switch (handle.kind) {
        case Handle::Kind::Light:
        case Handle::Kind::LightDirection:
        case Handle::Kind::LightFacing: return handle.index < scene.lights.size();
        case Handle::Kind::Object: return handle.index < scene.objects.size();
        case Handle::Kind::Eye:
        case Handle::Kind::Target: break;
    }
    return true;
}

pipeline::Scene withHandleAt(const pipeline::Scene& scene, const Handle& handle, Vec3d value) {
    pipeline::Scene result = scene;
    if (value == handle.value) return result;
    switch (handle.kind) {
        case Handle::Kind::Light: result.lights[handle.index].position = value; break;
        case Handle::Kind::LightDirection: {
            Vec3d& direction = result.lights[handle.index].position;
            direction = turnedTo(direction, value - handle.centre);
            break;
        }
        case Handle::Kind::LightFacing: {
            pipeline::Light& light = result.lights[handle.index];
            Vec3d& facing = light.kind == pipeline::LightKind::Area ? light.area.facing : light.gl.spotDirection;
            facing = turnedTo(facing, value - handle.centre);
            break;
        }
        case Handle::Kind::Target: result.camera.target = value; break;
        case Handle::Kind::Object: changeObject(result.objects[handle.index].transform, handle, value); break;
        case Handle::Kind::Eye: moveCamera(result.camera, value); break;
    }
    return result;
}

std::string numbersOf(const pipeline::Scene& scene, const Handle& handle) {
    const auto place = [](Vec3d v) { return three("x", "y", "z", v, decimalsOf(v)); };
    switch (handle.kind) {
        case Handle::Kind::Light:
        case Handle::Kind::LightDirection: return place(scene.lights[handle.index].position);
        case Handle::Kind::Target: return place(scene.camera.target);
        case Handle::Kind::LightFacing: {
            const pipeline::Light& light = scene.lights[handle.index];
            return place(light.kind == pipeline::LightKind::Area ? light.area.facing : light.gl.spotDirection);
        }
        case Handle::Kind::Object: {
            const pipeline::ObjectTransform& transform = scene.objects[handle.index].transform;
            if (handle.tool == HandleTool::Turn) return degreesOf(handle, transform);
            if (handle.tool == HandleTool::Scale) return "scale " + place(transform.scale);
            return "translation " + place(transform.translation);
        }
        case Handle::Kind::Eye: break;
    }
    const pipeline::Camera& camera = scene.camera;
    if (camera.kind == pipeline::CameraKind::LookAt) return place(camera.eye);
    return "ρ " + number(camera.rho, decimalsOf(Vec3d(camera.rho))).toStdString() + "  θ " +
           angle(camera.theta).toStdString() + "  φ " + angle(camera.phi).toStdString();
}

}  // namespace app
