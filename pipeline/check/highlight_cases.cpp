#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "pipeline/check/case.h"
#include "pipeline/check/scenes.h"
#include "pipeline/illumination/illumination.h"
#include "pipeline/scene/mesh/shape.h"

// The specular term: powers, from exponent 0 to 10^6.
namespace pipeline::check {
namespace {

Scene shiny() {
    Scene scene = frontScene(4, {makeShape({ShapeKind::Sphere, 32})});
    scene.settings.shading = Shading::Phong;
    scene.settings.model = Model::BlinnPhong;
    scene.settings.precision = Precision::Float;
    scene.objects[0].material = {Vec3d(0.3), Vec3d(0.7), 1e6};
    scene.lights[0].position = {1, 1, 2};
    return scene;
}

// Calls visit(N, H, exact) for float unit vectors up to three half widths of the highlight apart; exact is the power
// of the cosine of the angle between what is stored.
template <class Visit>
void overHighlight(double exponent, int angles, Visit visit) {
    Random random(10);
    const double widest = 3 * std::acos(std::min(1.0, std::exp2(-1 / std::max(exponent, 1.0))));
    for (int i = 0; i < angles; ++i) {
        const Vec3d n = random.direction(), across = glm::normalize(glm::cross(n, random.direction()));
        const double angle = std::min(widest, 1.5) * i / angles;
        const glm::vec3 N(glm::normalize(n)), H(std::cos(angle) * glm::normalize(n) + std::sin(angle) * across);
        const Long stored = radians(degreesBetween(Long3(N), Long3(H)));
        const Long half = std::sin(stored / 2);
        visit(N, H, std::exp(Long(exponent) * std::log1p(-2 * half * half)));
    }
}
double naivePower(double exponent) {
    double worst = 0;
    overHighlight(exponent, 4000, [&](glm::vec3 n, glm::vec3 h, Long exact) {
        const float power = std::pow(std::max(0.0f, glm::dot(n, h)), float(exponent));
        worst = std::max(worst, double(std::abs(power - exact)));
    });
    return worst;
}
double ourPower(double exponent) {
    double worst = 0;
    overHighlight(exponent, 4000, [&](glm::vec3 n, glm::vec3 h, Long exact) {
        worst = std::max(worst, double(std::abs(powerOfCosine(n, h, float(exponent)) - exact)));
    });
    return worst;
}
Finding runPower(Trial& trial) {
    double naive = 0, ours = 0;
    for (double exponent : {128.0, 1e4, 1e6})
        naive = std::max(naive, naivePower(exponent)), ours = std::max(ours, ourPower(exponent));
    trial.frame(shiny());
    return {naive, ours, fmt::format("error {:.2g}", naive), ""};
}

Finding runHalfValue(Trial&) {
    double naive = 0, ours = 0;
    for (double exponent : {1.0, 32.0, 128.0, 1e4, 1e6}) {
        const Long theta = std::acos(std::exp2(-1 / Long(exponent)));
        const Vec3d n(0, 0, 1), h(double(std::sin(theta)), 0, double(std::cos(theta)));
        ours = std::max(ours, std::abs(powerOfCosine(n, h, exponent) - 0.5));
        naive =
            std::max(naive, std::abs(double(std::pow(glm::dot(glm::vec3(n), glm::vec3(h)), float(exponent))) - 0.5));
    }
    return {naive, ours};
}

Finding runLinear(Trial&) {
    double naive = 0, ours = 0;
    overHighlight(1, 4000, [&](glm::vec3 n, glm::vec3 h, Long exact) {
        ours = std::max(ours, double(std::abs(powerOfCosine(n, h, 1.0f) - exact)) / 0x1p-24);
        naive = std::max(naive, double(std::abs(std::exp(glm::dot(n, h) - 1) - exact)) / 0x1p-24);
    });
    return {naive, ours};
}

template <class Real>
LightSample<Real> sampled(Model model, Vec3d normal, Vec3d light, Vec3d view, double exponent) {
    Illumination illumination;
    illumination.model = model;
    Light at;
    at.position = light;
    Material material;
    material.specular = Vec3d(0.5), material.exponent = exponent;
    return sampleLight(illumination, at, material,
                       Surface<Real>{Vec3<Real>(0), Vec3<Real>(normal), normalized(Vec3<Real>(view))});
}

Finding runBehindTheSurface(Trial&) {
    Random random(5);
    double naive = 0, ours = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3d n = random.direction(), l = random.direction(), v = random.direction();
        if (glm::dot(n, l) > 0) continue;
        const Vec3d r = 2 * glm::dot(n, l) * n - l;
        naive = std::max(naive, 0.5 * std::pow(std::max(0.0, glm::dot(r, v)), 8));
        for (const Model model : kModels) {
            const auto s = sampled<double>(model, n, l, v, 8);
            for (int c = 0; c < 3; ++c) ours = std::max({ours, std::abs(s.specular[c]), std::abs(s.diffuse[c])});
        }
    }
    return {naive, ours};
}

Finding runNegative(Trial&) {
    // R·V = −10^-8 at an exponent of 32.5.
    const Vec3d n(0, 0, 1), l = glm::normalize(Vec3d(1, 0, 1));
    const Vec3d r(-l.x, 0, l.z), v = glm::normalize(Vec3d(r.z, 0, -r.x) - 1e-8 * r);
    const auto s = sampled<double>(Model::Phong, n, l, v, 32.5);
    return {std::pow(double(s.rDotV), 32.5), double(std::abs(s.specularPower)) + std::abs(s.specular.x)};
}

Finding runZero(Trial&) {
    const Vec3d n(0, 0, 1), lit = glm::normalize(Vec3d(1, 0, 1)), behind(1, 0, -1), v(0, 0, 1);
    double ours = 0;
    for (const Model model : kModels) {
        if (modelFacts(model).lobe == Lobe::None) continue;  // its highlight is no power
        ours = std::max(ours, std::abs(sampled<double>(model, n, lit, v, 0).specular.x - 0.5));
        ours = std::max(ours, std::abs(sampled<double>(model, n, behind, v, 0).specular.x));
    }
    // R·V <= 0 with the light in front: Phong's term does not count.
    ours = std::max(ours, std::abs(sampled<double>(Model::Phong, n, lit, {1, 0, 0.1}, 0).specular.x));
    return {0.5 * std::pow(std::max(0.0, -1.0), 0), ours, "lit by k_s", ""};
}

// Light and eye at (0, 0, 1) over a plane; a pixel is 1/256 wide, the highlight's radius 0.3 of that.
Scene narrow() {
    Scene scene = litScene({gridMesh(1, {-1, -1, 0}, {1, 1, 0})});
    scene.camera.eye = {0, 0, 1};
    scene.camera.fovY = 2 * std::atan(0.125) * 180 / std::numbers::pi;
    scene.settings.shading = Shading::Phong;
    scene.settings.model = Model::BlinnPhong;
    scene.lights[0].kind = LightKind::Point, scene.lights[0].position = {0, 0, 1};
    scene.objects[0].material = {Vec3d(0), Vec3d(1), 1e6};
    scene.objects[0].material.ambient = Vec3d(0);
    return scene;
}
// The same a hundred times as near: at exponent 10^6 the highlight's radius is 30 pixels.
Scene close() {
    Scene scene = narrow();
    scene.camera.fovY /= 100;
    scene.settings.precision = Precision::Float;
    return scene;
}
// At a pixel's centre N·H is that of a right triangle: tan θ is the distance from the middle.
Long exactAt(std::size_t pixel, Long exponent) {
    const Long x = (Long(pixel % 64) + 0.5L - 32) / 256, y = (Long(pixel / 64) + 0.5L - 32) / 256;
    return std::exp(-exponent / 2 * std::log1p(x * x + y * y));
}
Finding runNarrow(Trial& trial) {
    const FramePtr frame = trial.frame(narrow());
    double ours = 0, naive = 0;
    for (std::size_t i = 0; i < 64 * 64; ++i) {
        ours = std::max(ours, double(std::abs(vectorOf(frame, {BufferId::Specular, 0}, i).x - exactAt(i, 1e6))));
        const glm::vec3 h = glm::normalize(glm::vec3(0, 0, 1) - glm::vec3(vectorOf(frame, {BufferId::Position}, i)));
        naive = std::max(naive, double(std::abs(std::pow(h.z, 1e6f) - exactAt(i, 1e6))));
    }
    return {naive, ours};
}

// The same over one square whose corners are far from the highlight.
Scene inside(Shading shading) {
    Scene scene = narrow();
    scene.settings.shading = shading;
    scene.objects[0].material.exponent = 1000;
    scene.settings.width = scene.settings.height = 65;  // a pixel's centre in the middle
    return scene;
}
Scene insidePhong() { return inside(Shading::Phong); }
Finding runInside(Trial& trial) {
    const auto middle = [&](Shading shading) {
        return std::abs(vectorOf(trial.frame(inside(shading)), {BufferId::Specular, 0}, 32 * 65 + 32).x - 1);
    };
    return {middle(Shading::Gouraud), middle(Shading::Phong)};
}

}  // namespace

