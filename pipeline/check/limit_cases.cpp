#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "pipeline/check/case.h"
#include "pipeline/check/scenes.h"
#include "pipeline/plan/memory_limit.h"
#include "pipeline/plan/scene_remarks.h"
#include "pipeline/scene/mesh/shape.h"
#include "pipeline/scene/settings_table.h"

// Order, translucency, and sizes at both ends.
namespace pipeline::check {
namespace {

constexpr std::initializer_list<BufferId> kPicture{BufferId::Color, BufferId::Intensity, BufferId::PolygonId,
                                                   BufferId::ZView};

// Three bars in a ring, each with its head over the next and its tail under the one before; no light but ambient.
const std::array<Corners, 3> kRing{Corners{Vec3d(4, 10, -6), Vec3d(60, 14, 6), Vec3d(60, 22, 6)},
                                   Corners{Vec3d(54, 4, -6), Vec3d(36, 60, 6), Vec3d(30, 56, 6)},
                                   Corners{Vec3d(40, 60, -6), Vec3d(6, 6, 6), Vec3d(14, 4, 6)}};
constexpr double kShares[]{0.2, 0.5, 0.9};
Scene ring() {
    Scene scene = pixelScene(64, 64, {});
    scene.lights.clear();
    scene.ambient.intensity = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::array<Corners, 1> one{kRing[i]};
        scene.objects.push_back(objectOf(trianglesOf(one), {Vec3d(kShares[i])}));
        scene.objects[i].material.alpha = 0.5;
    }
    return scene;
}
// The layers over a pixel's centre in the order of their planes' depths there.
double ringError(const FramePtr& frame) {
    double worst = 0;
    for (std::size_t i = 0; i < std::size_t(64) * 64; ++i) {
        const std::size_t row = i / 64;
        const Long x = Long(i % 64) + 0.5L, y = 63.5L - Long(row);
        std::vector<std::pair<Long, double>> layers;  // height, intensity
        for (std::size_t k = 0; k < 3; ++k) {
            const Long3 a(kRing[k][0]), b(kRing[k][1]), c(kRing[k][2]);
            const Long area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
            const Long v = ((x - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) / area;
            const Long w = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / area;
            if (v >= 0 && w >= 0 && v + w <= 1)
                layers.emplace_back(a.z + v * (b.z - a.z) + w * (c.z - a.z), kShares[k]);
        }
        std::ranges::sort(layers);
        double exact = 0;
        for (const auto& [height, intensity] : layers) exact = 0.5 * intensity + 0.5 * exact;
        worst = std::max(worst, std::abs(vectorOf(frame, {BufferId::Intensity}, i).x - exact));
    }
    return worst;
}
Finding runRing(Trial& trial) {
    Scene polygons = ring();
    polygons.settings.translucency = Translucency::Polygons;
    return {ringError(trial.frame(polygons)), ringError(trial.frame(ring()))};
}

Scene tied() {
    Scene scene = pixelScene(64, 64, {gridMesh(3, {4, 4, 0}, {60, 60, 0}), gridMesh(3, {4, 4, 0}, {60, 60, 0})});
    scene.objects[1].material.diffuse = {0.1, 0.9, 0.3};
    for (Object& object : scene.objects) object.material.alpha = 0.5;
    return scene;
}
Finding runTied(Trial& trial) {
    const FramePtr first = trial.frame(tied());
    std::size_t ours = 0;
    for (int i = 0; i < 20; ++i) ours += differences(first, trial.frame(tied()), kPicture);
    // The second is laid over the first.
    const double expected = 0.5 * 0.1 * 1.25 + 0.25 * 0.7 * 1.25;
    trial.demand(std::abs(vectorOf(first, {BufferId::Intensity}, 32 * 64 + 32).x - expected) < 1e-14,
                 "the tie is not decided by number");
    std::array<std::pair<double, int>, 64> keys;
    for (int i = 0; i < 64; ++i) keys[std::size_t(i)] = {0.5, i};
    std::ranges::sort(keys, {}, [](const auto& k) { return k.first; });
    double moved = 0;
    for (int i = 0; i < 64; ++i) moved += keys[std::size_t(i)].second != i;
    return {moved, double(ours), fmt::format("an unstable sort moves {:.0f} of 64", moved), ""};
}

Scene veiled(double alpha) {
    Scene scene = frontScene(6, {boxMesh(-1, 1), boxMesh(-0.5, 0.5)});
    scene.objects[1].transform.translation = {0.3, 0.2, 2};
    scene.objects[1].material.alpha = alpha;
    return scene;
}
Scene veil() { return veiled(0.25); }
Finding runVeil(Trial& trial) {
    Scene absent = veiled(1), nan = veiled(std::nan(""));
    absent.objects.pop_back();
    trial.demand(!checkScene(nan).empty(), "an opacity that is no number is not refused");
    const FramePtr none = trial.frame(absent), opaque = trial.frame(veiled(1));
    std::size_t differ = differences(none, trial.frame(veiled(0)), kPicture);
    differ += differences(opaque, trial.frame(veiled(7)), kPicture);
    differ += differences(none, trial.frame(veiled(-1)), kPicture);
    trial.frame(veil());
    // Blended at alpha 0 but written to the z-buffer: what is behind is lost.
    return {double(differences(none, opaque, {BufferId::PolygonId})), double(differ)};
}

Scene apart() {
    Scene scene = frontScene(7, {});
    for (int i = 0; i < 5; ++i) {
        scene.objects.push_back(objectOf(makeShape({ShapeKind::Sphere, 4})));
        scene.objects.back().transform.translation = {0.7 * i - 1.4, 0.3 * i - 0.6, 1.2 - 1.1 * i};
        scene.objects.back().transform.scale = Vec3d(0.5);
    }
    scene.objects.push_back(objectOf(gridMesh(1, {-3, -3, -5}, {3, 3, -5})));
    return scene;
}
Finding runPainter(Trial& trial) {
    Scene painted = apart();
    painted.settings.visibility = Visibility::Painter;
    const FramePtr zBuffer = trial.frame(apart());
    const std::size_t ours = differences(zBuffer, trial.frame(painted), {BufferId::PolygonId, BufferId::ObjectId});
    // In the order of the file.
    Scene last = apart();
    std::ranges::reverse(last.objects);
    const FramePtr frame = trial.frame(apart());
    const AnyBuffer overdraw = *frame->buffer({BufferId::Overdraw}), writes = *frame->buffer({BufferId::DepthWrites});
    double naive = 0;
    for (std::size_t i = 0; i < overdraw.count(); ++i) naive += overdraw.flat(i) != writes.flat(i);
    return {naive, double(ours)};
}

Scene nothing() { return frontScene(4, {}); }
Finding runNothing(Trial& trial) {
    trial.demand(!sceneRemarks(nothing()).empty(), "nothing is said about it");
    const FramePtr frame = trial.frame(nothing());
    const AnyBuffer color = *frame->buffer({BufferId::Color});
    double ours = double(drawnPixels(frame));
    for (std::size_t i = 0; i < color.count(); ++i) ours += color.flat(i) != 0;
    double far = -HUGE_VAL;  // the farthest of no vertices
    for (const Vec3d& p : std::vector<Vec3d>{}) far = std::max(far, p.z);
    return {std::abs(far), ours, fmt::format("max of none: {}", far), ""};
}

Scene onePixel() {
    return pixelScene(1, 1, {meshOf({{-1, -1, -2}, {2, -1, -2}, {2, 2, 1}, {-1, 2, 1}}, {{0, 1, 2, 3}})});
}
Finding runOnePixel(Trial& trial) {
    const FramePtr frame = trial.frame(onePixel());
    // The sample is the middle of the pixel: z = −2 + 1.5 at y = 0.5, seen from 16.
    const float width = 1;
    return {double(0.0f / (width - 1)), std::abs(numberOf(frame, {BufferId::ZView}, 0) - 16.5)};
}

Finding runHuge(Trial&) {
    Scene scene = nothing();
    scene.settings.width = scene.settings.height = 16384;
    double accepted = checkSceneAndMemory(scene).empty();
    scene.settings.width = 16385;
    accepted += checkSceneAndMemory(scene).empty();
    const std::uint32_t side = 16384, bytes = side * side * 4 * 4;
    return {2, accepted, fmt::format("{} bytes in 32 bits", bytes), "refused"};
}

Finding runShadowSizes(Trial& trial) {
    Scene scene = frontScene(6, {boxMesh(-1, 1)});
    scene.settings.leaveOut = false;
    scene.settings.shadowSize = 1;
    trial.frame(scene);
    double accepted = 0;
    scene.settings.shadowSize = 16384;
    accepted += checkSceneAndMemory(scene).empty();
    scene.settings.shadowSize = 8192;
    scene.lights.assign(8, scene.lights[0]);
    for (Light& light : scene.lights) light.kind = LightKind::Point;
    accepted += checkSceneAndMemory(scene).empty();
    const std::uint32_t side = 16384, bytes = side * side * 16;
    return {2, accepted, fmt::format("{} bytes in 32 bits", bytes), "refused"};
}
Finding runSizes(Trial& trial) {
    double missing = 0;
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(1, 16384), glm::ivec2(16384, 1)}) {
        Scene scene = pixelScene(size.x, size.y, {gridMesh(1, {-8, -8, 0}, {size.x + 8.0, size.y + 8.0, 0})});
        missing +=
            size.x * size.y - double(drawnPixels(trial.frame(scene, setOf({BufferId::ObjectId, BufferId::Color}))));
    }
    Scene none = pixelScene(1, 1, {boxMesh(-1, 1)});
    none.settings.height = 0;
    trial.demand(!checkScene(none).empty(), "a picture without a row is not refused");
    const float width = 1;
    return {double(0.0f / (width - 1)), missing};
}

