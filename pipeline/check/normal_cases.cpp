#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "pipeline/check/case.h"
#include "pipeline/check/scenes.h"
#include "pipeline/run/frame_data.h"

// Normals of vertices, and between them.
namespace pipeline::check {
namespace {

// One sheet with polygons on both sides that share its vertices.
Scene sheet() {
    Scene scene =
        frontScene(4, {meshOf({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2, 3}, {3, 2, 1, 0}})});
    scene.settings.shading = Shading::Phong;
    return scene;
}
Finding runSheet(Trial& trial) {
    const FramePtr frame = trial.frame(sheet());
    trial.demand(dataOf<double>(*frame)->normals->vanishing == 4, "the vertices without a mean are not counted");
    double worst = 0;
    for (std::size_t v = 0; v < 4; ++v)
        worst =
            std::max(worst, double(degreesBetween({0, 0, 1}, Long3(vectorOf(frame, {BufferId::VerticesNormal}, v)))));
    const glm::vec3 sum = glm::vec3(0, 0, 1) + glm::vec3(0, 0, -1);
    return {double((sum / std::sqrt(glm::dot(sum, sum))).z), worst};
}

constexpr std::uint32_t kBlades = 60000;
std::shared_ptr<const Mesh> fan() {
    Random random(3);
    std::vector<Vec3d> positions{{0, 0, 1}};
    Polygons polygons;
    for (std::uint32_t i = 0; i < kBlades; ++i) {
        const double angle = 2 * std::numbers::pi * i / kBlades;
        positions.emplace_back(std::cos(angle), std::sin(angle), random.between(0, 0.5));
        polygons.push_back({0, i + 1, (i + 1) % kBlades + 1});
    }
    return meshOf(std::move(positions), polygons);
}
Finding runFan(Trial& trial) {
    Scene scene = frontScene(4, {fan()});
    scene.settings.shading = Shading::Phong;
    scene.settings.normalWeight = NormalWeight::Area;
    const Mesh& mesh = *scene.objects[0].mesh;
    Long3 exact(0);
    glm::vec3 naive(0);
    for (const Triangle& t : mesh.triangles) {
        const Vec3d a = mesh.positions[t.vertices[0]], b = mesh.positions[t.vertices[1]],
                    c = mesh.positions[t.vertices[2]];
        exact += glm::cross(Long3(b) - Long3(a), Long3(c) - Long3(a));
        naive += glm::cross(glm::vec3(b) - glm::vec3(a), glm::vec3(c) - glm::vec3(a));
    }
    const FramePtr frame = trial.frame(scene, setOf({BufferId::VerticesNormal}), StageId::Normals);
    return {double(degreesBetween(exact, Long3(Vec3d(naive)))),
            double(degreesBetween(exact, Long3(vectorOf(frame, {BufferId::VerticesNormal}, 0))))};
}

// A square whose given normals turn by `degrees` from its left to its right side.
Scene turning(double degrees) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {64, 0, 0}, {64, 64, 0}, {0, 64, 0}};
    mesh.addPolygon(std::array{0u, 1u, 2u, 3u});
    const double half = degrees / 2 * std::numbers::pi / 180;
    // Exactly opposite at 180.
    const double across = degrees == 180 ? 0 : std::cos(half);
    const Vec3d left(-std::sin(half), 0, across), right(std::sin(half), 0, across);
    mesh.normals = {left, right, right, left};
    Scene scene = pixelScene(64, 64, {makeMesh(std::move(mesh))});
    scene.settings.shading = Shading::Phong;
    scene.settings.normalWeight = NormalWeight::Given;
    return scene;
}
Scene turning120() { return turning(120); }
Scene turning90() { return turning(90); }
Finding runTurning(Trial& trial) {
    double worst = 0, fromSlerp = 0;
    for (const double degrees : {120.0, 170.0}) {
        const FramePtr frame = trial.frame(turning(degrees));
        const Long half = radians(degrees / 2);
        for (std::size_t x = 0; x < 64; ++x) {
            const Long t = (Long(x) + 0.5L) / 64 * 2 - 1;  // −1 on the left, 1 on the right
            const Long3 exact(t * std::sin(half), 0, std::cos(half));
            const Long3 slerp(std::sin(t * half), 0, std::cos(t * half));
            const Vec3d ours = vectorOf(frame, {BufferId::Normal}, 32 * 64 + x);
            worst = std::max(worst, double(degreesBetween(exact, Long3(ours))));
            if (degrees == 120) fromSlerp = std::max(fromSlerp, double(degreesBetween(slerp, Long3(ours))));
        }
    }
    // Opposite normals: left of the middle the one, right of it the other, and between them none.
    trial.frame(turning(180));
    const glm::vec3 middle = 0.5f * glm::vec3(-1, 0, 0) + 0.5f * glm::vec3(1, 0, 0);
    return {double((middle / std::sqrt(glm::dot(middle, middle))).x), worst, "NaN at 180°",
            fmt::format("{} ({:.1f}° from slerp)", measured(worst, "°"), fromSlerp)};
}

