#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "pipeline/check/case.h"
#include "pipeline/check/coverage.h"
#include "pipeline/stages/clip.h"

// Clipping, projection and interpolation; the order of drawing; lines.
namespace pipeline::check {
namespace {

// From the origin along −z, near plane at 1, pixels of 1/32 at distance 1: z_view = −z.
Scene eyeScene(std::vector<std::shared_ptr<const Mesh>> meshes) {
    Scene scene = litScene(std::move(meshes));
    scene.camera.eye = Vec3d(0), scene.camera.target = {0, 0, -1};
    scene.camera.fovY = 90;
    scene.camera.near = 1, scene.camera.far = 1000;
    return scene;
}
std::shared_ptr<const Mesh> triangleOf(Vec3d a, Vec3d b, Vec3d c) {
    const std::array<Corners, 1> one{Corners{a, b, c}};
    return trianglesOf(one);
}

// Coverage of a triangle in front of the near plane by rays through the pixels' centres: 1 where the ray hits, 0
// where it misses, −1 where a ray 1/128 of a pixel beside decides otherwise and snapping may too.
std::vector<int> rayCast(const Scene& scene, const Corners& corners) {
    const auto hits = [&](Long x, Long y) {
        const Long3 ray((x - 32) / 32, (32 - y) / 32, -1);
        const Long3 a(corners[0]), e1 = Long3(corners[1]) - a, e2 = Long3(corners[2]) - a;
        // T. Möller and B. Trumbore, "Fast, minimum storage ray-triangle intersection", 1997.
        const Long3 p = glm::cross(ray, e2), q = glm::cross(-a, e1);
        const Long det = glm::dot(e1, p), u = glm::dot(-a, p) / det, v = glm::dot(ray, q) / det,
                   t = glm::dot(e2, q) / det;
        return u >= 0 && v >= 0 && u + v <= 1 && t >= Long(scene.camera.near) && t <= Long(scene.camera.far);
    };
    std::vector<int> counts;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            int seen = 0;
            for (const auto& [dx, dy] : {std::pair{-1, -1}, {1, -1}, {-1, 1}, {1, 1}})
                seen += hits(x + 0.5L + dx / 128.0L, y + 0.5L + dy / 128.0L);
            counts.push_back(seen == 4 ? 1 : seen == 0 ? 0 : -1);
        }
    return counts;
}
double againstRays(const std::vector<int>& drawn, const std::vector<int>& rays) {
    double wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) wrong += rays[i] >= 0 && drawn[i] != rays[i];
    return wrong;
}
// Divided by w without looking at its sign.
std::vector<int> unclipped(const Corners& corners) {
    ScreenTriangle t;
    for (std::size_t i = 0; i < 3; ++i) {
        const double w = -corners[i].z;
        t[i] = {std::clamp(32 + 32 * corners[i].x / w, -1e6, 1e6), std::clamp(32 - 32 * corners[i].y / w, -1e6, 1e6)};
    }
    return floatCoverage({t}, {64, 64}, true);
}

const Corners kInEyePlane{Vec3d(-2, -1, -4), Vec3d(3, 0.5, 0), Vec3d(-1, 2, -5)};
Scene inEyePlane() { return eyeScene({triangleOf(kInEyePlane[0], kInEyePlane[1], kInEyePlane[2])}); }
Finding runEyePlane(Trial& trial) {
    const double naive = 32 + 32 * kInEyePlane[1].x / -kInEyePlane[1].z;
    return {std::abs(naive), againstRays(overdrawOf(trial.frame(inEyePlane())), rayCast(inEyePlane(), kInEyePlane)),
            fmt::format("x / 0 = {}", measured(naive, "")), ""};
}

const Corners kBehind{Vec3d(-2, -1, 4), Vec3d(3, -1, 2), Vec3d(0, 2, 5)};
Scene behind() { return eyeScene({triangleOf(kBehind[0], kBehind[1], kBehind[2])}); }
Finding runBehindTheEye(Trial& trial) {
    const auto naive = unclipped(kBehind);
    return {double(std::ranges::count_if(naive, [](int n) { return n > 0; })),
            double(drawnPixels(trial.frame(behind())))};
}

