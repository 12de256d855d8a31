#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/check/case.h"
#include "pipeline/check/scenes.h"
#include "pipeline/stages/depth.h"

// What a z-buffer's format can tell apart, and what happens at its ends.
namespace pipeline::check {
namespace {

DepthCode codeOf(double near, double far, DepthFormat format) {
    View view;
    view.near = near, view.far = far;
    return {view, format};
}
double depthAt(const DepthCode& code, double z) { return code.encode(z, 1 / z); }

// The nearest z beyond z, towards `end`, that is stored as another depth: by halving, to the last bit.
double edgeOfBin(const DepthCode& code, double z, double end) {
    const double stored = depthAt(code, z);
    double in = z, out = end;
    if (depthAt(code, out) == stored) return out;
    for (int i = 0; i < 200; ++i) {
        const double middle = std::sqrt(in) * std::sqrt(out);
        if (middle == in || middle == out) break;
        (depthAt(code, middle) == stored ? in : out) = middle;
    }
    return out;
}
// The depths that are stored alike at z, as a fraction of z.
double binAt(const DepthCode& code, double near, double far, double z) {
    return (edgeOfBin(code, z, far) - edgeOfBin(code, z, near)) / z;
}

// d = k / levels ± 1/2 level, solved for z: z = f n / (f − d (f − n)).
Long exactEdge(Long near, Long far, Long d) { return far * near / (far - d * (far - near)); }
Long exactBin(Long near, Long far, Long z, Long levels) {
    const Long d = std::round((far / (far - near)) * (1 - near / z) * levels) / levels;
    return (exactEdge(near, far, d + 0.5L / levels) - exactEdge(near, far, d - 0.5L / levels)) / z;
}

Finding runBins(Trial&) {
    double naive = 0, ours = 0;
    for (const auto& [format, levels] :
         {std::pair{DepthFormat::Fixed16, 65535.0L}, {DepthFormat::Fixed24, 16777215.0L}}) {
        for (double z : {1.5, 3.0, 20.0, 70.0, 95.0}) {
            const Long exact = exactBin(1, 100, Long(z), levels);
            ours = std::max(ours, std::abs(double(binAt(codeOf(1, 100, format), 1, 100, z) / exact - 1)));
            naive = std::max(naive, std::abs(double((99 / levels / Long(z)) / exact - 1)));
        }
    }
    return {naive, ours};
}

Finding runFarBin(Trial&) {
    const Long near = 0.1, far = 1000, z = 912, levels = 65535, exact = exactBin(near, far, z, levels);
    const Long first = z * (far - near) / (far * near * levels);
    const double ours = binAt(codeOf(0.1, 1000, DepthFormat::Fixed16), 0.1, 1000, 912);
    return {double(std::abs(first / exact - 1)), double(std::abs(ours / exact - 1)),
            fmt::format("dz/z {:.3f}", double(first)), fmt::format("dz/z {:.3f}", ours)};
}

Finding runFloatBin(Trial&) {
    // Between 1/2 and 1 a float's step is 2^-24: like 24 bits of integer, however many digits it has near 0.
    double naive = 0, ours = 0;
    for (double z : {1.0, 30.0, 500.0, 900.0}) {
        const Long exact = exactBin(0.1, 1000, Long(z), 0x1p24L);
        ours = std::max(ours, std::abs(double(binAt(codeOf(0.1, 1000, DepthFormat::Float), 0.1, 1000, z) / exact - 1)));
        naive = std::max(naive, std::abs(double(0x1p-24L / exact - 1)));
    }
    return {naive, ours};
}

double worstBin(double ratio, DepthFormat format) {
    const double near = 1e-3, far = near * ratio;
    const DepthCode code = codeOf(near, far, format);
    double worst = 0;
    for (int i = 1; i < 40; ++i) worst = std::max(worst, binAt(code, near, far, near * std::pow(ratio, i / 40.0)));
    return worst;
}
double standardBin(double ratio) { return worstBin(ratio, DepthFormat::Float); }
double reversedBin(double ratio) { return worstBin(ratio, DepthFormat::Reversed); }
Scene deepBy(double ratio) {
    // Far off a dark plane, and a thousandth of its distance before it a bright one, which is drawn after it.
    Scene scene =
        frontScene(0, {gridMesh(1, {-1, -1, -2}, {0, 1, -2}), gridMesh(1, {-2e8, -2e8, -5.005e8}, {2e8, 2e8, -5.005e8}),
                       gridMesh(1, {-1e8, -1e8, -5e8}, {1e8, 1e8, -5e8})});
    scene.objects[1].material.diffuse = Vec3d(0.2);
    scene.camera.target = {0, 0, -1};
    scene.camera.near = 1e9 / ratio, scene.camera.far = 1e9;
    scene.settings.depthFormat = DepthFormat::Reversed;
    return scene;
}
Scene deep() { return deepBy(1e12); }
Finding runReversed(Trial& trial) {
    trial.frame(deep());
    return {standardBin(1e12), reversedBin(1e12)};
}

// Pairs at a relative gap whose order a format does not tell, per cent.
double confused(DepthFormat format, double gap) {
    const DepthCode code = codeOf(0.1, 1e11, format);
    Random random(6);
    int wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        const double z = 0.1 * std::pow(10.0, random.between(0, 6));
        wrong += !code.nearer(depthAt(code, z), depthAt(code, z * (1 + gap)));
    }
    return wrong / 200.0;
}
Finding runRatio(Trial&) { return {confused(DepthFormat::Float, 1e-4), confused(DepthFormat::Reversed, 1e-4)}; }

// Pairs of points on one ray, at a gap of 10^-5: which of the two is nearer.
Scene pairs() {
    Random random(77);
    const Vec3d eye(3, 4, 5);
    std::vector<Corners> triangles;
    for (int i = 0; i < 2000; ++i) {
        const double z = 2 * std::pow(500.0, random.between(0, 1));
        const Vec3d ray{random.between(-0.3, 0.3), random.between(-0.3, 0.3), -1};
        triangles.push_back({eye + z * ray, eye + z * (1 + 1e-5) * ray, eye + z * ray + Vec3d(1, 0, 0)});
    }
    Scene scene = litScene({trianglesOf(triangles)});
    scene.camera.eye = eye, scene.camera.target = eye + Vec3d(0, 0, -1);
    scene.camera.near = 0.1, scene.camera.far = 1000.1;
    scene.settings.precision = Precision::Float;
    scene.settings.depthFormat = DepthFormat::Float;
    return scene;
}
Finding runComposed(Trial& trial) {
    const Scene scene = pairs();
    const FramePtr frame = trial.frame(scene, setOf({BufferId::VerticesScreen}), StageId::Transform);
    const float n = 0.1f, f = 1000.1f;
    glm::mat4 view(1), projection(0);
    view[3] = {-3, -4, -5, 1};
    projection[0][0] = projection[1][1] = 1;
    projection[2][2] = -f / (f - n), projection[2][3] = -1, projection[3][2] = -f * n / (f - n);
    const glm::mat4 composed = projection * view;
    double naive = 0, ours = 0;
    for (std::size_t i = 0; i < 6000; i += 3) {
        const auto depth = [&](std::size_t k) {
            const glm::vec4 clip = composed * glm::vec4(glm::vec3(scene.objects[0].mesh->positions[k]), 1);
            return clip.z / clip.w;
        };
        naive += depth(i) > depth(i + 1);
        ours += vectorOf(frame, {BufferId::VerticesScreen}, i).z > vectorOf(frame, {BufferId::VerticesScreen}, i + 1).z;
    }
    return {naive / 20, ours / 20};
}

// Two squares in one plane across the viewing direction, split along different diagonals.
Scene coplanar() {
    Scene scene = frontScene(4, {meshOf({{-1, -1, 0.3}, {1, -1, 0.3}, {1, 1, 0.3}, {-1, 1, 0.3}}, {{0, 1, 2, 3}}),
                                 meshOf({{-1, -1, 0.3}, {1, -1, 0.3}, {1, 1, 0.3}, {-1, 1, 0.3}}, {{1, 2, 3, 0}})});
    scene.settings.precision = Precision::Float;
    return scene;
}
Finding runCoplanar(Trial& trial) {
    double second = 0;
    for (const DepthFormat format :
         {DepthFormat::Linear, DepthFormat::Float, DepthFormat::Reversed, DepthFormat::Fixed24}) {
        Scene scene = coplanar();
        scene.settings.depthFormat = format;
        const FramePtr frame = trial.frame(scene);
        for (std::size_t i = 0; i < 64 * 64; ++i) second += numberOf(frame, {BufferId::ObjectId}, i) == 1;
    }
    Random random(8);
    double naive = 0;
    for (int i = 0; i < 4096; ++i) {
        const float z = 1 / 3.7f, b0 = float(random.between(0, 1)), b1 = float(random.between(0, 1)) * (1 - b0);
        naive += b0 * z + b1 * z + (1 - b0 - b1) * z != z;
    }
    return {naive, second};
}

Scene crossing() {
    return pixelScene(64, 64,
                      {meshOf({{0, 0, -8}, {64, 0, 8}, {64, 64, 8}, {0, 64, -8}}, {{0, 1, 2, 3}}),
                       meshOf({{0, 0, 8}, {64, 0, -8}, {64, 64, -8}, {0, 64, 8}}, {{0, 1, 2, 3}})});
}
double wrongSide(const FramePtr& frame) {
    double wrong = 0;
    for (std::size_t i = 0; i < 64 * 64; ++i)
        wrong += numberOf(frame, {BufferId::ObjectId}, i) != (i % 64 < 32 ? 1 : 0);
    return wrong;
}
Finding runCrossing(Trial& trial) {
    Scene painted = crossing();
    painted.settings.visibility = Visibility::Painter, painted.settings.split = false;
    const double naive = wrongSide(trial.frame(painted));
    painted.settings.split = true;
    return {naive, wrongSide(trial.frame(crossing())) + wrongSide(trial.frame(painted))};
}

// A square exactly in the near plane, or exactly in the far plane, larger than the picture.
Scene inPlane(double z, DepthFormat format, ProjectionKind projection) {
    Scene scene = frontScene(0, {gridMesh(1, {-32, -32, -z}, {32, 32, -z})});
    scene.camera.target = {0, 0, -1};
    scene.camera.near = 1, scene.camera.far = 8;
    scene.camera.projection = projection;
    scene.settings.depthFormat = format;
    return scene;
}
constexpr std::array kFormats{DepthFormat::Linear,  DepthFormat::Float,   DepthFormat::Reversed,
                              DepthFormat::Fixed16, DepthFormat::Fixed24, DepthFormat::Fixed32};
constexpr std::array kProjections{ProjectionKind::Perspective, ProjectionKind::Orthographic};
Scene inFarPlane() { return inPlane(8, DepthFormat::Reversed, ProjectionKind::Perspective); }
Finding runEnds(Trial& trial) {
    double wrong = 0, naive = 0;
    for (const ProjectionKind projection : kProjections)
        for (const DepthFormat format : kFormats)
            for (const double z : {1.0, 8.0}) {
                const FramePtr frame =
                    trial.frame(inPlane(z, format, projection), setOf({BufferId::Depth, BufferId::ObjectId}));
                const bool reversed = format == DepthFormat::Reversed;
                const double expected = format == DepthFormat::Linear ? z : (z == 1) == reversed ? 1 : 0;
                for (std::size_t i = 0; i < 64 * 64; ++i) wrong += numberOf(frame, {BufferId::Depth}, i) != expected;
            }
    for (const float z : {1.0f, 8.0f}) {
        const float d = 8.0f / 7.0f - 8.0f / 7.0f / z;
        naive += !(d > 0 && d < 1) ? 64 * 64 : 0;
    }
    return {naive, wrong};
}
Finding runCleared(Trial& trial) {
    double missing = 0, naive = 0;
    for (const ProjectionKind projection : kProjections)
        for (const DepthFormat format : kFormats) {
            const FramePtr frame = trial.frame(inPlane(8, format, projection));
            missing += 64 * 64 - double(drawnPixels(frame));
            // Cleared to the farthest depth that the format has, and strictly nearer.
            const double farthest = format == DepthFormat::Linear ? HUGE_VAL : format == DepthFormat::Reversed ? 0 : 1;
            const DepthCode code = codeOf(1, 8, format);
            naive += code.nearer(depthAt(code, 8), farthest) ? 0 : 64 * 64;
        }
    return {naive, missing};
}

}  // namespace

