#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/check/case.h"
#include "pipeline/check/coverage.h"
#include "pipeline/scene/mesh/topology.h"
#include "pipeline/stages/rasterize.h"

// Which pixels a triangle covers: every pixel of a surface once, whatever stands on its centres and edges.
namespace pipeline::check {
namespace {

// Float has it hard in the last 64 columns and rows of a picture 16384 wide.
constexpr double kFarPixel = 16320;
const BufferSet kCoverage = setOf({BufferId::Overdraw, BufferId::Color});

double onGrid(double v) { return std::round(v * 256) / 256; }
Vec3d onGrid(Vec3d v) { return {onGrid(v.x), onGrid(v.y), onGrid(v.z)}; }

// Our coverage against the exact one of the same mesh in a picture with a pixel a unit.
double againstExact(Trial& trial, const Scene& scene) {
    const glm::ivec2 size(scene.settings.width, scene.settings.height);
    return differing(overdrawOf(trial.frame(scene, kCoverage)),
                     exactCoverage(onScreen(*scene.objects[0].mesh, size.y), size));
}

std::shared_ptr<const Mesh> thinMesh() {
    Random random(4);
    std::vector<Corners> triangles;
    for (int i = 0; i < 400; ++i) {
        const Vec3d p{random.between(0, 64), random.between(0, 64), 0};
        const double angle = random.between(0, 6.2), length = random.between(5, 40), height = random.between(0.01, 0.5);
        const Vec3d along(std::cos(angle), std::sin(angle), 0), across(-along.y, along.x, 0);
        triangles.push_back(
            {onGrid(p), onGrid(p + length * along), onGrid(p + 0.5 * length * along + height * across)});
    }
    return trianglesOf(triangles);
}
Scene thin() { return pixelScene(64, 64, {thinMesh()}); }
Finding runThin(Trial& trial) {
    const auto triangles = onScreen(*thinMesh(), 64);
    const auto exact = exactCoverage(triangles, {64, 64});
    trial.demand(std::ranges::any_of(exact, [](int n) { return n > 0; }), "no sliver covers a centre");
    return {differing(exactCoverage(triangles, {64, 64}, 2), exact), againstExact(trial, thin())};
}

// Corners up to 10^6 pixels off the picture, in 28.4 fixed point and 32 bits against 16.16 and 64.
std::shared_ptr<const Mesh> farMesh() {
    Random random(7);
    std::vector<Corners> triangles;
    for (int i = 0; i < 50; ++i) {
        Corners t;
        for (Vec3d& corner : t) corner = onGrid(Vec3d{random.between(-1e6, 1e6), random.between(-1e6, 1e6), 0});
        triangles.push_back(t);
    }
    return trianglesOf(triangles);
}
Scene farCorners() { return pixelScene(64, 64, {farMesh()}); }
Finding runFarCorners(Trial& trial) {
    const auto triangles = onScreen(*farMesh(), 64);
    const auto exact = exactCoverage(triangles, {64, 64});
    std::vector<int> narrow(exact.size(), 0);
    for (const ScreenTriangle& t : triangles) {
        std::uint32_t x[3], y[3];  // unsigned: wraps as the hardware does, without undefined behaviour
        for (std::size_t i = 0; i < 3; ++i)
            x[i] = std::uint32_t(std::llround(t[i].x * 16)), y[i] = std::uint32_t(std::llround(t[i].y * 16));
        const auto cross = [&](int a, int b, std::uint32_t px, std::uint32_t py) {
            return std::int32_t((x[b] - x[a]) * (py - y[a]) - (y[b] - y[a]) * (px - x[a]));
        };
        const bool turned = cross(0, 1, x[2], y[2]) < 0;
        for (std::uint32_t p = 0; p < 64 * 64; ++p) {
            bool inside = true;
            for (int i = 0; i < 3; ++i) {
                const std::int32_t side = cross(i, (i + 1) % 3, p % 64 * 16 + 8, p / 64 * 16 + 8);
                inside = inside && (turned ? side <= 0 : side >= 0);
            }
            narrow[p] += inside;
        }
    }
    return {differing(narrow, exact), againstExact(trial, farCorners())};
}

Finding runBits(Trial&) {
    __extension__ using Int128 = __int128;
    Random random(9);
    const std::int64_t edge = std::int64_t(kGuardBand) * kSubPixels;
    double naive = 0, ours = 0;
    const auto corner = [&] { return random.below(2) ? edge : -edge; };
    const auto anywhere = [&] { return std::int64_t(random.between(-1, 1) * double(edge)); };
    for (int i = 0; i < 4000; ++i) {
        const bool extreme = i < 64;
        const glm::i64vec2 a{extreme ? corner() : anywhere(), extreme ? corner() : anywhere()};
        const glm::i64vec2 b{extreme ? corner() : anywhere(), extreme ? corner() : anywhere()};
        const glm::i64vec2 c{extreme ? corner() : anywhere(), extreme ? corner() : anywhere()};
        const Int128 exact = Int128(b.x - a.x) * (c.y - a.y) - Int128(b.y - a.y) * (c.x - a.x);
        ours += Int128(EdgeFunction(a, b).at(c)) != exact;
        naive += std::int32_t(std::uint64_t(exact)) != exact;
    }
    return {naive, ours};
}

// All vertices on pixel centres, quadrilaterals of 4 by 4 pixels.
std::shared_ptr<const Mesh> centreMesh() { return gridMesh(14, {4.5, 4.5, 0}, {60.5, 60.5, 0}); }
Scene onCentres() { return pixelScene(64, 64, {centreMesh()}); }
Finding runCentres(Trial& trial) {
    const auto triangles = onScreen(*centreMesh(), 64);
    const auto exact = exactCoverage(triangles, {64, 64});
    // 56 × 56 centres lie within the square, of its border two sides.
    trial.demand(std::ranges::count(exact, 1) == 56 * 56 && std::ranges::max(exact) == 1, "the reference is wrong");
    const double twice =
        double(std::ranges::count_if(floatCoverage(triangles, {64, 64}, true), [](int n) { return n > 1; }));
    const auto open = floatCoverage(triangles, {64, 64}, false);
    const double holes = double(56 * 56 - std::ranges::count_if(open, [](int n) { return n > 0; }));
    return {twice, againstExact(trial, onCentres()), fmt::format("{:.0f} twice, or {:.0f} never", twice, holes), ""};
}

std::shared_ptr<const Mesh> jitteredMesh(int cells, Vec3d offset) {
    Random random(12);
    const auto grid = gridMesh(cells, {-4, -4, 0}, {68, 68, 0});
    std::vector<Vec3d> positions = grid->positions.copy();
    // A right triangle with legs of length 1 whose corners move by up to j along each axis has twice an area of at least
    // (1 - 2 j)² - (2 j)² = 1 - 4 j: below a quarter of a cell none is turned over.
    const double most = 0.24 * 72.0 / cells;
    for (int y = 1; y < cells; ++y)
        for (int x = 1; x < cells; ++x)
            positions[std::size_t(y * (cells + 1) + x)] +=
                Vec3d{random.between(-most, most), random.between(-most, most), 0};
    for (Vec3d& p : positions) p += offset;
    Polygons triangles;
    for (const Triangle& t : grid->triangles) triangles.push_back({t.vertices[0], t.vertices[1], t.vertices[2]});
    return meshOf(std::move(positions), triangles);
}
Scene jittered() { return pixelScene(64, 64, {jitteredMesh(40, Vec3d(0))}); }
Finding runJittered(Trial& trial) {
    const auto naive = floatCoverage(onScreen(*jitteredMesh(40, Vec3d(0)), 64), {64, 64}, true, kFarPixel);
    return {differing(naive, 1), differing(overdrawOf(trial.frame(jittered(), kCoverage)), 1)};
}

Scene tiny() { return pixelScene(64, 64, {jitteredMesh(220, Vec3d(0))}); }
Finding runTiny(Trial& trial) {
    // A box rounded to whole pixels before centres are looked for loses what is smaller than a pixel.
    const auto triangles = onScreen(*tiny().objects[0].mesh, 64);
    std::vector<int> boxes(64 * 64, 0);
    for (const ScreenTriangle& t : triangles) {
        const glm::dvec2 low = glm::ceil(glm::min(t[0], glm::min(t[1], t[2])));
        const glm::dvec2 high = glm::floor(glm::max(t[0], glm::max(t[1], t[2])));
        for (int y = int(std::max(0.0, low.y)); y < std::min(64.0, high.y); ++y)
            for (int x = int(std::max(0.0, low.x)); x < std::min(64.0, high.x); ++x) boxes[std::size_t(y * 64 + x)]++;
    }
    return {differing(boxes, 1), differing(overdrawOf(trial.frame(tiny(), kCoverage)), 1)};
}

// Closed and star-shaped: octahedra with corners at random distances.
Scene closed() {
    Random random(11);
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (int i = 0; i < 24; ++i) {
        const Vec3d middle = random.inCube(1.6);
        std::vector<Vec3d> positions;
        for (const Vec3d axis :
             {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(-1, 0, 0), Vec3d(0, -1, 0), Vec3d(0, 0, 1), Vec3d(0, 0, -1)})
            positions.push_back(middle + random.between(0.2, 1) * axis);
        meshes.push_back(
            meshOf(std::move(positions),
                   {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}));
    }
    return frontScene(6, std::move(meshes));
}
Finding runClosed(Trial& trial) {
    Scene scene = closed();
    const auto both = overdrawOf(trial.frame(scene, kCoverage));
    scene.settings.cull = CullMode::Back;
    const auto front = overdrawOf(trial.frame(scene, kCoverage));
    double wrong = 0;
    for (std::size_t i = 0; i < both.size(); ++i) wrong += both[i] != 2 * front[i];
    // Float, from the same projected corners.
    scene.settings.cull = CullMode::None;
    const FramePtr frame = trial.frame(scene);
    std::vector<ScreenTriangle> fronts, backs;
    for (const Triangle& t : frame->topology().triangles) {
        ScreenTriangle s;
        for (std::size_t i = 0; i < 3; ++i)
            s[i] = glm::dvec2(vectorOf(frame, {BufferId::VerticesScreen}, t.vertices[i]));
        const double area = (s[1].x - s[0].x) * (s[2].y - s[0].y) - (s[1].y - s[0].y) * (s[2].x - s[0].x);
        (area < 0 ? fronts : backs).push_back(s);
    }
    return {
        differing(floatCoverage(fronts, {64, 64}, true, kFarPixel), floatCoverage(backs, {64, 64}, true, kFarPixel)),
        wrong};
}

// 256 edges with a vertex in their middle on one side only, each in a cell of 16 × 16 pixels.
std::shared_ptr<const Mesh> tJunctions() {
    Random random(14);
    std::vector<Vec3d> positions;
    Polygons polygons;
    for (int cell = 0; cell < 256; ++cell) {
        const Vec3d low(cell % 16 * 16, cell / 16 * 16, 0), high = low + Vec3d(16, 16, 0);
        const Vec3d a(low.x + random.between(3, 13), low.y, 0), b(low.x + random.between(3, 13), high.y, 0);
        const auto first = std::uint32_t(positions.size());
        for (const Vec3d p : {low, a, b, Vec3d(low.x, high.y, 0), a + random.between(0.3, 0.7) * (b - a),
                              Vec3d(high.x, low.y, 0), high})
            positions.push_back(p);
        polygons.push_back({first, first + 1, first + 2, first + 3});
        polygons.push_back({first + 1, first + 5, first + 4});
        polygons.push_back({first + 5, first + 6, first + 4});
        polygons.push_back({first + 6, first + 2, first + 4});
    }
    return meshOf(std::move(positions), polygons);
}
Scene tJunctionScene() { return pixelScene(256, 256, {tJunctions()}); }
double edgesWithHoles(const std::vector<int>& counts) {
    std::array<bool, 256> hole{};
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (counts[i] == 0) hole[i / 256 / 16 * 16 + i % 256 / 16] = true;
    return double(std::ranges::count(hole, true));
}
Finding runTJunction(Trial& trial) {
    const double coarse = edgesWithHoles(exactCoverage(onScreen(*tJunctions(), 256), {256, 256}, 16));
    const double fine = edgesWithHoles(overdrawOf(trial.frame(tJunctionScene(), kCoverage)));
    // A box one side of which has a vertex on an edge that the neighbour does not have.
    const auto box = boxMesh(-1, 1);
    VertexVectors positions = box->positions;
    positions.push_back({0, -1, -1});
    Polygons polygons;
    for (std::size_t p = 0; p < 6; ++p) polygons.emplace_back(box->polygon(p).begin(), box->polygon(p).end());
    polygons[0] = {0, 2, 3, 1, 8};
    trial.demand(box->facts.closed, "the box itself is not closed");
    return {coarse, double(meshOf(positions, polygons)->facts.closed),
            fmt::format("{:.0f} of 256 edges open, 4 bits", coarse), fmt::format("not closed; {:.0f} open", fine)};
}

Scene border() { return pixelScene(64, 48, {gridMesh(1, {0, 0, 0}, {64, 48, 0})}); }
Finding runBorder(Trial& trial) {
    double wrong = differing(overdrawOf(trial.frame(border(), kCoverage)), 1);
    Scene scene = border();
    scene.objects[0].mesh = gridMesh(1, {-0.5, -0.5, 0}, {64.5, 48.5, 0});
    wrong += differing(overdrawOf(trial.frame(scene, kCoverage)), 1);
    // From centre to centre: the left and the upper border belong to the square.
    scene.objects[0].mesh = gridMesh(1, {0.5, 0.5, 0}, {63.5, 47.5, 0});
    const auto counts = overdrawOf(trial.frame(scene, kCoverage));
    const auto triangles = onScreen(*scene.objects[0].mesh, 48);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) wrong += counts[std::size_t(y * 64 + x)] != (x < 63 && y < 47);
    const auto naive = floatCoverage(triangles, {64, 48}, true);
    return {double(std::ranges::count_if(naive, [](int n) { return n > 0; }) - 63 * 47), wrong};
}

}  // namespace

