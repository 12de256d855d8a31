// Defects that rewrite what the stages are given.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/core/elementary.h"
#include "pipeline/defects/defect_table.h"
#include "pipeline/defects/defect_ways.h"
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

// Settings::defectWay of a scene that a program plants holds more than the way, which is all that a scene's text may state:
// the way of half-pixel that the samples lie at, and a second defect with its way.
struct Ways {
    int way = 0, samples = 0, second = 0, secondWay = 0;
};
constexpr int kMostWays = 100, kMostSamples = 10, kMostDefects = 1000;
static_assert(kDefectCount < kMostDefects);
Ways waysOf(const Settings& settings) {
    const int samples = settings.defectWay / kMostWays, second = samples / kMostSamples;
    return {settings.defectWay % kMostWays, samples % kMostSamples, second % kMostDefects, second / kMostDefects};
}
int packed(const Ways& ways) {
    return ((ways.secondWay * kMostDefects + ways.second) * kMostSamples + ways.samples) * kMostWays + ways.way;
}
constexpr int kUnmoved = 99;  // a way of half-pixel that moves nothing: the samples alone are elsewhere

// The defects of a scene, each with its way, in the order in which they were planted.
std::vector<Planted> plantedIn(const Settings& settings) {
    const Ways ways = waysOf(settings);
    std::vector<Planted> all{{settings.defect, std::uint8_t(ways.way)}};
    if (ways.second > 0) all.push_back({Defect(ways.second), std::uint8_t(ways.secondWay)});
    return all;
}

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

// The inputs in which a defect is told to those who change their own text for it.
std::vector<Planted*> toldOf(const Planted& planted, StageKeys& keys) {
    using enum Defect;
    Planted *const light = &keys.shading.illumination.detail.planted, *const shading = &keys.shading.planted;
    switch (planted.defect) {
        case NormalMatrix:
            if (planted.way >= 3 && planted.way != kGivenUntouched)
                return {&keys.normals.planted, &keys.transform.planted};
            return {&keys.transform.planted};
        case ClipNormals: return {&keys.transform.planted};
        case NormalSpace: return {&keys.transform.planted, &keys.normals.planted};  // of given normals, and of polygons
        case CullSign:
        case CullAxis:
        case NearDrop: return {&keys.cull.planted};
        case NormalFlip: return {&keys.normals.planted};
        case ZClear:
        case ZFlip:
        case ZNoWrite:
        case ZAffine: return {&keys.zBuffer.planted};
        case ShadowSpace:
        case ShadowFlip: return {&keys.shading.shadow.planted};
        case LRaw:
        case LightFrom:
        case NoMax:
        case SpecBehind:
        case RFlip:
        case HRaw:
        case KsKd:
        case FadeTwice:
        case NoSpecular: return {light};
        case HalfAngle: return planted.way == kOneDistance ? std::vector{shading} : std::vector<Planted*>();
        case Affine: return planted.way == kPositionToo ? std::vector{light, shading} : std::vector<Planted*>();
        case Exponent: return planted.way >= 2 ? std::vector{light} : std::vector<Planted*>();
        case LightInEye: return planted.way >= 2 ? std::vector{shading} : std::vector<Planted*>();
        case NormalShort:
            if (planted.way == kMeanNotUnit) return {light, shading, &keys.normals.planted};
            return {light, shading};
        case EyeAtOrigin:
        case AmbientInShadow:
        case AmbientPerLight:
        case NoAmbient:
        case Integer:
        case BlocksOfFour:
        case Wrap:
        case Gamma:
        case NoScale:
        case Bgr:
        case Unsorted: return {shading};
        default: return {};
    }
}