std::span<const Case> highlightCases() {
    static const Case cases[]{
        {.id = "S10",
         .group = Group::Shading,
         .title = "Specular exponent 1 to 10⁶",
         .input = "e = 128, 10⁴, 10⁶; 4000 angles each",
         .naive = "pow(N·H, e)",
         .stable = "exp(e log1p(−½ |N − H|²))",
         .measure = "largest error",
         .reference = "long double, of the stored vectors",
         // Of q within 2^-22, at most e^-1 times that; exp rounds to 2^-24.
         .bound = 2e-7,
         .run = runPower,
         .scene = close,
         .naiveWith = "numerics.power=pow",
         .knob = {.label = "exponent e",
                  .setting = "material.0.n",
                  .low = 1,
                  .high = 1e6,
                  .naive = naivePower,
                  .ours = ourPower}},
        {.id = "S5",
         .group = Group::Shading,
         .title = "Light behind the surface",
         .input = "2000 directions, three models",
         .naive = "k_s max(0, R·V)ⁿ, whatever N·L",
         .stable = "a light counts where N·L > 0",
         .measure = "largest term",
         .reference = "0",
         .bound = 0,
         .run = runBehindTheSurface},
        {.id = "S7",
         .group = Group::Shading,
         .title = "R·V below 0, exponent 32.5",
         .input = "R·V = −10⁻⁸",
         .naive = "pow(R·V, n)",
         .stable = "0 where R·V ≤ 0",
         .measure = "specular term",
         .reference = "0",
         .bound = 0,
         .run = runNegative},
        {.id = "S8",
         .group = Group::Shading,
         .title = "Exponent 0, surface away from light",
         .input = "three models",
         .naive = "pow(max(0, N·H), 0) = 1",
         .stable = "k_s where the light counts, else 0",
         .measure = "largest error",
         .reference = "k_s and 0",
         .bound = 0,
         .run = runZero},
        {.id = "S9",
         .group = Group::Shading,
         .title = "Exponent 1",
         .input = "4000 angles, float",
         .naive = "exp(e (N·H − 1)), the cheap lobe",
         .stable = "exp(log1p(−q))",
         .measure = "largest error",
         .unit = "eps",
         .reference = "the cosine in long double",
         .bound = 4,
         .run = runLinear},
        {.id = "S11",
         .group = Group::Shading,
         .title = "Half value of a highlight",
         .input = "e = 1, 32, 128, 10⁴, 10⁶",
         .naive = "pow(N·H, e) in float",
         .stable = "exp(e log1p(−q)) in double",
         .measure = "largest error",
         .reference = "½ at acos 2^(−1/e)",
         // e θ times the 2^-53 of the stored sine: 1.2e-3 · 10^6 · 1.1e-16 · θ, and 2 units of the exponential.
         .bound = 1e-12,
         .run = runHalfValue},
        {.id = "S13",
         .group = Group::Shading,
         .title = "Highlight narrower than a pixel",
         .input = "e = 10⁶, radius 0.3 pixels",
         .naive = "pow(N·H, e) in float",
         .stable = "each pixel has the value at its centre; it is not widened",
         .measure = "largest error of a pixel",
         .reference = "(1 + x² + y²)^(−e/2)",
         .bound = 1e-9,
         .run = runNarrow,
         .scene = narrow},
        {.id = "S14",
         .group = Group::Shading,
         .title = "Highlight within one polygon",
         .input = "n = 1000, corners far from it",
         .naive = "intensities of the corners (Gouraud)",
         .stable = "normals of the corners (Phong)",
         .measure = "error in the middle",
         .reference = "k_s",
         .bound = 1e-12,
         .run = runInside,
         .scene = insidePhong,
         .naiveWith = "shading=gouraud"},
    };
    return cases;
}

}  // namespace pipeline::check
