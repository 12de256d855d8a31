#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "pipeline/check/case.h"
#include "pipeline/check/scenes.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/scene/mesh/shape.h"
#include "pipeline/scene/view.h"

// Shadow buffers: bias, resolution, where lights stand.
namespace pipeline::check {
namespace {

const BufferSet kShadows = setOf({BufferId::Shadow, BufferId::ObjectId, BufferId::Diffuse, BufferId::Color});

Scene inOccluder() {
    Scene scene = pixelScene(64, 64, {gridMesh(1, {-8, -8, 0}, {72, 72, 0}), boxMesh(-1, 1)});
    scene.objects[1].transform.scale = Vec3d(4);
    scene.objects[1].transform.translation = {32, 32, 8};
    scene.lights[0].kind = LightKind::Point, scene.lights[0].position = {32, 32, 8};
    return scene;
}
Finding runInOccluder(Trial& trial) {
    Scene open = inOccluder(), plane = inOccluder();
    open.lights[0].castsShadow = false;
    plane.objects.pop_back();
    plane.lights[0].position = {100, 32, 0};
    const auto litPixels = [&](const Scene& scene, double lit = 0) {
        const FramePtr frame = trial.frame(scene, kShadows);
        for (std::size_t i = 0; i < std::size_t(64) * 64; ++i)
            lit += numberOf(frame, {BufferId::ObjectId}, i) == 0 && numberOf(frame, {BufferId::Shadow, 0}, i) > 0 &&
                   vectorOf(frame, {BufferId::Diffuse, 0}, i).x > 0;
        return lit;
    };
    return {litPixels(open), litPixels(inOccluder()) + litPixels(plane)};
}

// A caster far outside what the camera sees.
Scene farCaster() {
    Scene scene =
        pixelScene(64, 64, {gridMesh(1, {-8, -8, 0}, {72, 72, 0}), gridMesh(1, {16, 16, 4096}, {48, 48, 4096})});
    scene.camera.near = 1, scene.camera.far = 32;  // which do not bound the light's
    return scene;
}
Finding runFarCaster(Trial& trial) {
    const FramePtr frame = trial.frame(farCaster(), kShadows);
    double expected = 0, missing = 0;
    for (std::size_t i = 0; i < std::size_t(64) * 64; ++i) {
        const std::size_t x = i % 64, y = i / 64;
        if (x < 18 || x > 45 || y < 18 || y > 45) continue;  // more than a texel within the shadow
        ++expected, missing += numberOf(frame, {BufferId::Shadow, 0}, i) != 0;
    }
    return {expected, missing};
}

// A point light in a closed room, seen from its middle in one of six directions. The seams of the six shadow buffers run
// across the walls.
Scene room(Vec3d direction) {
    const auto box = boxMesh(-1, 1);
    Polygons inward;
    for (std::size_t p = 0; p < 6; ++p) inward.emplace_back(box->polygon(p).rbegin(), box->polygon(p).rend());
    Scene scene = litScene({meshOf(box->positions, inward)});
    scene.camera.eye = Vec3d(0), scene.camera.target = direction, scene.camera.fovY = 90;
    scene.camera.up = std::abs(direction.z) > 0.5 ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
    scene.lights[0].kind = LightKind::Point, scene.lights[0].position = {0.375, -0.25, 0.125};
    scene.settings.leaveOut = false;
    return scene;
}
Scene inRoom() { return room({1, 0, 0}); }
// Per cent of the pixels that are in shadow, farther than two texels from where two walls meet.
double darkWall(const FramePtr& frame) {
    double all = 0, dark = 0;
    for (std::size_t i = 0; i < std::size_t(64) * 64; ++i) {
        const Vec3d p = glm::abs(vectorOf(frame, {BufferId::Position}, i));
        const double second = p.x + p.y + p.z - std::max({p.x, p.y, p.z}) - std::min({p.x, p.y, p.z});
        if (second > 1 - 2 * 2 * 1.375 / 64) continue;
        ++all, dark += numberOf(frame, {BufferId::Shadow, 0}, i) < 1;
    }
    return 100 * dark / all;
}
Finding runRoom(Trial& trial) {
    double worst = 0;
    for (const Vec3d d :
         {Vec3d(1, 0, 0), Vec3d(-1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, -1, 0), Vec3d(0, 0, 1), Vec3d(0, 0, -1)})
        worst = std::max(worst, darkWall(trial.frame(room(d))));
    Random random(9);
    double missed = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec3d v = random.direction();
        missed += !(v.x > std::abs(v.y) && v.x > std::abs(v.z));
    }
    return {missed / 10, worst, fmt::format("one buffer misses {:.0f} %", missed / 10), ""};
}

// A sphere of radius 8 at height 16 over a plane, lit at 45 degrees: an ellipse with semi-axes 8 and 8/cos 45°.
Scene ellipse() {
    Scene scene = pixelScene(64, 64, {gridMesh(1, {-8, -8, 0}, {72, 72, 0}), makeShape({ShapeKind::Sphere, 48})});
    scene.objects[1].transform.scale = Vec3d(8);
    scene.objects[1].transform.translation = {20, 32, 16};
    scene.lights[0].position = {-1, 0, 1};
    scene.settings.shadowSize = 256;
    return scene;
}
double misclassified(const FramePtr& frame) {
    const Long3 light = glm::normalize(Long3(-1, 0, 1)), middle(20, 32, 16);
    // A texel, along the plane: 93 units of what the light sees over 254 texels, over the cosine of 45 degrees.
    const Long texel = 93.0L / 254 * std::sqrt(2.0L);
    double wrong = 0;
    for (std::size_t i = 0; i < std::size_t(64) * 64; ++i) {
        if (numberOf(frame, {BufferId::ObjectId}, i) != 0) continue;
        const std::size_t row = i / 64;
        const Long3 to = middle - Long3(Long(i % 64) + 0.5L, 63.5L - Long(row), 0);
        const Long distance = glm::length(glm::cross(to, light));
        if (std::abs(distance - 8) <= texel) continue;
        wrong += (numberOf(frame, {BufferId::Shadow, 0}, i) < 1) != (distance < 8);
    }
    return wrong;
}
Finding runEllipse(Trial& trial) {
    Scene without = ellipse();
    without.settings.shadowBias = ShadowBias::Constant;
    return {misclassified(trial.frame(without, kShadows)), misclassified(trial.frame(ellipse(), kShadows))};
}

// A light 16 wide at height 48 and x = −8, an edge at x = 32 − 0 and height 16: the penumbra is 2 a d / (h − d) = 8 wide.
constexpr int kSamples = 16;
Scene penumbra(int samples) {
    Scene scene =
        pixelScene(64, 64, {gridMesh(1, {-64, -64, 0}, {128, 128, 0}), gridMesh(1, {-64, -64, 16}, {32, 128, 16})});
    Light& light = scene.lights[0];
    light.kind = LightKind::Area, light.position = {-8, 32, 48};
    light.area = {{0, 0, -1}, 16, 0, samples};
    scene.settings.shadowSize = 512, scene.settings.precision = Precision::Float;  // 16 samples, six buffers each
    scene.settings.height = 4, scene.camera.height = 4;
    return scene;
}
Scene softEdge() { return penumbra(kSamples); }
double penumbraError(Trial& trial, int samples) {
    const FramePtr frame = trial.frame(penumbra(samples), kShadows);
    double worst = 0;
    for (std::size_t x = 33; x < 64; ++x) {
        // Of the light, what lies right of the line from the point over the edge: at height 48 it is at p + 3 (32 − p).
        const double p = double(x) + 0.5, line = p + 3 * (32 - p);
        const double exact = std::clamp((0 - line) / 16, 0.0, 1.0);
        worst = std::max(worst, std::abs(numberOf(frame, {BufferId::Shadow, 0}, std::size_t(2) * 64 + x) - exact));
    }
    return worst;
}
Finding runPenumbra(Trial& trial) { return {penumbraError(trial, 1), penumbraError(trial, kSamples)}; }

Scene twoLights() {
    Scene scene = wallScene();
    scene.lights.push_back(scene.lights[0]);
    scene.lights[1].castsShadow = false, scene.lights[1].position = {1, 0, 1};
    return scene;
}
Finding runTwoLights(Trial& trial) {
    Scene forced = twoLights(), dropped = twoLights();
    forced.settings.leaveOut = false;
    dropped.lights[1].intensity = 0;
    // Asked for, a buffer would be made of either light.
    const BufferSet wanted = setOf({BufferId::Color, BufferId::Intensity});
    const FramePtr frame = trial.frame(twoLights(), wanted);
    const auto& made = dataOf<double>(*frame)->shadowBuffer;
    trial.demand(made && !made->lights[0].empty(), "the light that casts a shadow has no buffer");
    trial.demand(made && made->lights[1].empty(), "a light that casts no shadow has a buffer");
    const auto changed = [&](const FramePtr& other) {
        return double(differences(frame, other, {BufferId::Intensity}));
    };
    return {changed(trial.frame(dropped)), changed(trial.frame(forced))};
}

Finding runMovingCamera(Trial& trial) {
    const FramePtr first = trial.frame(ellipse());
    double naive = 0, ours = 0;
    Vec3d fitted(0);
    for (int step = 0; step <= 5; ++step) {
        Scene scene = ellipse();
        scene.camera.eye.x += 0.3 * step, scene.camera.target.x += 0.3 * step;
        scene.camera.height -= step;
        if (step > 0) ours += double(differences(first, trial.frame(scene), {BufferId::ShadowBuffer}));
        // A buffer fitted to what the camera sees has its texels elsewhere in every picture.
        const View view = makeView(scene);
        const Vec3d low = worldPoint(view, {0, 64}, 0), high = worldPoint(view, {64, 0}, 0);
        const Vec3d texel{(high.x - low.x) / 256, (high.y - low.y) / 256, low.x};
        naive += step > 0 && texel != fitted;
        fitted = texel;
    }
    return {naive, ours, fmt::format("{:.0f} of 5 move", naive), ""};
}

}  // namespace