constexpr int kCells = 300;  // 90 000 polygons, 180 000 triangles: more than 16 bits count
Scene many() { return pixelScene(64, 64, {gridMesh(kCells, {0, 0, 0}, {64, 64, 0})}); }
Finding runMany(Trial& trial) {
    const FramePtr frame = trial.frame(many(), setOf({BufferId::PolygonId, BufferId::Color}));
    double naive = 0, ours = 0;
    for (std::size_t i = 0; i < std::size_t(64) * 64; ++i) {
        const double id = numberOf(frame, {BufferId::PolygonId}, i);
        const std::size_t row = i / 64;
        const double x = (double(i % 64) + 0.5) / 64 * kCells, y = (63.5 - double(row)) / 64 * kCells;
        // A centre nearer to a cell's side than 1/256 of a pixel may fall to either side of it.
        if (std::abs(x - std::round(x)) < 0.02 || std::abs(y - std::round(y)) < 0.02) continue;
        const double exact = std::floor(y) * kCells + std::floor(x);
        ours += id != exact;
        naive += double(std::uint16_t(std::uint32_t(exact))) != exact;
    }
    return {naive, ours};
}

}  // namespace

std::span<const Case> limitCases() {
    static const Case cases[]{
        {.id = "O1",
         .group = Group::Limits,
         .title = "Three polygons over each other in a ring",
         .input = "α = 0.5",
         .naive = "sorted by mean depth",
         .stable = "sorted at every pixel",
         .measure = "largest error of I",
         .reference = "over-composite in the order of the planes",
         // Three blends of two roundings each.
         .bound = 1e-15,
         .run = runRing,
         .scene = ring,
         .naiveWith = "translucency=polygons"},
        {.id = "O3",
         .group = Group::Limits,
         .title = "Layers at the same depth",
         .input = "two squares in one plane, 20 times",
         .naive = "a sort that is not stable",
         .stable = "ties by number",
         .measure = "numbers that differ",
         .reference = "the first picture, bit for bit",
         .bound = 0,
         .run = runTied,
         .scene = tied},
        {.id = "O4",
         .group = Group::Limits,
         .title = "Opacity 0, 1, 7, −1, NaN",
         .input = "a box before a box",
         .naive = "α = 0 writes depth",
         .stable = "0 is as if not there, 1 is opaque; beyond, the nearer of the two; NaN is refused",
         .measure = "numbers that differ",
         .reference = "without it, and opaque, bit for bit",
         .bound = 0,
         .run = runVeil,
         .scene = veil},
        {.id = "O6",
         .group = Group::Limits,
         .title = "Painter against z-buffer",
         .input = "five spheres and a wall",
         .naive = "drawn in the order of the file",
         .stable = "Newell, Newell and Sancha's order",
         .measure = "ids that differ",
         .reference = "the z-buffer, bit for bit",
         .bound = 0,
         .run = runPainter,
         .scene = apart},
        {.id = "L1",
         .group = Group::Limits,
         .title = "No object",
         .input = "a light and a camera",
         .naive = "largest z of none",
         .stable = "background, with a remark",
         .measure = "pixels and numbers that are not 0",
         .reference = "background",
         .bound = 0,
         .outcome = Outcome::Empty,
         .run = runNothing,
         .scene = nothing},
        {.id = "L2",
         .group = Group::Limits,
         .title = "Picture of one pixel",
         .input = "a slanted square",
         .naive = "x / (width − 1)",
         .stable = "the sample in the pixel's middle",
         .measure = "error of z",
         .reference = "the plane",
         .bound = 0,
         .run = runOnePixel,
         .scene = onePixel},
        {.id = "L3",
         .group = Group::Limits,
         .title = "Picture of 16384 × 16384",
         .input = "and one column more",
         .naive = "sizes in 32 bits",
         .stable = "refused before anything is allocated",
         .measure = "sizes not refused",
         .reference = "4 GiB",
         .bound = 0,
         .outcome = Outcome::Error,
         .run = runHuge},
        {.id = "T15",
         .group = Group::Camera,
         .title = "Pictures of one pixel, row or column",
         .input = "1 × 1, 1 × 16384, 16384 × 1; 1 × 0",
         .naive = "x / (width − 1)",
         .stable = "samples in pixel centres; a picture without a row is refused",
         .measure = "pixels not covered",
         .unit = "pixels",
         .reference = "a square larger than the picture",
         .bound = 0,
         .run = runSizes},
        {.id = "H11",
         .group = Group::Shadow,
         .title = "Buffers of 1 and of 16384 texels",
         .input = "1 × 1; 16384 × 16384; 48 of 8192 × 8192",
         .naive = "sizes in 32 bits",
         .stable = "refused before anything is allocated",
         .measure = "sizes not refused",
         .reference = "4 GiB",
         .bound = 0,
         .outcome = Outcome::Error,
         .run = runShadowSizes},
        {.id = "L4",
         .group = Group::Limits,
         .title = "180 000 triangles",
         .input = "a grid of 300 × 300",
         .naive = "ids of 16 bits",
         .stable = "ids of 32 bits, limits at 2²⁷",
         .measure = "wrong ids",
         .unit = "pixels",
         .reference = "the cell under the centre",
         .bound = 0,
         .run = runMany,
         .scene = many},
    };
    return cases;
}

}  // namespace pipeline::check