Finding runLengths(Trial& trial) {
    const FramePtr frame = trial.frame(turning90());
    Long worst = 0, shortest = 1;
    for (std::size_t x = 0; x < 64; ++x) {
        worst = std::max(worst, std::abs(glm::length(Long3(vectorOf(frame, {BufferId::Normal}, x))) - 1));
        const Long t = (Long(x) + 0.5L) / 64 * 2 - 1;
        shortest = std::min(shortest, std::sqrt((t * t + 1) / 2));
    }
    return {double((1 - shortest) / 0x1p-52L), double(worst / 0x1p-52L), fmt::format("× {:.3f}", double(shortest)), ""};
}

// Given normals that face away from the viewer on a front face: nothing is turned round.
Scene rim() {
    Scene scene = turning(120);
    for (Object& object : scene.objects) {
        Mesh mesh = *object.mesh;
        for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
            const Vec3d n = mesh.normals[i];
            mesh.normals.set(i, glm::normalize(Vec3d(n.x, 0, n.z - 0.8)));
        }
        object.mesh = makeMesh(std::move(mesh));
    }
    scene.lights[0].position = {1, 0, -0.2};
    scene.lights[0].castsShadow = false;  // it stands behind the square itself
    return scene;
}
Finding runRim(Trial& trial) {
    const Scene scene = rim();
    const FramePtr frame = trial.frame(scene);
    const Long3 light = glm::normalize(Long3(scene.lights[0].position));
    double worst = 0, away = 0;
    for (std::size_t i = 0; i < 64 * 64; ++i) {
        const Long3 normal(vectorOf(frame, {BufferId::Normal}, i));
        away += normal.z < 0;  // the viewer looks along −z
        const Long exact = 0.7L * std::max(Long(0), glm::dot(normal, light));
        worst = std::max(worst, double(std::abs(exact - vectorOf(frame, {BufferId::Diffuse, 0}, i).x)));
    }
    trial.demand(away > 0, "no normal faces away");
    return {away, worst, fmt::format("{:.0f} pixels flipped", away), ""};
}

}  // namespace

std::span<const Case> normalCases() {
    static const Case cases[]{
        {.id = "N1",
         .group = Group::Shading,
         .title = "Vertex of opposed polygons",
         .input = "a sheet with two sides",
         .naive = "Σ n, divided by its length",
         .stable = "the first polygon's normal, counted",
         .measure = "largest angle",
         .unit = "°",
         .reference = "the polygon's normal",
         .bound = 0,
         .run = runSheet,
         .scene = sheet},
        {.id = "N3",
         .group = Group::Shading,
         .title = "60 000 polygons around a vertex",
         .input = "weighted by area",
         .naive = "sum in float",
         .stable = "sum in double",
         .measure = "angle",
         .unit = "°",
         .reference = "sum in long double",
         // 60 000 sums of 2^-53 each, at worst, in degrees.
         .bound = 4e-10,
         .run = runFan},
        {.id = "N4",
         .group = Group::Shading,
         .title = "Normals 120°, 170°, 180° apart",
         .input = "a square, given normals",
         .naive = "interpolated, divided by its length",
         .stable = "interpolated and normalised; none where they cancel",
         .measure = "largest angle from the formula",
         .unit = "°",
         .reference = "the formula in long double",
         .bound = 1e-10,
         .run = runTurning,
         .scene = turning120},
        {.id = "N5",
         .group = Group::Shading,
         .title = "Normal that is not renormalised",
         .input = "normals 90° apart",
         .naive = "interpolated as they are",
         .stable = "normalised at every pixel",
         .measure = "error of the length",
         .unit = "eps",
         .reference = "length 1",
         .bound = 4,
         .run = runLengths,
         .scene = turning90},
        {.id = "N7",
         .group = Group::Shading,
         .title = "Normal that faces away on a front face",
         .input = "given normals",
         .naive = "flipped towards the viewer",
         .stable = "used as given: k_d max(0, N·L)",
         .measure = "largest error",
         .reference = "the formula, of the buffer's normals",
         .bound = 4e-16,
         .run = runRim,
         .scene = rim},
    };
    return cases;
}

}  // namespace pipeline::check