const Corners kThrough{Vec3d(-6, -3, -9), Vec3d(0.7, 0.4, 3), Vec3d(5, 4, -8)};
Scene through() { return eyeScene({triangleOf(kThrough[0], kThrough[1], kThrough[2])}); }
Finding runThrough(Trial& trial) {
    const auto rays = rayCast(through(), kThrough);
    return {againstRays(unclipped(kThrough), rays), againstRays(overdrawOf(trial.frame(through())), rays)};
}

// Two triangles on either side of an edge that runs through the near plane, each in its own direction.
Finding runSharedEdge(Trial&) {
    const View view = makeView(eyeScene({boxMesh(-1, 1)}));
    Random random(55);
    double naive = 0, ours = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec3d a{random.between(-2, 2), random.between(-2, 2), random.between(1.1, 9)};
        const Vec3d b{random.between(-2, 2), random.between(-2, 2), random.between(-9, 0.9)};
        const Vec3d c{random.between(-2, 2), random.between(-2, 2), random.between(1.1, 9)};
        const Vec3d d{random.between(-2, 2), random.between(-2, 2), random.between(1.1, 9)};
        const glm::vec3 p(a), q(b);
        const float forth = (1 - p.z) / (q.z - p.z), back = (1 - q.z) / (p.z - q.z);
        naive += p + forth * (q - p) != q + back * (p - q);
        // The cut of the edge a b is the one corner that both triangles have beside a.
        const auto one = clipTriangle<double>(view, {a, b, c}), other = clipTriangle<double>(view, {b, a, d});
        bool same = false;
        for (std::size_t k = 0; k < one.count; ++k)
            for (std::size_t m = 0; m < other.count; ++m)
                same = same || (one.corners[k].view == other.corners[m].view && one.corners[k].view.z == view.near);
        ours += !same;
    }
    return {naive, ours, fmt::format("{:.1f} % cracks", naive / 10), ""};
}

// A plane of rays: x = ±1 at z = 1 and 100 times that at z = 100, seen as a strip across the picture.
Scene slanted() {
    Scene scene = eyeScene({meshOf({{-1, -1, -1}, {100, -1, -100}, {100, 1, -100}, {-1, 1, -1}}, {{0, 1, 2, 3}})});
    scene.settings.width = 65, scene.settings.height = 65;
    scene.camera.near = 0.5;
    return scene;
}
Finding runSlanted(Trial& trial) {
    const FramePtr frame = trial.frame(slanted());
    // The middle of the picture is half way between the ends on the screen: t = s z0 / (s z0 + (1 − s) z1).
    const Long s = 0.5L, exact = s * 1 / (s * 1 + (1 - s) * 100);
    const double z = numberOf(frame, {BufferId::ZView}, 32 * 65 + 32);
    const double t = (z - 1) / 99;
    return {double(std::abs(s - exact)), double(std::abs(Long(t) - exact))};
}

Scene cutScene(double near) {
    Scene scene = eyeScene({triangleOf({-3, -2, -0.6}, {4, -1, -6}, {-1, 3, -9})});
    scene.camera.near = near;
    return scene;
}
Scene cut() { return cutScene(2); }
Finding runCut(Trial& trial) {
    const FramePtr whole = trial.frame(cutScene(0.5)), part = trial.frame(cut());
    double worst = 0, common = 0;
    for (std::size_t i = 0; i < 64 * 64; ++i) {
        if (numberOf(part, {BufferId::ObjectId}, i) < 0) continue;
        ++common;
        const double a = numberOf(whole, {BufferId::ZView}, i), b = numberOf(part, {BufferId::ZView}, i);
        worst = std::max(worst, std::abs(a - b) / a);
    }
    trial.demand(common > 100, "the cut leaves nothing to compare");
    // Weights that start anew at the cut: as if its corners were the triangle's own. At the cut corner on the edge
    // from z = 0.6 to 6 the weight of the first corner is (6 − 2) / (6 − 0.6), and would be 1.
    return {1 - (6 - 2) / (6 - 0.6), worst};
}