std::span<const Case> shadowCases() {
    static const Case cases[]{
        {.id = "H6",
         .group = Group::Shadow,
         .title = "Light in the plane, light in the caster",
         .input = "a point light",
         .naive = "no shadow",
         .stable = "N·L ≤ 0 is dark; walls on all sides",
         .measure = "lit pixels",
         .unit = "pixels",
         .reference = "all dark",
         .bound = 0,
         .run = runInOccluder,
         .scene = inOccluder},
        {.id = "H8",
         .group = Group::Shadow,
         .title = "Caster outside the picture",
         .input = "4096 units above",
         .naive = "the light's near plane fitted to the picture",
         .stable = "fitted to everything there is",
         .measure = "missing pixels",
         .unit = "pixels",
         .reference = "the square's shadow",
         .bound = 0,
         .run = runFarCaster,
         .scene = farCaster},
        {.id = "H9",
         .group = Group::Shadow,
         .title = "Point light in a closed room",
         .input = "six views from inside",
         .naive = "one shadow buffer",
         .stable = "six, seam to seam; two texels beside a corner aside",
         .measure = "pixels in shadow",
         .unit = "%",
         .reference = "all lit",
         .bound = 0,
         .run = runRoom,
         .scene = inRoom},
        {.id = "H10",
         .group = Group::Shadow,
         .title = "Shadow of a sphere",
         .input = "45°, more than a texel from the edge",
         .naive = "no bias",
         .stable = "½ texel along the slope",
         .measure = "wrong pixels",
         .unit = "pixels",
         .reference = "the ellipse, closed form",
         .bound = 0,
         .run = runEllipse,
         .scene = ellipse,
         .naiveWith = "shadow.bias=constant shadow.bias_value=0"},
        {.id = "H12",
         .group = Group::Shadow,
         .title = "Penumbra of a line light",
         .input = "16 samples, 8 pixels wide",
         .naive = "one sample",
         .stable = "samples in the middles of equal parts",
         .measure = "largest error of S",
         .reference = "the visible share of the light",
         // 1 / (2 N); and of 8 pixels two texels, one for the caster's edge and one for the bias. At x = 64 a texel
         // of 2 / 512 of the distance is 64² / 48 times that along the plane.
         .bound = 1.0 / (2 * kSamples) + 2 * (64.0 * 64 / 48) * (2.0 / 512) / 8,
         .run = runPenumbra,
         .scene = softEdge,
         .naiveWith = "light.0.samples=1"},
        {.id = "H14",
         .group = Group::Shadow,
         .title = "Light that casts no shadow",
         .input = "beside one that does",
         .naive = "the light left out with its buffer",
         .stable = "its buffer alone is left out",
         .measure = "numbers that differ",
         .reference = "nothing left out, bit for bit",
         .bound = 0,
         .run = runTwoLights,
         .scene = twoLights},
        {.id = "H15",
         .group = Group::Shadow,
         .title = "Shadows while the camera moves",
         .input = "five steps",
         .naive = "fitted to what the camera sees",
         .stable = "fitted to everything there is",
         .measure = "texels that differ",
         .reference = "the first buffer, bit for bit",
         .bound = 0,
         .run = runMovingCamera,
         .scene = ellipse},
    };
    return cases;
}

}  // namespace pipeline::check