std::span<const Case> depthCases() {
    static const Case cases[]{
        {.id = "Z1",
         .group = Group::Depth,
         .title = "Bins of 16 and 24 bits",
         .input = "n = 1, f = 100, five distances",
         .naive = "(f − n) / 2ᵇ everywhere",
         .stable = "bins that grow with z²",
         .measure = "largest relative error of a bin",
         .reference = "f n / (f − d (f − n)) at d = (k ± ½) / (2ᵇ − 1)",
         // Both edges of a bin of 24 bits carry 2 units of d: 4 · 2^-53 · 2^24.
         .bound = 1e-8,
         .run = runBins},
        {.id = "Z2",
         .group = Group::Depth,
         .title = "16 bits at z = 912",
         .input = "n = 0.1, f = 1000",
         .naive = "z² (f − n) / (f n 2ᵇ), first order",
         .stable = "the bin itself: 115 units at 912",
         .measure = "relative error of the bin",
         .reference = "the same closed form",
         .bound = 1e-8,
         .run = runFarBin},
        {.id = "Z3",
         .group = Group::Depth,
         .title = "Depth as float, far away",
         .input = "n = 0.1, f = 1000",
         .naive = "a float's relative step, 2⁻²⁴",
         .stable = "its step below 1: like 24 bits",
         .measure = "largest relative error of a bin",
         .reference = "the same closed form, 2²⁴ levels",
         .bound = 1e-7,
         .run = runFloatBin},
        {.id = "Z4",
         .group = Group::Depth,
         .title = "Reversed depth, far/near 10¹²",
         .input = "39 distances",
         .naive = "float, 0 at the near plane",
         .stable = "float, 1 at the near plane",
         .measure = "largest dz/z",
         .reference = "2⁻²³, a float's step",
         .bound = 0x1p-23,
         .run = runReversed,
         .scene = deep,
         .naiveWith = "depth_format=float",
         .knob = {.label = "far / near",
                  .low = 10,
                  .high = 1e12,
                  .naive = standardBin,
                  .ours = reversedBin,
                  .scene = deepBy}},
        {.id = "Z6",
         .group = Group::Depth,
         .title = "Far/near 10¹², gap 10⁻⁴",
         .input = "20 000 pairs at z ≤ 10⁵",
         .naive = "float, 0 at the near plane",
         .stable = "float, 1 at the near plane",
         .measure = "pairs not told apart",
         .unit = "%",
         .reference = "z itself",
         .bound = 0,
         .run = runRatio},
        {.id = "Z7",
         .group = Group::Depth,
         .title = "Far/near 10⁴, gap 10⁻⁵",
         .input = "2000 pairs on a ray, float",
         .naive = "projection · view as one float matrix",
         .stable = "eye taken off first, then view, then depth",
         .measure = "pairs in the wrong order",
         .unit = "%",
         .reference = "z itself",
         .bound = 0,
         .run = runComposed,
         .scene = pairs},
        {.id = "Z8",
         .group = Group::Depth,
         .title = "Two polygons in one plane",
         .input = "split along different diagonals, four formats",
         .naive = "Σ bᵢ zᵢ in float",
         .stable = "z₀ + Σ bᵢ (zᵢ − z₀): equal depths stay equal, the first stays",
         .measure = "pixels of the second",
         .unit = "pixels",
         .reference = "the first one drawn",
         .bound = 0,
         .run = runCoplanar,
         .scene = coplanar},
        {.id = "Z10",
         .group = Group::Depth,
         .title = "Planes z = x and z = −x",
         .input = "64 × 64 pixels",
         .naive = "polygons painted by their mean depth",
         .stable = "depth per pixel; the painter splits",
         .measure = "pixels on the wrong side",
         .unit = "pixels",
         .reference = "the seam at x = 0",
         .bound = 0,
         .run = runCrossing,
         .scene = crossing,
         .naiveWith = "visibility=painter split=off"},
        {.id = "Z11",
         .group = Group::Depth,
         .title = "Exactly in the near and far planes",
         .input = "six formats, two projections",
         .naive = "0 < d < 1",
         .stable = "both planes belong to the range",
         .measure = "depths that are not 0 or 1",
         .reference = "0 and 1",
         .bound = 0,
         .run = runEnds,
         .scene = inFarPlane},
        {.id = "Z13",
         .group = Group::Depth,
         .title = "As far as the cleared depth",
         .input = "a square in the far plane, six formats",
         .naive = "strictly nearer than the cleared value",
         .stable = "what is there is nearer than nothing",
         .measure = "missing pixels",
         .unit = "pixels",
         .reference = "a square larger than the picture",
         .bound = 0,
         .run = runCleared,
         .scene = inFarPlane},
    };
    return cases;
}

}  // namespace pipeline::check
