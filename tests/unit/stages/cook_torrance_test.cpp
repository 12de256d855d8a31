// Microfacets against what does not depend on how they are computed: symmetry, energy, and two integrals in closed form.
#include "pipeline/illumination/illumination.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pipeline/check/scenes.h"

namespace pipeline {
namespace {

using std::numbers::pi;

Vec3d direction(double cosine, double phi) {
    const double sine = std::sqrt(1 - cosine * cosine);
    return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}
Material surface(double diffuse, double specular, double exponent) {
    Material material;
    material.diffuse = Vec3d(diffuse), material.specular = Vec3d(specular), material.exponent = exponent;
    return material;
}

// What a light of intensity 1 from L adds towards V, N = z: π times the reflectance, times N·L.
double reflected(const Material& material, Vec3d L, Vec3d V) {
    Light light;
    light.position = L;
    const LightSample<double> s = sampleLight<double>({Model::CookTorrance}, light, material, {Vec3d(0), {0, 0, 1}, V});
    return s.diffuse.x + s.specular.x;
}

// Of light that comes alike from everywhere, the part that goes towards V: the integral over cosines and angles of what is
// reflected, over π. By the midpoint rule.
double furnace(const Material& material, double cosine, int steps = 400) {
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const Vec3d L = direction((i + 0.5) / steps, 2 * pi * (j + 0.5) / steps);
            sum += reflected(material, L, direction(cosine, 0));
        }
    return sum * (2 * pi / steps) / steps / pi;
}

// Helmholtz: the reflectance is what L adds over N·L, and L and V may change places.
TEST(CookTorrance, LightAndEyeMayChangePlaces) {
    check::Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const double diffuse = random.between(0, 1), specular = random.between(0, 1), n = random.between(0, 300);
        const Material material = surface(diffuse, specular, n);
        const auto anyDirection = [&] {
            const double cosine = random.between(0.01, 1), phi = random.between(0, 6.28);
            return direction(cosine, phi);
        };
        const Vec3d L = anyDirection(), V = anyDirection();
        const double there = reflected(material, L, V) / L.z, back = reflected(material, V, L) / V.z;
        ASSERT_NEAR(there, back, 1e-9 * std::max(1.0, there)) << i;
    }
}

// n = 0 is α = 1: D is 1 everywhere and G is (N·L) / (2 (N·L + N·V)). Of mirrors that reflect all light, k_s = 1, the
// integral over the hemisphere, over π, is ∫ μ/(μ + v) dμ from 0 to 1 = 1 − v log((1 + v)/v), v = N·V. At v = 1 that is
// 1 − log 2: a single reflection loses the other seven tenths, which meet more than one mirror.
TEST(CookTorrance, TheRoughestFurnaceLosesWhatIsReflectedTwice) {
    for (const double v : {1.0, 0.7, 0.4, 0.1})
        EXPECT_NEAR(furnace(surface(0, 1, 0), v), 1 - v * std::log((1 + v) / v), 1e-4) << v;
}

// The smoother, the less is reflected twice: the loss falls towards 0. At n = 1000, α = 0.045, it is below one hundredth
// where the eye looks straight down: light leaves a mirror's neighbours alone but for slopes of order α, whose part grows
// with α².
TEST(CookTorrance, TheLossFallsWithTheRoughness) {
    double before = 0;
    for (const double n : {0.0, 2.0, 8.0, 30.0, 100.0}) {
        const double now = furnace(surface(0, 1, n), 0.9);
        EXPECT_GT(now, before) << n;
        EXPECT_LE(now, 1 + 1e-3) << n;
        before = now;
    }
    EXPECT_GT(furnace(surface(0, 1, 1000), 0.999), 0.99);
}

// No surface gives back more than it receives, whatever its parts are.
TEST(CookTorrance, NeverReflectsMoreThanFallsIn) {
    for (const double n : {0.0, 4.0, 20.0, 100.0})
        for (const double ks : {0.0, 0.04, 0.3, 1.0})
            for (const double v : {1.0, 0.6, 0.3, 0.1})
                EXPECT_LE(furnace(surface(1, ks, n), v, 120), 1 + 5e-3) << n << ", " << ks << ", " << v;
}

// In the centre of the highlight, N = L = V = H: F = k_s, D = 1/α², G = 1/4: k_s (n + 2) / 8. In float too, where
// (N·H)² (α² − 1) + 1 as written has lost 3 % at n = 10^6.
TEST(CookTorrance, TheCentreOfAHighlightKeepsItsDigits) {
    Light light;
    light.position = {0, 0, 1};
    const Surface<float> at{Vec3<float>(0), {0, 0, 1}, {0, 0, 1}};
    const LightSample<float> s = sampleLight<float>({Model::CookTorrance}, light, surface(0, 0.5, 1e6), at);
    EXPECT_NEAR(s.specular.x, 0.5 * (1e6 + 2) / 8, 0.5);
    // α beside it: with tan² = α² D is a quarter of 1/α².
    const float alpha = std::sqrt(2 / (1e6F + 2));
    const Vec3<float> N = glm::normalize(Vec3<float>(alpha, 0, 1));
    const LightSample<float> beside =
        sampleLight<float>({Model::CookTorrance}, light, surface(0, 0.5, 1e6), {Vec3<float>(0), N, {0, 0, 1}});
    EXPECT_NEAR(beside.specular.x, 0.5 * (1e6 + 2) / 32, 100);
}

// Grazing light and eye, a light in the eye's opposite, an eye behind the surface: numbers everywhere.
TEST(CookTorrance, IsANumberInEveryDirection) {
    for (const double n : {0.0, 1e6})
        for (const double l : {1.0, 1e-8, 1e-30, 1e-44})
            for (const Vec3<float> V :
                 {Vec3<float>(0, 0, 1), Vec3<float>(-1, 0, 0), Vec3<float>(0, 1, 0), Vec3<float>(0.6F, 0, -0.8F)}) {
                Light light;
                light.position = {1, 0, l};
                const LightSample<float> s = sampleLight<float>({Model::CookTorrance}, light, surface(1, 0.5, n),
                                                                {Vec3<float>(0), {0, 0, 1}, V});
                EXPECT_TRUE(std::isfinite(s.specular.x) && std::isfinite(s.diffuse.x)) << n << ", " << l;
                EXPECT_GE(s.specular.x, 0);
            }
}

}  // namespace
}  // namespace pipeline
