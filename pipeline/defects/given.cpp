// Defects that rewrite what the stages are given.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/defects/defect_table.h"
#include "pipeline/defects/hooks.h"
#include "pipeline/defects/own.h"
#include "pipeline/plan/stage_keys.h"
#include "pipeline/scene/view.h"

namespace pipeline {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

bool isUsable(const View& view) {
    return std::isfinite(view.scale.x) && std::isfinite(view.scale.y) && view.scale.x != 0 && view.scale.y != 0;
}

// The view of a scene whose camera is another.
template <class Change>
void spoilCamera(const Scene& scene, StageKeys& keys, Change change) {
    Scene other = scene;
    change(other.camera);
    if (const View view = makeView(other); isUsable(view)) keys.transform.view = view;
    keys.shading.lights = lightsInWorldSpace(scene, keys.transform.view);
}

// The distance that z-buffers are cleared to by somebody who takes the middle of the scene for far away.
double middleDepth(const Scene& scene) {
    const Camera& camera = scene.camera;
    return camera.kind == CameraKind::Spherical ? camera.rho : glm::length(camera.target - camera.eye);
}

// Of the ways of a defect, its number; the last stands for those beyond it.
template <std::size_t count>
double ofWay(const double (&values)[count], std::size_t way) {
    return values[std::min(way, count - 1)];
}

// defectWay holds the way and, times this, the way of half-pixel that the samples lie at.
constexpr int kSamplesAt = 100;
constexpr int kUnmoved = 99;  // a way of half-pixel that moves nothing: the samples alone are elsewhere
int wayOf(const Settings& settings) { return settings.defectWay % kSamplesAt; }

// By how much the picture is moved, pixels: as the ways of half-pixel say.
glm::dvec2 halfPixelOf(std::size_t way) {
    constexpr double kSigns[][2]{{-1, -1}, {1, 1}, {1, -1}, {-1, 1}, {2, 0}, {-2, 0}, {0, 2}, {0, -2}};
    if (way == kUnmoved) return {0, 0};
    const double* const sign = kSigns[std::min(way, std::size(kSigns) - 1)];
    return {0.5 * sign[0], 0.5 * sign[1]};
}

// y down, or R transposed.
void spoilAxes(const Planted& planted, View& view) {
    if (planted.way == 0) {
        view.scale.y = -view.scale.y;
        return;
    }
    const glm::dmat3 turned = glm::transpose(glm::dmat3(view.right, view.up, view.forward));
    view.right = turned[0], view.up = turned[1], view.forward = turned[2];
}

void spoilTranslations(StageKeys& keys) {
    constexpr double kFarthest = 1e9;  // as far as a scene may put an object: squares of edges remain numbers
    for (ObjectTransform& transform : keys.transform.transforms)
        transform.translation =
            glm::clamp(makeObjectMatrix(transform).linear * transform.translation, Vec3d(-kFarthest), Vec3d(kFarthest));
}

void spoilRotations(StageKeys& keys, double factor) {
    for (ObjectTransform& transform : keys.transform.transforms) {
        transform.rotation *= factor;
        for (AxisTurn& turn : transform.turns) turn.angle *= factor;
    }
}

// A light's numbers, taken for those of a space whose axes are the eye's: x right, y up, z towards the viewer, or away.
void spoilLightSpace(const Planted& planted, StageKeys& keys) {
    const double away = planted.way % 2 == 0 ? -1 : 1;
    const View& view = keys.transform.view;
    for (Light& light : keys.shading.lights) {
        const Vec3d p = light.position;
        light.position = p.x * view.right + p.y * view.up + away * p.z * view.forward;
        if (light.kind != LightKind::AtInfinity) light.position += view.eye;
    }
}

void spoilShadowBias(const Planted& planted, StageKeys& keys) {
    ShadowSettings& shadow = keys.shading.shadow;
    shadow.bias = ShadowBias::Constant, shadow.biasValue = 0;
    if (planted.defect == Defect::NoBias && planted.way == 0) return;
    // Shares of the scene's depth.
    const View& view = keys.transform.view;
    if (planted.defect == Defect::NoBias) {  // with the wrong sign
        shadow.biasValue = -(view.far - view.near) / 64;
        return;
    }
    shadow.biasValue = ofWay({1.0 / 4, 1.0 / 8, 1.0 / 2}, planted.way) * (view.far - view.near);
}

// Who changes its own text.
void tellStage(const Scene& scene, Planted planted, StageKeys& keys) {
    using enum Defect;
    switch (planted.defect) {
        case NormalMatrix:
            if (planted.way >= 3) keys.normals.planted = planted;
            [[fallthrough]];
        case ClipNormals: keys.transform.planted = planted; return;
        case NormalSpace:  // of given normals, and of polygons
            keys.transform.planted = keys.normals.planted = planted;
            return;
        case CullSign:
        case CullAxis:
        case NearDrop: keys.cull.planted = planted; return;
        case NormalFlip: keys.normals.planted = planted; return;
        case ZClear: planted.value = middleDepth(scene); [[fallthrough]];
        case ZFlip:
        case ZNoWrite:
        case ZAffine: keys.zBuffer.planted = planted; return;
        case ShadowSpace: keys.shading.shadow.eye = keys.transform.view; [[fallthrough]];
        case ShadowFlip: keys.shading.shadow.planted = planted; return;
        case LRaw:
        case LightFrom:
        case NoMax:
        case SpecBehind:
        case RFlip:
        case HRaw:
        case KsKd:
        case FadeTwice:
        case NoSpecular: keys.shading.illumination.detail.planted = planted; return;
        case LightInEye:
            if (planted.way < 2) return;
            keys.shading.shadow.eye = keys.transform.view, keys.shading.planted = planted;
            return;
        case EyeAtOrigin: keys.shading.shadow.eye = keys.transform.view, keys.shading.planted = planted; return;
        case Exponent:
            if (planted.way >= 2) keys.shading.illumination.detail.planted = planted;
            return;
        case NormalShort: keys.shading.illumination.detail.planted = planted; [[fallthrough]];
        case AmbientInShadow:
        case AmbientPerLight:
        case NoAmbient:
        case Integer:
        case Wrap:
        case Gamma:
        case NoScale:
        case Bgr:
        case Unsorted: keys.shading.planted = planted; return;
        default: return;
    }
}

// The stage that calls it; keys.transform.view is that of the scene.
void tellOwn(const Own& own, const Camera& camera, StageKeys& keys) {
    Planted planted{.own = &own};
    if (own.function == OwnFunction::Camera) {
        if (camera.kind != CameraKind::Spherical) return;
        planted.value = camera.theta, planted.second = camera.phi;
    }
    switch (ownContract(own.function).stage) {
        case StageId::Transform: keys.transform.planted = planted; return;
        case StageId::Cull: keys.cull.planted = planted; return;
        case StageId::Normals: keys.normals.planted = planted; return;
        case StageId::ShadowBuffer: keys.shading.shadow.planted = planted; return;
        case StageId::ZBuffer: keys.zBuffer.planted = planted; return;
        case StageId::Shading:
            keys.shading.planted = keys.shading.shadow.planted = keys.shading.illumination.detail.planted = planted;
            keys.shading.shadow.eye = keys.transform.view;
            return;
    }
}

void spoilView(const Scene& scene, const Planted& planted, StageKeys& keys) {
    View& view = keys.transform.view;
    const double aspect = double(view.size.x) / view.size.y;
    switch (planted.defect) {
        case Defect::Radians:
            spoilCamera(scene, keys, [](Camera& camera) {
                camera.theta *= kDegrees, camera.phi *= kDegrees, camera.fovY *= kDegrees;
            });
            if (planted.way == 1) spoilRotations(keys, kDegrees);
            return;
        case Defect::YDown: spoilAxes(planted, view); return;
        case Defect::HalfPixel: view.centre += halfPixelOf(planted.way); return;
        case Defect::HalfAngle:
            if (planted.way > 0) {  // divided by the distance of what the camera looks at instead of z
                if (view.perspective) view.perspective = false, view.scale /= middleDepth(scene);
                return;
            }
            if (2 * scene.camera.fovY < 180) spoilCamera(scene, keys, [](Camera& camera) { camera.fovY *= 2; });
            return;
        case Defect::Aspect: view.scale.x *= planted.way == 0 ? aspect * aspect : aspect; return;
        case Defect::NearSmall:
            if (view.perspective) view.near *= ofWay({1.0 / 20, 1.0 / 100, 1.0 / 1000}, planted.way);
            return;
        default: return;
    }
}

}  // namespace

