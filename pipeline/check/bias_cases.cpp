#include <cmath>
#include <memory>
#include <numbers>

#include "pipeline/check/case.h"
#include "pipeline/check/scenes.h"
#include "pipeline/run/frame_data.h"

// The bias of the shadow test.
namespace pipeline::check {
namespace {

const BufferSet kShadows = setOf({BufferId::Shadow, BufferId::ObjectId, BufferId::Diffuse, BufferId::Color});

Vec3d atAngle(double degrees, double around = 0.5) {
    const double t = degrees * std::numbers::pi / 180;
    return {std::sin(t) * std::cos(around), std::sin(t) * std::sin(around), std::cos(t)};
}

// A plane alone, lit at an angle from its normal: nothing is in shadow.
Scene alone(double degrees) {
    Scene scene = pixelScene(64, 64, {gridMesh(2, {-10, -10, 0}, {74, 74, 0})});
    scene.lights[0].position = atAngle(degrees);
    scene.settings.leaveOut = false;  // there is nothing to shadow it: the plan would look nothing up
    scene.settings.precision = Precision::Float;
    return scene;
}
Scene tilted() { return alone(50); }
// Per cent of the pixels of object `object` that are in shadow.
double shadowed(const FramePtr& frame, double object = 0) {
    double all = 0, dark = 0;
    const AnyBuffer factor = *frame->buffer({BufferId::Shadow, 0}), id = *frame->buffer({BufferId::ObjectId});
    for (std::size_t i = 0; i < factor.count(); ++i) {
        if (id.flat(i) != object) continue;
        ++all, dark += factor.flat(i) < 1;
    }
    return all > 0 ? 100 * dark / all : 0;
}
double acne(Trial& trial, double degrees, ShadowBias bias, double value = 0) {
    Scene scene = alone(degrees);
    scene.settings.shadowBias = bias, scene.settings.shadowBiasValue = value;
    return shadowed(trial.frame(scene, kShadows));
}
double acneWith(double degrees, ShadowBias bias) { return acne(*std::make_unique<Trial>(1), degrees, bias); }
double acneWithout(double degrees) { return acneWith(degrees, ShadowBias::Constant); }
double acneOurs(double degrees) { return acneWith(degrees, ShadowBias::Automatic); }
Finding runTilted(Trial& trial) {
    double worst = 0;
    for (double degrees : {0.0, 10.0, 30.0, 50.0, 70.0, 85.0}) worst += acne(trial, degrees, ShadowBias::Automatic);
    return {acne(trial, 50, ShadowBias::Constant), worst};
}
Finding runGrazing(Trial& trial) {
    const double away = shadowed(trial.frame(alone(91), kShadows));
    trial.demand(away == 100, "a plane that faces away is lit");
    // The bias of 45 degrees, which is all that a clamp at 1 leaves.
    const double texel = 84.0 / 62;
    return {acne(trial, 89, ShadowBias::Constant, 0.5 * texel), acne(trial, 89, ShadowBias::Automatic)};
}

double gap(const FramePtr& frame) {
    double lit = 0;
    for (std::size_t x = 16; x < 32 && numberOf(frame, {BufferId::Shadow, 0}, 32 * 64 + x) == 1; ++x) ++lit;
    return lit;
}
double gapOfConstant(double bias) {
    Scene scene = wallScene();
    scene.settings.shadowBias = ShadowBias::Constant, scene.settings.shadowBiasValue = bias;
    Trial trial(1);
    return gap(trial.frame(scene, kShadows));
}
double gapOfOurs(double) {
    Trial trial(1);
    return gap(trial.frame(wallScene(), kShadows));
}
Finding runWall(Trial& trial) {
    const double naive = gapOfConstant(8);
    trial.demand(std::abs(naive - 8 * std::sqrt(0.5)) <= 1, "a constant bias leaves another gap than b sin θ");
    return {naive, gap(trial.frame(wallScene(), kShadows))};
}

}  // namespace

std::span<const Case> biasCases() {
    static const Case cases[]{
        {.id = "H1",
         .group = Group::Shadow,
         .title = "Tilted plane, nearest look-up",
         .input = "0° to 85°, buffer of 64 × 64",
         .naive = "no bias",
         .stable = "½ texel along the slope, closed form",
         .measure = "pixels in shadow",
         .unit = "%",
         .reference = "a plane alone is lit",
         .bound = 0,
         .run = runTilted,
         .scene = tilted,
         .naiveWith = "shadow.bias=constant shadow.bias_value=0",
         .knob = {.label = "angle of the light, degrees",
                  .low = 0,
                  .high = 89,
                  .logarithmic = false,
                  .naive = acneWithout,
                  .ours = acneOurs,
                  .scene = alone}},
        {.id = "H3",
         .group = Group::Shadow,
         .title = "Shadow that leaves its wall",
         .input = "45°, a pixel a unit",
         .naive = "constant bias of 8: a gap of b sin θ",
         .stable = "½ texel along the slope",
         .measure = "gap",
         .unit = "pixels",
         .reference = "none; a pixel may lie half on either side",
         .bound = 1,
         .run = runWall,
         .scene = wallScene,
         .naiveWith = "shadow.bias=constant",
         .knob = {.label = "constant bias b",
                  .setting = "shadow.bias_value",
                  .low = 0.125,
                  .high = 32,
                  .naive = gapOfConstant,
                  .ours = gapOfOurs}},
        {.id = "H4",
         .group = Group::Shadow,
         .title = "Light at 89°, and at 91°",
         .input = "a plane alone",
         .naive = "bias clamped at a slope of 1",
         .stable = "no clamp; what faces away is dark, without a look-up",
         .measure = "pixels in shadow",
         .unit = "%",
         .reference = "a plane alone is lit",
         .bound = 0,
         .run = runGrazing,
         .scene = tilted},
    };
    return cases;
}

}  // namespace pipeline::check