Scene shuffled(unsigned seed) {
    Random random(21);
    std::vector<Corners> triangles;
    for (int i = 0; i < 80; ++i) {
        const Vec3d middle = random.inCube(1.5);
        triangles.push_back({middle + random.inCube(1), middle + random.inCube(1), middle + random.inCube(1)});
    }
    Random order(seed);
    if (seed > 0)
        for (std::size_t i = triangles.size(); i > 1; --i)
            std::swap(triangles[i - 1], triangles[std::size_t(order.below(int(i)))]);
    return frontScene(6, {trianglesOf(triangles)});
}
Scene inOrder() { return shuffled(0); }
Finding runShuffled(Trial& trial) {
    const FramePtr plain = trial.frame(inOrder());
    std::size_t differ = 0;
    for (unsigned seed = 1; seed <= 20; ++seed)
        differ += differences(plain, trial.frame(shuffled(seed), setOf({BufferId::Color, BufferId::ZView})),
                              {BufferId::Color, BufferId::ZView});
    const auto layers = overdrawOf(plain);
    return {double(std::ranges::count_if(layers, [](int n) { return n > 1; })), double(differ)};
}

// 16 regular hexagons, each in a cell of 32 × 32 pixels.
std::shared_ptr<const Mesh> hexagons() {
    std::vector<Vec3d> positions;
    Polygons polygons;
    for (int cell = 0; cell < 16; ++cell) {
        polygons.emplace_back();
        for (int k = 0; k < 6; ++k) {
            const double angle = std::numbers::pi / 3 * k + 0.13 * cell;
            polygons.back().push_back(std::uint32_t(positions.size()));
            positions.emplace_back(cell % 4 * 32 + 16 + 12 * std::cos(angle), cell / 4 * 32 + 16 + 12 * std::sin(angle),
                                   0);
        }
    }
    return meshOf(std::move(positions), polygons);
}
Scene outlines() {
    Scene scene = pixelScene(128, 128, {hexagons()});
    scene.settings.visibility = Visibility::None;
    return scene;
}
// Drawn pixels with fewer than two drawn neighbours: the ends of a gap.
double loosePixels(const std::vector<int>& drawn) {
    double loose = 0;
    for (int y = 1; y < 127; ++y)
        for (int x = 1; x < 127; ++x) {
            if (drawn[std::size_t(y * 128 + x)] == 0) continue;
            int neighbours = -1;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) neighbours += drawn[std::size_t((y + dy) * 128 + x + dx)] > 0;
            loose += neighbours < 2;
        }
    return loose;
}
Finding runOutlines(Trial& trial) {
    const auto mesh = hexagons();
    std::vector<int> naive(128 * 128, 0);
    for (std::size_t p = 0; p < mesh->polygonCount(); ++p)
        for (std::size_t i = 0; i < 6; ++i) {
            // A pixel a column, however steep the line.
            Vec3d a = mesh->positions[mesh->polygon(p)[i]], b = mesh->positions[mesh->polygon(p)[(i + 1) % 6]];
            if (a.x > b.x) std::swap(a, b);
            for (int x = int(a.x); x <= int(b.x); ++x) {
                const double y =
                    b.x > a.x ? a.y + (b.y - a.y) * std::clamp((x + 0.5 - a.x) / (b.x - a.x), 0.0, 1.0) : a.y;
                naive[std::size_t(int(128 - y) * 128 + x)] = 1;
            }
        }
    return {loosePixels(naive), loosePixels(overdrawOf(trial.frame(outlines())))};
}

Scene facingAt(double distance) {
    Scene scene = frontScene(distance, {gridMesh(1, {-1, -1, 0}, {1, 1, 0})});
    scene.settings.precision = Precision::Float;
    scene.camera.projection = ProjectionKind::Orthographic, scene.camera.height = 1;
    scene.camera.near = scene.camera.far = 0;
    return scene;
}
Scene facing() { return facingAt(5.3); }
Finding runFacing(Trial& trial) {
    double naive = 0, ours = 0;
    for (int tenths = 10; tenths < 160; ++tenths) {
        const double distance = 0.1 * tenths, z = float(distance);
        naive += z > distance * (1 + 0x1p-30) || z < distance * (1 - 0x1p-30);
        ours += drawnPixels(trial.frame(facingAt(distance))) == 0;
    }
    return {naive, ours};
}

}  // namespace

