#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "pipeline/check/case.h"
#include "pipeline/check/scenes.h"
#include "pipeline/illumination/illumination.h"
#include "pipeline/illumination/opengl.h"
#include "pipeline/plan/scene_remarks.h"
#include "pipeline/scene/mesh/shape.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/stages/shading.h"

// Lights in strange places and of strange strength, and what becomes of intensities.
namespace pipeline::check {
namespace {

bool saysSomethingAbout(const Scene& scene, std::string_view about) {
    return std::ranges::any_of(sceneRemarks(scene), [&](const Remark& r) { return r.about == about; });
}

template <class Real>
double termsAt(Model model) {
    Illumination illumination;
    illumination.model = model;
    Light light;
    light.kind = LightKind::Point, light.position = {1, 2, 3};
    Material material;
    material.specular = Vec3d(1);
    const Surface<Real> at{Vec3<Real>(1, 2, 3), {0, 0, 1}, {0, 0, 1}};
    const LightSample<Real> s = sampleLight(illumination, light, material, at);
    double sum = 0;
    for (int c = 0; c < 3; ++c) sum += double(std::abs(s.diffuse[c]) + std::abs(s.specular[c]) + std::abs(s.L[c]));
    return sum;
}
Finding runInSurface(Trial&) {
    double ours = 0;
    for (const Model model : kModels) ours += termsAt<float>(model) + termsAt<double>(model);
    const glm::vec3 none(0);
    return {double((none / std::sqrt(glm::dot(none, none))).x), ours};
}

// A point light in a vertex of a folded sheet.
Scene inVertex() {
    Scene scene = frontScene(4, {meshOf({{-1, -1, 0}, {0, -1, -0.5}, {0, 1, -0.5}, {-1, 1, 0}, {1, -1, 0}, {1, 1, 0}},
                                        {{0, 1, 2, 3}, {1, 4, 5, 2}})});
    scene.settings.shading = Shading::Gouraud;
    scene.lights[0].kind = LightKind::Point, scene.lights[0].position = {-1, -1, 0};
    scene.objects[0].material.specular = Vec3d(0.5);
    return scene;
}
Finding runInVertex(Trial& trial) {
    const FramePtr frame = trial.frame(inVertex());
    // Ambient light alone there; the vertices across the fold are lit.
    const double ambient = 0.25 * 0.7;
    trial.demand(vectorOf(frame, {BufferId::VerticesIntensity}, 4).x > ambient, "the others are dark too");
    const glm::vec3 none(0);
    return {double(glm::normalize(none).x), std::abs(vectorOf(frame, {BufferId::VerticesIntensity}, 0).x - ambient)};
}

Scene insideBox() {
    Scene scene = frontScene(6, {boxMesh(-1, 1)});
    scene.objects[0].transform.rotation = {30, 40, 0};
    scene.lights[0].kind = LightKind::Point, scene.lights[0].position = Vec3d(0);
    scene.settings.cull = CullMode::Back;
    return scene;
}
Finding runInsideBox(Trial& trial) {
    Scene dark = insideBox();
    dark.lights[0].intensity = 0;
    const FramePtr frame = trial.frame(insideBox()), ambient = trial.frame(dark);
    double naive = 0, ours = 0;
    for (std::size_t i = 0; i < 64 * 64; ++i) {
        naive += std::abs(numberOf(frame, {BufferId::NDotL, 0}, i)) > 0;
        ours += vectorOf(frame, {BufferId::Intensity}, i) != vectorOf(ambient, {BufferId::Intensity}, i);
    }
    return {naive, ours};
}

Scene nothingReflected() {
    Scene scene = frontScene(4, {boxMesh(-1, 1)});
    scene.objects[0].material.diffuse = Vec3d(0);
    return scene;
}
std::size_t notBlack(const FramePtr& frame) {
    const AnyBuffer color = *frame->buffer({BufferId::Color});
    std::size_t count = 0;
    for (std::size_t i = 0; i < color.count(); ++i) count += color.flat(i) != 0;
    return count;
}
Finding runNoMaximum(Trial& trial) {
    trial.demand(saysSomethingAbout(nothingReflected(), "model"), "nothing is said about it");
    Scene infinite = nothingReflected();
    infinite.lights[0].intensity = std::numeric_limits<double>::infinity();
    trial.demand(!checkScene(infinite).empty(), "an infinite intensity is not refused");
    const float intensity = 0, maximum = 0;
    return {double(intensity / maximum), double(notBlack(trial.frame(nothingReflected())))};
}

Scene darkness() {
    Scene scene = frontScene(4, {boxMesh(-1, 1)});
    scene.lights.push_back(scene.lights[0]);
    scene.lights[1].intensity = -3;
    scene.settings.model = Model::BlinnPhong;
    return scene;
}
Finding runDarkness(Trial& trial) {
    const FramePtr frame = trial.frame(darkness());
    bool negative = false;
    for (std::size_t i = 0; i < 64 * 64; ++i) negative = negative || vectorOf(frame, {BufferId::Intensity}, i).x < 0;
    trial.demand(negative, "the intensity is not kept as computed");
    const double values[]{-1, -1e-9, 0, 0.5, 1, 2, HUGE_VAL, -HUGE_VAL, std::nan("")};
    const int expected[]{0, 0, 0, 128, 255, 255, 255, 0, 0};
    double naive = 0, ours = 0;
    for (std::size_t i = 0; i < std::size(values); ++i) {
        ours += frameBufferValue(Vec3d(values[i]), 1).x != expected[i];
        // What does not fit in an int has no value at all in C++.
        naive += !std::isfinite(values[i]) || std::uint8_t(int(values[i] * 255 + 0.5)) != expected[i];
    }
    return {naive, ours};
}

Scene noLight() {
    Scene scene = frontScene(4, {boxMesh(-1, 1)});
    scene.lights.clear();
    return scene;
}
Finding runNoLight(Trial& trial) {
    const FramePtr frame = trial.frame(noLight());
    double worst = 0;
    for (std::size_t i = 0; i < 64 * 64; ++i)
        if (numberOf(frame, {BufferId::ObjectId}, i) >= 0)
            worst = std::max(worst, std::abs(vectorOf(frame, {BufferId::Intensity}, i).x - 0.25 * 0.7));
    const double sum = 0, count = 0;
    return {sum / count, worst, "mean over 0 lights: NaN", ""};
}

Scene noAttenuation() {
    Scene scene = frontScene(4, {boxMesh(-1, 1)});
    scene.settings.model = Model::OpenGl;
    scene.lights[0].kind = LightKind::Point, scene.lights[0].position = {0, 0, 3};
    scene.lights[0].gl.constant = 0;
    return scene;
}
Finding runNoAttenuation(Trial& trial) {
    trial.demand(saysSomethingAbout(noAttenuation(), "light.0.constant"), "nothing is said about it");
    Scene without = noAttenuation();
    without.lights[0].intensity = 0;
    const std::size_t differ =
        differences(trial.frame(noAttenuation()), trial.frame(without), {BufferId::Intensity, BufferId::Color});
    const float d = 2;
    return {double(1 / (0 + 0 * d + 0 * d * d)), double(differ)};
}

Finding runSpots(Trial& trial) {
    double naive = 0, ours = 0;
    Light light;
    light.kind = LightKind::Point, light.gl.spotDirection = {0, 0, -1};
    const auto factor = [&](double cutoff, double exponent, Vec3d L) {
        light.gl.spotCutoff = cutoff, light.gl.spotExponent = exponent;
        return spotFactor(light, glm::normalize(L));
    };
    ours += factor(0, 0, {0, 0, 1}) != 1;       // the axis of a cone of 0 degrees
    ours += factor(0, 0, {1e-3, 0, 1}) != 0;    // beside it
    ours += factor(90, 0, {1, 0, 1e-9}) != 1;   // 0⁰ within the cone is 1
    ours += factor(90, 0, {1, 0, -1e-9}) != 0;  // and beyond it 0
    ours += factor(90, 128, {1, 0, 0}) != 0;
    ours += factor(180, 128, {0, 0, -1}) != 1;  // no spot
    naive += std::pow(std::max(0.0, -1e-9), 0.0) != 0;
    naive += std::pow(std::max(0.0, -1.0), 128.0) != 1;
    Scene refused = noAttenuation();
    refused.lights[0].gl.spotCutoff = 91;
    trial.demand(!checkScene(refused).empty(), "a cone of 91 degrees is not refused");
    return {naive, ours};
}

constexpr int kTessellation = 64;
Scene ball() {
    Scene scene = frontScene(4, {makeShape({ShapeKind::Sphere, kTessellation})});
    scene.settings.shading = Shading::Phong;
    scene.lights[0].position = {1, 2, 3};
    return scene;
}
Finding runBall(Trial& trial) {
    Scene flat = ball();
    flat.settings.shading = Shading::Flat;
    const FramePtr smooth = trial.frame(ball()), facets = trial.frame(flat);
    const Long scale = 32 / std::tan(radians(22.5L));
    const Long3 light = glm::normalize(Long3(1, 2, 3));
    double naive = 0, ours = 0;
    for (std::size_t i = 0; i < 64 * 64; ++i) {
        // The ray through the pixel's centre and the unit sphere, from (0, 0, 4).
        const Long3 ray =
            glm::normalize(Long3((Long(i % 64) + 0.5L - 32) / scale, (32 - Long(i / 64) - 0.5L) / scale, -1));
        const Long b = 4 * ray.z, c = b * b - 15;
        if (c < 0.3L) continue;  // towards the outline a small step on the screen is a large one on the sphere
        const Long3 n = Long3(0, 0, 4) + (-b - std::sqrt(c)) * ray;
        const Long exact = 0.7L * (0.25L + std::max(Long(0), glm::dot(n, light)));
        ours = std::max(ours, double(std::abs(exact - vectorOf(smooth, {BufferId::Intensity}, i).x)));
        naive = std::max(naive, double(std::abs(exact - vectorOf(facets, {BufferId::Intensity}, i).x)));
    }
    return {naive, ours};
}

}  // namespace

std::span<const Case> lightCases() {
    static const Case cases[]{
        {.id = "S1",
         .group = Group::Shading,
         .title = "Light at the surface point",
         .input = "three models, float and double",
         .naive = "(light − p), divided by its length",
         .stable = "no direction, no term",
         .measure = "terms",
         .reference = "0, by rule",
         .bound = 0,
         .run = runInSurface},
        {.id = "S2",
         .group = Group::Shading,
         .title = "Light in a vertex",
         .input = "Gouraud shading",
         .naive = "NaN in the vertex, and in its polygons",
         .stable = "that vertex has ambient light alone",
         .measure = "error of the vertex",
         .reference = "k_a I_a",
         .bound = 0,
         .run = runInVertex,
         .scene = inVertex},
        {.id = "S3",
         .group = Group::Shading,
         .title = "Light inside a closed object",
         .input = "a box, seen from outside",
         .naive = "|N·L|",
         .stable = "N·L > 0 counts",
         .measure = "pixels that differ",
         .unit = "pixels",
         .reference = "ambient light alone, bit for bit",
         .bound = 0,
         .run = runInsideBox,
         .scene = insideBox},
        {.id = "S17",
         .group = Group::Shading,
         .title = "I_max of 0, or infinite",
         .input = "black material; I_p infinite",
         .naive = "I / I_max",
         .stable = "black, with a remark; infinite is refused",
         .measure = "values that are not 0",
         .reference = "a black picture",
         .bound = 0,
         .run = runNoMaximum,
         .scene = nothingReflected},
        {.id = "S19",
         .group = Group::Shading,
         .title = "Light below 0",
         .input = "I = −1, 0, 0.5, 1, 2, ±infinite, NaN",
         .naive = "(uint8) (255 I + ½)",
         .stable = "clamped, NaN to 0; the float buffers keep what was computed",
         .measure = "wrong values",
         .reference = "0 to 255",
         .bound = 0,
         .run = runDarkness,
         .scene = darkness},
        {.id = "S20",
         .group = Group::Shading,
         .title = "No light",
         .input = "a box",
         .naive = "Σ / number of lights",
         .stable = "a sum over none",
         .measure = "largest error",
         .reference = "k_a I_a",
         .bound = 0,
         .run = runNoLight,
         .scene = noLight},
        {.id = "S22",
         .group = Group::Shading,
         .title = "Attenuation with c = l = q = 0",
         .input = "OpenGL's model",
         .naive = "1 / (c + l d + q d²)",
         .stable = "0: the light adds nothing, with a remark",
         .measure = "numbers that differ",
         .reference = "the picture without the light, bit for bit",
         .bound = 0,
         .run = runNoAttenuation,
         .scene = noAttenuation},
        {.id = "S23",
         .group = Group::Shading,
         .title = "Spots of 0, 90 and 180 degrees",
         .input = "exponents 0 and 128",
         .naive = "pow(max(0, −L·D), n) alone",
         .stable = "the cone first; 180 is no spot, 91 is refused",
         .measure = "wrong factors",
         .reference = "OpenGL's rule",
         .bound = 0,
         .run = runSpots},
        {.id = "S24",
         .group = Group::Shading,
         .title = "Sphere in directed light",
         .input = "256 facets around, Phong shading",
         .naive = "a normal a facet",
         .stable = "normals interpolated",
         .measure = "largest error",
         .reference = "ray and sphere: k (I_a + max(0, N·L))",
         // A chord over h = π/128 lies h²/8 below the sphere; seen at up to 60° that moves the point by twice as much.
         .bound = 3 * (std::numbers::pi / 128) * (std::numbers::pi / 128) / 8,
         .run = runBall,
         .scene = ball,
         .naiveWith = "shading=flat"},
    };
    return cases;
}

}  // namespace pipeline::check
