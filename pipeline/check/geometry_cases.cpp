#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/check/case.h"
#include "pipeline/check/scenes.h"
#include "pipeline/core/numerics.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/stages/cull.h"

// Degenerate triangles, slivers, and geometry far from the origin.
namespace pipeline::check {
namespace {

constexpr std::initializer_list<BufferId> kPicture{BufferId::Color,      BufferId::Intensity, BufferId::PolygonId,
                                                   BufferId::ZView,      BufferId::Normal,    BufferId::Overdraw,
                                                   BufferId::Barycentric};

std::size_t verdicts(const FramePtr& frame, Verdict verdict) {
    const AnyBuffer buffer = *frame->buffer({BufferId::PolygonsVerdict});
    std::size_t count = 0;
    for (std::size_t i = 0; i < buffer.count(); ++i) count += buffer.flat(i) == double(verdict);
    return count;
}

template <class Real>
Vec3<Real> naiveNormal(const Corners& corners) {
    const Vec3<Real> a(corners[0]), b(corners[1]), c(corners[2]);
    const Vec3<Real> normal = glm::cross(b - a, c - a);
    return normal / std::sqrt(glm::dot(normal, normal));
}
Long3 exactNormal(const Corners& corners) {
    const Long3 a(corners[0]), b(corners[1]), c(corners[2]);
    return glm::cross(b - a, c - a);
}

Scene equalCorners() {
    const std::array<Corners, 1> flat{Corners{Vec3d(0, 0, 2), Vec3d(0, 0, 2), Vec3d(1, 0, 2)}};
    return frontScene(6, {boxMesh(-1, 1), trianglesOf(flat)});
}
Finding runEqualCorners(Trial& trial) {
    const Scene scene = equalCorners();
    Scene without = scene;
    without.objects.pop_back();
    const FramePtr with = trial.frame(scene);
    trial.demand(verdicts(with, Verdict::Degenerate) == 1, "the triangle is not found degenerate");
    return {double(naiveNormal<float>({Vec3d(0), Vec3d(0), Vec3d(1, 0, 0)}).x),
            double(differences(with, trial.frame(without), kPicture))};
}

// Dyadic coordinates in a dyadic view: snapping rounds nothing, so that the area is 0 and not small.
std::vector<Corners> collinearTriangles() {
    Random random(2);
    std::vector<Corners> triangles;
    for (int i = 0; i < 1000; ++i) {
        const Vec3d p{random.below(64 * 32) / 32.0, random.below(64 * 32) / 32.0, random.below(256) / 32.0};
        const Vec3d d{random.below(512) / 32.0 - 8, random.below(512) / 32.0 - 8, random.below(512) / 32.0 - 8};
        triangles.push_back({p, p + d, p + 2.0 * d});
    }
    return triangles;
}
Scene collinear() { return pixelScene(64, 64, {trianglesOf(collinearTriangles())}); }
Finding runCollinear(Trial& trial) {
    Random random(3);
    int nonZero = 0;
    // What a compiler makes of a b - c d where it may contract: one of the two products is not rounded.
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 v(random.inCube(1));
        nonZero += std::fma(v.y, v.z, -(v.z * v.y)) != 0 || std::fma(v.z, v.x, -(v.x * v.z)) != 0 ||
                   std::fma(v.x, v.y, -(v.y * v.x)) != 0;
    }
    const FramePtr frame = trial.frame(collinear());
    trial.demand(drawnPixels(frame) == 0, "a triangle without area covers a pixel");
    std::size_t wrong = 1000 - verdicts(frame, Verdict::Degenerate);
    for (std::size_t i = 0; i < 1000; ++i) wrong += vectorOf(frame, {BufferId::PolygonsNormal}, i) != Vec3d(0);
    return {nonZero / 10.0, double(wrong), fmt::format("v×v ≠ 0: {:.0f} %", nonZero / 10.0), ""};
}

// Stored as float, like most model files: the reference is the normal of what is stored.
std::vector<Corners> slivers(double height) {
    Random random(5);
    std::vector<Corners> triangles;
    for (int i = 0; i < 1000; ++i) {
        const Vec3d p = random.inCube(1), along = random.direction();
        const Vec3d across = glm::normalize(glm::cross(along, random.direction()));
        Corners t{p, p + along, p + random.between(0.2, 0.8) * along + height * across};
        for (Vec3d& corner : t) corner = Vec3d(glm::vec3(corner));
        triangles.push_back(t);
    }
    return triangles;
}
Scene sliverScene() { return frontScene(4, {trianglesOf(slivers(1e-6))}); }
double worstAngle(const std::vector<Corners>& triangles, const auto& normalAt) {
    Long worst = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        if (const Long3 exact = exactNormal(triangles[i]); exact != Long3(0))
            worst = std::max(worst, degreesBetween(exact, Long3(normalAt(i))));
    return double(worst);
}
double naiveSliver(double height) {
    const auto triangles = slivers(height);
    return worstAngle(triangles, [&](std::size_t i) { return naiveNormal<float>(triangles[i]); });
}
double ourSliver(const std::vector<Corners>& triangles, Trial& trial) {
    const FramePtr frame =
        trial.frame(frontScene(4, {trianglesOf(triangles)}), setOf({BufferId::PolygonsNormal}), StageId::Normals);
    const AnyBuffer normals = *frame->buffer({BufferId::PolygonsNormal});
    return worstAngle(triangles, [&](std::size_t i) {
        return Vec3d(normals.flat(3 * i), normals.flat(3 * i + 1), normals.flat(3 * i + 2));
    });
}
Finding runSliver(Trial& trial) { return {naiveSliver(1e-6), ourSliver(slivers(1e-6), trial)}; }
double sliverAt(double height) {
    Trial trial(1);
    return ourSliver(slivers(height), trial);
}

// Every vertex of its polygon alone, against vertices that are shared.
std::shared_ptr<const Mesh> splitBox() {
    const auto box = boxMesh(-1, 1);
    std::vector<Vec3d> positions;
    Polygons polygons;
    for (std::size_t p = 0; p < box->polygonCount(); ++p) {
        polygons.emplace_back();
        for (std::uint32_t corner : box->polygon(p)) {
            polygons.back().push_back(std::uint32_t(positions.size()));
            positions.push_back(box->positions[corner]);
        }
    }
    return meshOf(std::move(positions), polygons);
}
Scene duplicates() {
    Scene scene = frontScene(6, {splitBox()});
    scene.objects[0].transform.rotation = {30, 40, 0};
    return scene;
}
Finding runDuplicates(Trial& trial) {
    Scene split = duplicates(), shared = split;
    shared.objects[0].mesh = boxMesh(-1, 1);
    const std::size_t flat = differences(trial.frame(split), trial.frame(shared), kPicture);
    // Smooth: only an index joins polygons, so that a split vertex keeps its polygon's normal.
    for (Scene* scene : {&split, &shared}) scene->settings.shading = Shading::Gouraud;
    const FramePtr smooth = trial.frame(split), round = trial.frame(shared);
    double turned = 0;
    for (std::size_t v = 0; v < 24; ++v) {
        const Vec3d polygon = vectorOf(smooth, {BufferId::PolygonsNormal}, v / 4);
        const Vec3d own = vectorOf(smooth, {BufferId::VerticesNormal}, v);
        turned = std::max(turned, double(degreesBetween(Long3(polygon), Long3(own))));
    }
    trial.demand(turned < 1e-13, "a vertex of one polygon alone has not its normal");
    const Vec3d mean = vectorOf(round, {BufferId::VerticesNormal}, 0);
    const double joined = double(degreesBetween(Long3(mean), Long3(vectorOf(round, {BufferId::PolygonsNormal}, 0))));
    return {joined, double(flat), fmt::format("normals {:.1f}° apart", joined), ""};
}

// World and camera scaled by 2^k. Beyond what a setting may be the scene is refused, with a message.
Scene scaledBy(double factor) {
    Scene scene = frontScene(6, {boxMesh(-1, 1)});
    scene.objects[0].transform.rotation = {30, 40, 0};
    scene.objects[0].material.specular = Vec3d(0.5);
    scene.objects[0].transform.scale *= factor;
    scene.camera.eye *= factor;
    scene.settings.precision = Precision::Float;
    return scene;
}
Scene scaledDown() { return scaledBy(0x1p-40); }
// How far from 1 the lengths of normalised vectors are, over 100 directions of that length.
double lengthError(UnitForm form, double length) {
    Random random(2);
    double worst = 0;
    for (int i = 0; i < 100; ++i) {
        const Vec3<float> v(length * random.direction());
        worst = std::max(worst, std::abs(double(glm::length(Long3(normalized(v, form)))) - 1));
    }
    return worst;
}
double directLength(double length) { return lengthError(UnitForm::Direct, length); }
double scaledLength(double length) { return lengthError(UnitForm::Scaled, length); }
Finding runScaled(Trial& trial) {
    const FramePtr plain = trial.frame(scaledBy(1));
    std::size_t differ = 0;
    for (int k : {-100, -72, -40, -26, -7, 3, 15, 26})
        differ += differences(plain, trial.frame(scaledBy(std::ldexp(1.0, k))),
                              {BufferId::Color, BufferId::Intensity, BufferId::PolygonId, BufferId::Normal,
                               BufferId::Barycentric, BufferId::NDotL, BufferId::RDotV});
    Scene beyond = scaledBy(1);
    beyond.objects[0].transform.scale = Vec3d(1e30);
    trial.demand(!checkScene(beyond).empty(), "a scale of 10³⁰ is not refused");
    const glm::vec3 edge(1e20f, 0, 0), other(0, 1e20f, 0), normal = glm::cross(edge, other);
    const glm::vec3 naive = normal / std::sqrt(glm::dot(normal, normal));
    return {double(naive.z), double(differ), fmt::format("N = {} at 1e20", measured(naive.z, "")), ""};
}

const Vec3d kOffset(1e7, -1e7, 1e7);
// Corners on a grid of 2^-10, which double holds at 10^7 too.
Scene movedBy(Vec3d offset) {
    Random random(18);
    std::vector<Corners> triangles;
    for (int i = 0; i < 60; ++i) {
        Corners t;
        const Vec3d middle = random.inCube(1);
        for (Vec3d& corner : t) corner = glm::round((middle + random.inCube(0.5)) * 1024.0) / 1024.0;
        triangles.push_back(t);
    }
    Scene scene = frontScene(5, {trianglesOf(triangles)});
    scene.objects[0].transform.translation = offset;
    scene.camera.eye += offset;
    scene.camera.target += offset;
    scene.camera.near = 1, scene.camera.far = 16;
    return scene;
}
Scene farAway() { return movedBy(kOffset); }
Scene awayBy(double distance) { return movedBy(Vec3d(distance, -distance, distance)); }
double movedNormals(double distance, Precision precision) {
    Scene moved = awayBy(distance), home = movedBy(Vec3d(0));
    moved.settings.precision = precision;
    Trial trial(1);
    const BufferSet wanted = setOf({BufferId::PolygonsNormal});
    const FramePtr a = trial.frame(home, wanted, StageId::Normals), b = trial.frame(moved, wanted, StageId::Normals);
    double worst = 0;
    for (std::size_t i = 0; i < 60; ++i) {
        const Vec3d there = vectorOf(b, {BufferId::PolygonsNormal}, i);
        const Vec3d here = vectorOf(a, {BufferId::PolygonsNormal}, i);
        worst = std::max(worst, there == Vec3d(0) ? 90.0 : double(degreesBetween(Long3(here), Long3(there))));
    }
    return worst;
}
double movedInFloat(double distance) { return movedNormals(distance, Precision::Float); }
double movedInDouble(double distance) { return movedNormals(distance, Precision::Double); }
Finding runMoved(Trial& trial) {
    const std::size_t differ = differences(trial.frame(movedBy(Vec3d(0))), trial.frame(farAway()),
                                           {BufferId::Color, BufferId::Intensity, BufferId::PolygonId, BufferId::Normal,
                                            BufferId::ZView, BufferId::Barycentric, BufferId::NDotL});
    const double naive = movedInFloat(1e7);
    return {naive, double(differ), fmt::format("normal {:.0f}° off", naive), ""};
}

}  // namespace

