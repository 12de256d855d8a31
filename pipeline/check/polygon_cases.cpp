#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "pipeline/check/case.h"
#include "pipeline/check/coverage.h"

// Polygons that are not planar, not convex, cross themselves, or have very many corners.
namespace pipeline::check {
namespace {

constexpr double kHeight = 0.5;
Scene nonPlanar() {
    // 16 pixels a unit; the quadrilateral (0,0,0) (1,0,0) (1,1,h) (0,1,0).
    Scene scene = pixelScene(32, 32, {meshOf({{0, 0, 0}, {1, 0, 0}, {1, 1, kHeight}, {0, 1, 0}}, {{0, 1, 2, 3}})});
    scene.objects[0].transform.scale = Vec3d(16);
    scene.objects[0].transform.translation = {8.5, 8.5, 0};
    return scene;
}
Finding runNonPlanar(Trial& trial) {
    const FramePtr frame = trial.frame(nonPlanar());
    const Long3 exact(-kHeight / 2, -kHeight / 2, 1);
    // The fan from the first corner has the diagonal from (0,0,0) to (1,1,h): the centre lies at h/2.
    const double z = vectorOf(frame, {BufferId::Position}, 15 * 32 + 16).z;
    trial.demand(std::abs(z - 16 * kHeight / 2) < 1e-12,
                 "the centre does not lie on the diagonal from the first corner");
    return {double(degreesBetween(exact, {0, 0, 1})),
            double(degreesBetween(exact, Long3(vectorOf(frame, {BufferId::PolygonsNormal}, 0))))};
}

// A notch; 16 pixels a unit, so that no pixel's centre lies on an edge that is not axis-parallel.
const std::vector<Vec3d> kNotched{{0, 0, 0}, {64, 0, 0}, {64, 64, 0}, {32, 16, 0}, {0, 64, 0}};
Scene notched() { return pixelScene(80, 80, {meshOf(kNotched, {{0, 1, 2, 3, 4}})}); }
Finding runNotched(Trial& trial) {
    // Even and odd crossings of a ray to the right.
    std::vector<int> exact(std::size_t(80) * 80, 0);
    double area = 0;
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 80; ++x) {
            const double px = x + 0.5, py = 80 - (y + 0.5);
            bool inside = false;
            for (std::size_t i = 0; i < 5; ++i) {
                const Vec3d a = kNotched[i], b = kNotched[(i + 1) % 5];
                if ((a.y > py) != (b.y > py) && px < a.x + (b.x - a.x) * (py - a.y) / (b.y - a.y)) inside = !inside;
            }
            exact[std::size_t(y) * 80 + std::size_t(x)] = inside, area += inside;
        }
    // The shoelace formula gives 10 units², 2560 pixels, of which the border's rounding takes a few.
    trial.demand(std::abs(area - 2560) < 64, "the reference is wrong");
    std::vector<ScreenTriangle> fan;
    for (std::size_t i = 2; i < 5; ++i)
        fan.push_back({glm::dvec2(64, 80), glm::dvec2(kNotched[(i + 0) % 5].x, 80 - kNotched[(i + 0) % 5].y),
                       glm::dvec2(kNotched[(i + 1) % 5].x, 80 - kNotched[(i + 1) % 5].y)});
    return {differing(exactCoverage(fan, {80, 80}), exact), differing(overdrawOf(trial.frame(notched())), exact)};
}

Scene bowTie() {
    return pixelScene(32, 32, {meshOf({{4, 4, 0}, {28, 28, 0}, {28, 4, 0}, {4, 28, 0}}, {{0, 1, 2, 3}})});
}
Finding runBowTie(Trial& trial) {
    const Scene scene = bowTie();
    Scene dark = scene;
    dark.lights.clear();
    const std::array points{glm::vec3(4, 4, 0), glm::vec3(28, 28, 0), glm::vec3(28, 4, 0), glm::vec3(4, 28, 0)};
    glm::vec3 sum(0);
    for (std::size_t i = 0; i < 4; ++i) sum += glm::cross(points[i], points[(i + 1) % 4]);
    trial.demand(scene.objects[0].mesh->facts.degenerate == 1, "nothing is said about it");
    const FramePtr frame = trial.frame(scene);
    trial.demand(vectorOf(frame, {BufferId::PolygonsNormal}, 0) == Vec3d(0), "a sum of 0 has a direction");
    return {double((sum / std::sqrt(glm::dot(sum, sum))).x),
            double(differences(frame, trial.frame(dark), {BufferId::Intensity}))};
}

constexpr std::uint32_t kCorners = 1'000'000;
Finding runManyCorners(Trial& trial) {
    std::vector<Vec3d> positions(kCorners);
    Polygons polygons(1);
    for (std::uint32_t i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCorners;
        positions[i] = {std::cos(angle), std::sin(angle), 0};
        polygons[0].push_back(i);
    }
    const auto mesh = meshOf(positions, polygons);
    trial.demand(mesh->triangles.size() == kCorners - 2, "triangles are missing");
    double ours = 0;
    float naive = 0;
    for (const Triangle& t : mesh->triangles) {
        const Vec3d a = mesh->positions[t.vertices[0]], b = mesh->positions[t.vertices[1]],
                    c = mesh->positions[t.vertices[2]];
        ours += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
        naive += float((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    }
    const Long exact = kCorners / 2.0L * std::sin(2 * std::numbers::pi_v<Long> / kCorners);
    return {double(std::abs(naive - exact) / exact), double(std::abs(Long(ours) - exact) / exact)};
}

}  // namespace

std::span<const Case> polygonCases() {
    static const Case cases[]{
        {.id = "G7",
         .group = Group::Geometry,
         .title = "Quadrilateral that is not planar",
         .input = "(0,0,0) (1,0,0) (1,1,½) (0,1,0)",
         .naive = "the normal of the first three corners",
         .stable = "Newell's sum over all corners",
         .measure = "angle of the normal",
         .unit = "°",
         .reference = "(−h/2, −h/2, 1)",
         .bound = 1e-9,
         .run = runNonPlanar,
         .scene = nonPlanar,
         .naiveWith = "numerics.polygon_normal=three-corners"},
        {.id = "G8",
         .group = Group::Geometry,
         .title = "Concave polygon",
         .input = "a square with a notch",
         .naive = "a fan of triangles",
         .stable = "ears where the outline is concave",
         .measure = "pixels that differ",
         .unit = "pixels",
         .reference = "even-odd rule",
         .bound = 0,
         .run = runNotched,
         .scene = notched},
        {.id = "G9",
         .group = Group::Geometry,
         .title = "Polygon that crosses itself",
         .input = "a bow-tie",
         .naive = "the sum over all corners, divided by its length",
         .stable = "(0, 0, 0): ambient light alone, with a remark",
         .measure = "numbers that differ",
         .reference = "the picture without a light, bit for bit",
         .bound = 0,
         .run = runBowTie,
         .scene = bowTie},
        {.id = "G11",
         .group = Group::Geometry,
         .title = "Polygon of a million corners",
         .input = "regular, radius 1",
         .naive = "the sum of its triangles in float",
         .stable = "a fan in linear time, sums in double",
         .measure = "relative error of the area",
         .reference = "n/2 sin(2π/n)",
         // A million sums of 2^-53 each, at worst.
         .bound = 1.2e-10,
         .run = runManyCorners},
    };
    return cases;
}

}  // namespace pipeline::check