Scene sampledAt(Scene scene, PixelCorner corner) {
    if (corner == PixelCorner::None) return scene;
    const int way = corner == PixelCorner::UpperLeft ? 1 : 2;
    if (scene.settings.defect == Defect::None)
        return plant(std::move(scene), Defect::HalfPixel, kUnmoved + way * kSamplesAt);
    scene.settings.defectWay = wayOf(scene.settings) + way * kSamplesAt;
    return scene;
}

glm::dvec2 sampleShiftOf(const Scene& scene) {
    const int way = scene.settings.defectWay / kSamplesAt;
    return way > 0 ? halfPixelOf(std::size_t(way)) : glm::dvec2(0);
}

void spoilGiven(const Scene& scene, StageKeys& keys) {
    if (scene.settings.own) tellOwn(*scene.settings.own, scene.camera, keys);
    const int way = wayOf(scene.settings);
    const Planted planted{scene.settings.defect, std::uint8_t(std::clamp(way, 0, 255)), 0};
    spoilView(scene, planted, keys);
    keys.transform.view.centre += sampleShiftOf(scene);
    switch (planted.defect) {
        case Defect::TrsOrder: spoilTranslations(keys); break;
        case Defect::Degrees: spoilRotations(keys, 1 / kDegrees); break;
        case Defect::LightInEye: spoilLightSpace(planted, keys); break;
        case Defect::NoBias:
        case Defect::BigBias: spoilShadowBias(planted, keys); break;
        case Defect::Affine: keys.shading.interpolation = Interpolation::Affine; break;
        case Defect::Exponent:
            if (planted.way >= 2) break;  // within the term
            for (std::vector<Material>* materials : {&keys.shading.materials, &keys.shading.backMaterials})
                for (Material& material : *materials) material.exponent *= planted.way == 0 ? 4 : 0.25;
            break;
        default: break;
    }
    tellStage(scene, planted, keys);
}