std::span<const Case> geometryCases() {
    static const Case cases[]{
        {.id = "G1",
         .group = Group::Geometry,
         .title = "Triangle with equal corners",
         .input = "(0,0,2) (0,0,2) (1,0,2) beside a box",
         .naive = "(b − a) × (c − a), divided by its length",
         .stable = "no area after snapping: dropped; the normal of no area is (0, 0, 0)",
         .measure = "numbers that differ",
         .reference = "the picture without it, bit for bit",
         .bound = 0,
         .outcome = Outcome::Empty,
         .run = runEqualCorners,
         .scene = equalCorners},
        {.id = "G2",
         .group = Group::Geometry,
         .title = "Collinear corners",
         .input = "1000 × p, p + d, p + 2d",
         .naive = "a b − c d with one product unrounded",
         .stable = "area in 64-bit integers, no contraction",
         .measure = "triangles and normals that are not 0",
         .reference = "area 0 by construction",
         .bound = 0,
         .outcome = Outcome::Empty,
         .run = runCollinear,
         .scene = collinear},
        {.id = "G3",
         .group = Group::Geometry,
         .title = "Sliver, height 10⁻⁶, length 1",
         .input = "1000 slivers stored as float",
         .naive = "(b − a) × (c − a) in float",
         .stable = "the same sum in double, relative to the first corner",
         .measure = "largest angle of a normal",
         .unit = "°",
         .reference = "long double, of the stored corners",
         .bound = 1e-6,
         .run = runSliver,
         .scene = sliverScene,
         .knob = {.label = "height of the sliver", .low = 1e-6, .high = 1, .naive = naiveSliver, .ours = sliverAt}},
        {.id = "G5",
         .group = Group::Geometry,
         .title = "Vertices written twice",
         .input = "a box of 24 vertices",
         .naive = "vertices of one place taken for one vertex",
         .stable = "only an index joins: flat shading does not change, smooth shading keeps the edge",
         .measure = "numbers that differ when flat",
         .reference = "the box of 8 vertices, bit for bit",
         .bound = 0,
         .run = runDuplicates,
         .scene = duplicates},
        {.id = "G16",
         .group = Group::Geometry,
         .title = "Scale 2⁻¹⁰⁰ to 2²⁶, and 10³⁰",
         .input = "scene and camera scaled, float",
         .naive = "|a × b| in float",
         .stable = "normalised by a power of two first; what squares cannot hold is refused",
         .measure = "numbers that differ",
         .reference = "the picture at scale 1, bit for bit",
         .bound = 0,
         .run = runScaled,
         .scene = scaledDown,
         .naiveWith = "precision=float numerics.normalize=direct",
         .knob = {.label = "length of a vector, in float",
                  .low = 1e-30,
                  .high = 1e30,
                  .naive = directLength,
                  .ours = scaledLength}},
        {.id = "G18",
         .group = Group::Geometry,
         .title = "Mesh at distance 10⁷",
         .input = "60 triangles on a grid of 2⁻¹⁰, double",
         .naive = "world positions in float",
         .stable = "world positions in double, differences before products",
         .measure = "numbers that differ",
         .reference = "the picture at the origin, bit for bit",
         .bound = 0,
         .run = runMoved,
         .scene = farAway,
         .naiveWith = "precision=float numerics.polygon_normal=from-origin",
         .knob = {.label = "distance from the origin",
                  .low = 1,
                  .high = 1e7,
                  .naive = movedInFloat,
                  .ours = movedInDouble,
                  .scene = awayBy}},
    };
    return cases;
}

}  // namespace pipeline::check