std::span<const Case> clipCases() {
    static const Case cases[]{
        {.id = "C1",
         .group = Group::Raster,
         .title = "Vertex with w = 0",
         .input = "a corner in the plane of the eye",
         .naive = "x / w",
         .stable = "clipped at the near plane before the division",
         .measure = "pixels that differ",
         .unit = "pixels",
         .reference = "rays in long double",
         .bound = 0,
         .run = runEyePlane,
         .scene = inEyePlane},
        {.id = "C3",
         .group = Group::Raster,
         .title = "Triangle behind the eye",
         .input = "three corners behind",
         .naive = "x / w, upside down",
         .stable = "outside the near plane",
         .measure = "drawn pixels",
         .unit = "pixels",
         .reference = "nothing is in front",
         .bound = 0,
         .outcome = Outcome::Empty,
         .run = runBehindTheEye,
         .scene = behind},
        {.id = "C4",
         .group = Group::Raster,
         .title = "Triangle through the plane of the eye",
         .input = "one corner behind",
         .naive = "x / w of all corners, folded",
         .stable = "clipped at the near plane",
         .measure = "pixels that differ",
         .unit = "pixels",
         .reference = "rays in long double",
         .bound = 0,
         .run = runThrough,
         .scene = through},
        {.id = "C5",
         .group = Group::Raster,
         .title = "Shared edge over the near plane",
         .input = "1000 edges, run along both ways",
         .naive = "a + t (b − a) from either end, float",
         .stable = "from the corner inside to the one outside",
         .measure = "edges cut in two places",
         .reference = "both cuts, bit for bit",
         .bound = 0,
         .run = runSharedEdge},
        {.id = "C17",
         .group = Group::Raster,
         .title = "Interpolation from z = 1 to 100",
         .input = "the middle of the picture",
         .naive = "t = 0.5, linear in the picture",
         .stable = "1/z is linear",
         .measure = "error of t",
         .reference = "s z₀ / (s z₀ + (1 − s) z₁)",
         // 1/z and its reciprocal within 4 units each; t divides by 99.
         .bound = 1e-15,
         .run = runSlanted,
         .scene = slanted},
        {.id = "C19",
         .group = Group::Raster,
         .title = "Interpolation over a clipped triangle",
         .input = "near plane at 0.5 and at 2",
         .naive = "weights that start anew at the cut",
         .stable = "cut corners keep their weights over the whole triangle",
         .measure = "largest relative difference of z",
         .reference = "the whole triangle",
         // The cut corner is snapped too: up to 1/512 pixel moves 1/z by 1/512 of its slope, here at most 1/20 a pixel.
         .bound = 2e-4,
         .run = runCut,
         .scene = cut},
        {.id = "C20",
         .group = Group::Raster,
         .title = "Lines of any slope",
         .input = "outlines of 16 hexagons",
         .naive = "a pixel a column",
         .stable = "a pixel a step along the longer extent",
         .measure = "ends of gaps",
         .reference = "an outline is closed",
         .bound = 0,
         .run = runOutlines,
         .scene = outlines},
        {.id = "C21",
         .group = Group::Raster,
         .title = "Polygons in any order",
         .input = "80 triangles, 20 orders",
         .naive = "drawn one over the other: pixels that the order decides",
         .stable = "depth decides",
         .measure = "numbers that differ",
         .reference = "the first order, bit for bit",
         .bound = 0,
         .run = runShuffled,
         .scene = inOrder},
        {.id = "C22",
         .group = Group::Raster,
         .title = "A flat scene in parallel projection",
         .input = "a square at 150 distances, single precision",
         .naive = "near and far 2⁻³⁰ of the distance beside it",
         .stable = "near and far 2⁻²⁰ of the distance beside it",
         .measure = "pictures that are empty",
         .unit = "pictures",
         .reference = "it fills the picture",
         .bound = 0,
         .run = runFacing,
         .scene = facing},
    };
    return cases;
}

}  // namespace pipeline::check