namespace {

// A mesh with other polygons. corners: what becomes of the corners of polygon p.
template <class Corners>
std::shared_ptr<const Mesh> withCorners(const Mesh& mesh, Corners corners) {
    Mesh out;
    out.file = mesh.file, out.positions = mesh.positions, out.normals = mesh.normals, out.colors = mesh.colors;
    out.polygonPlaces = mesh.polygonPlaces;
    out.reservePolygons(mesh.polygonCount(), mesh.cornerCount());
    for (std::size_t p = 0; p < mesh.polygonCount(); ++p) {
        const std::span<const std::uint32_t> polygon = mesh.polygon(p);
        std::vector<std::uint32_t> changed(polygon.begin(), polygon.end());
        corners(p, changed);
        out.addPolygon(changed);
    }
    return makeMesh(std::move(out));
}

bool areAlike(const Mesh& a, const Mesh& b) {
    return a.triangles == b.triangles && a.corners == b.corners && a.firstCorner == b.firstCorner &&
           a.positions == b.positions && a.normals == b.normals && a.colors == b.colors;
}

}  // namespace

void spoilMeshes(const Scene& scene, const Topology* before, std::vector<std::shared_ptr<const Mesh>>& meshes) {
    const Settings& settings = scene.settings;
    if (settings.defect != Defect::Winding && settings.defect != Defect::OneBased) return;
    bool isReversed = false;  // one polygon is, the one in the middle of the first mesh that has any
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const Mesh& mesh = *meshes[i];
        const auto vertices = std::uint32_t(mesh.positions.size());
        if (mesh.polygonCount() == 0) continue;
        if (settings.defect == Defect::OneBased) {
            // The number of a vertex, counted from 1, read as if from 0; the vertex after the last is the first.
            const std::uint32_t next = wayOf(settings) == 0 ? 1 : vertices - 1;
            meshes[i] = withCorners(mesh, [&](std::size_t, std::vector<std::uint32_t>& corners) {
                for (std::uint32_t& corner : corners) corner = (corner + next) % vertices;
            });
        } else {
            const bool all = wayOf(settings) > 0;
            if (isReversed && !all) continue;
            meshes[i] = withCorners(mesh, [&](std::size_t polygon, std::vector<std::uint32_t>& corners) {
                if (all || polygon == mesh.polygonCount() / 2) std::ranges::reverse(corners);
            });
            isReversed = true;
        }
        if (before && i < before->meshes.size() && areAlike(*before->meshes[i], *meshes[i]))
            meshes[i] = before->meshes[i];
    }
}

}  // namespace pipeline