std::span<const Case> coverageCases() {
    static const Case cases[]{
        {.id = "C10",
         .group = Group::Raster,
         .title = "Vertices on pixel centres",
         .input = "196 squares of 4 × 4 pixels",
         .naive = "A x + B y + C ≥ 0",
         .stable = "top-left rule in integers",
         .measure = "pixels that differ",
         .unit = "pixels",
         .reference = "128-bit integers",
         .bound = 0,
         .run = runCentres,
         .scene = onCentres},
        {.id = "C12",
         .group = Group::Raster,
         .title = "Random triangulation",
         .input = "3200 triangles over 64 × 64 pixels",
         .naive = "A x + B y + C ≥ 0 in float, 16 320 pixels off",
         .stable = "corners in steps of 2⁻⁸ pixel, 64 bits",
         .measure = "pixels not covered once",
         .unit = "pixels",
         .reference = "a planar surface covers each pixel once",
         .bound = 0,
         .run = runJittered,
         .scene = jittered},
        {.id = "G4",
         .group = Group::Raster,
         .title = "Slivers thinner than a pixel",
         .input = "400, height 0.01 to 0.5 pixels",
         .naive = "corners rounded to half pixels",
         .stable = "edge functions in integers",
         .measure = "pixels that differ",
         .unit = "pixels",
         .reference = "128-bit integers",
         .bound = 0,
         .run = runThin,
         .scene = thin},
        {.id = "C7",
         .group = Group::Raster,
         .title = "Corners 10⁶ pixels off the picture",
         .input = "50 triangles",
         .naive = "28.4 fixed point in 32 bits",
         .stable = "steps of 2⁻¹⁶ pixel in 64 bits, a guard band at 2¹³ pixels",
         .measure = "pixels that differ",
         .unit = "pixels",
         .reference = "128-bit integers",
         .bound = 0,
         .run = runFarCorners,
         .scene = farCorners},
        {.id = "C9",
         .group = Group::Raster,
         .title = "Bits of an edge function",
         .input = "4000 triples in the guard band",
         .naive = "32 bits",
         .stable = "64 bits, 2 · 30 + 1 of them used",
         .measure = "values that differ",
         .reference = "128-bit integers",
         .bound = 0,
         .run = runBits},
        {.id = "C11",
         .group = Group::Raster,
         .title = "Closed meshes: as many fronts as backs",
         .input = "24 octahedra, perspective",
         .naive = "A x + B y + C ≥ 0 in float, 16 320 pixels off",
         .stable = "edge functions in integers",
         .measure = "pixels that differ",
         .unit = "pixels",
         .reference = "a ray that enters leaves",
         .bound = 0,
         .run = runClosed,
         .scene = closed},
        {.id = "C13",
         .group = Group::Raster,
         .title = "Polygons smaller than a pixel",
         .input = "96 800 triangles over 64 × 64 pixels",
         .naive = "boxes rounded to pixels",
         .stable = "boxes rounded to centres",
         .measure = "pixels not covered once",
         .unit = "pixels",
         .reference = "a planar surface covers each pixel once",
         .bound = 0,
         .run = runTiny,
         .scene = tiny},
        {.id = "C14",
         .group = Group::Raster,
         .title = "T-junctions",
         .input = "256 edges with a vertex on one side",
         .naive = "4 sub-pixel bits",
         .stable = "8 bits leave fewer holes; the mesh counts as not closed",
         .measure = "meshes taken for closed",
         .reference = "edges used once in each direction",
         .bound = 0,
         .run = runTJunction,
         .scene = tJunctionScene,
         .naiveWith = "numerics.subpixel_bits=4"},
        {.id = "C15",
         .group = Group::Raster,
         .title = "Polygons on the picture's border",
         .input = "on it, half a pixel beyond, half a pixel within",
         .naive = "centres on any edge count",
         .stable = "top-left rule; [0, W) × [0, H)",
         .measure = "pixels that differ",
         .unit = "pixels",
         .reference = "closed form",
         .bound = 0,
         .run = runBorder,
         .scene = border},
    };
    return cases;
}

}  // namespace pipeline::check