void tellStage(const Scene& scene, Planted planted, StageKeys& keys) {
    if (planted.defect == Defect::ZClear) planted.value = middleDepth(scene);
    if (planted.defect == Defect::CullAxis && planted.way == kAlongTheLight && !keys.shading.lights.empty()) {
        const Vec3d l = keys.shading.lights[0].position;  // its direction, as two angles
        planted.value = kDegrees * pipeline::atan2(l.y, l.x);
        planted.second = kDegrees * pipeline::atan2(l.z, glm::length(glm::dvec2(l)));
    }
    using enum Defect;
    if (planted.defect == ShadowSpace || planted.defect == LightInEye || planted.defect == EyeAtOrigin ||
        planted.defect == HalfAngle)
        keys.shading.shadow.eye = keys.transform.view;
    for (Planted* const told : toldOf(planted, keys)) *told = planted;
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
            if (planted.way == kOneDistance) {  // divided by the distance of what the camera looks at instead of z
                if (view.perspective) view.perspective = false, view.scale /= middleDepth(scene);
                return;
            }
            if (planted.way > kOneDistance)
                spoilCamera(scene, keys, [](Camera& camera) { camera.fovY /= 2; });
            else if (2 * scene.camera.fovY < 180)
                spoilCamera(scene, keys, [](Camera& camera) { camera.fovY *= 2; });
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
    Ways ways = waysOf(scene.settings);
    if (scene.settings.defect == Defect::None) scene.settings.defect = Defect::HalfPixel, ways.way = kUnmoved;
    ways.samples = corner == PixelCorner::UpperLeft ? 1 : 2;
    scene.settings.defectWay = packed(ways);
    return scene;
}

glm::dvec2 sampleShiftOf(const Scene& scene) {
    const int way = waysOf(scene.settings).samples;
    return way > 0 ? halfPixelOf(std::size_t(way)) : glm::dvec2(0);
}

Scene plantToo(Scene scene, Defect defect, int way) {
    if (scene.settings.defect == Defect::None) return plant(std::move(scene), defect, way);
    Ways ways = waysOf(scene.settings);
    if (ways.second > 0 || scene.settings.defect == defect) return scene;
    StageKeys keys{};
    const std::vector<Planted*> first = toldOf(plantedIn(scene.settings)[0], keys);
    for (Planted* const told : toldOf({defect, std::uint8_t(way)}, keys))
        if (std::ranges::find(first, told) != first.end()) return scene;
    ways.second = int(index(defect)), ways.secondWay = way;
    scene.settings.defectWay = packed(ways);
    return scene;
}

namespace {

void spoilOne(const Scene& scene, const Planted& planted, StageKeys& keys) {
    spoilView(scene, planted, keys);
    switch (planted.defect) {
        case Defect::TrsOrder:
            if (planted.way == kTheOtherWay)
                spoilRotations(keys, -1);
            else
                spoilTranslations(keys);
            break;
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

}  // namespace

void spoilGiven(const Scene& scene, StageKeys& keys) {
    if (scene.settings.own) tellOwn(*scene.settings.own, scene.camera, keys);
    for (const Planted& planted : plantedIn(scene.settings)) spoilOne(scene, planted, keys);
    keys.transform.view.centre += sampleShiftOf(scene);
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
    for (const Planted& planted : plantedIn(scene.settings)) {
        if (planted.defect != Defect::Winding && planted.defect != Defect::OneBased) continue;
        bool isReversed = false;  // one polygon is, the one in the middle of the first mesh that has any
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            const Mesh& mesh = *meshes[i];
            const auto vertices = std::uint32_t(mesh.positions.size());
            if (mesh.polygonCount() == 0) continue;
            if (planted.defect == Defect::OneBased) {
                // The number of a vertex, counted from 1, read as if from 0; the vertex after the last is the first.
                const std::uint32_t next = planted.way == 0 ? 1 : vertices - 1;
                meshes[i] = withCorners(mesh, [&](std::size_t, std::vector<std::uint32_t>& corners) {
                    for (std::uint32_t& corner : corners) corner = (corner + next) % vertices;
                });
            } else {
                const bool all = planted.way > 0;
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
}

}  // namespace pipeline
