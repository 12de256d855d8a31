#pragma once
#include <array>
#include <cstdint>
#include <limits>

#include "pipeline/core/numerics.h"
#include "pipeline/defects/hooks.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// What the illumination models have in common.

template <class Real>
struct Surface {  // where a light is evaluated; world space, N and V unit
    Vec3<Real> position, N, V;
    Vec3<Real> color = Vec3<Real>(1);  // of the mesh's vertices: multiplies k_d and k_a
};

// How a light is computed. First what beyond what its terms need: all of it by default; the plan leaves
// parts out (pipeline/scene/rules.h), which changes no term. Then in which forms.
struct LightDetail {
    bool reflection = true, halfway = true;  // R and R·V, H and N·H where the model does not read them
    bool dull = true;                        // the power where k_s is 0
    bool vanishing = true;                   // the power where its result is rounded to 0, or changes nothing
    PowerForm power = PowerForm::Log1p;
    UnitForm unit = UnitForm::Scaled;  // of L and H
    // The logarithm of the largest ratio of a specular term with power 1 to what is there without any light. Where
    // `vanishing` is off, a power that changes no bit of their sum vanishes too. Infinite where that ratio is not known,
    // or the term itself is asked for.
    double logContrast = std::numeric_limits<double>::infinity();
    Planted planted{};
    bool operator==(const LightDetail&) const = default;
};

// What became of the power of the specular term.
enum class Power : std::uint8_t { None, Computed, Vanished };

// Everything about one light at one surface point. Directions are unit vectors in world space, or
// (0, 0, 0) where they are not defined: a point light in the surface point itself, H when L = −V.
template <class Real>
struct LightSample {
    Vec3<Real> L, R, H;
    Real nDotL, rDotV, nDotH;  // −1..1, not clamped
    Real specularPower;        // (R·V)^n or (N·H)^s, 0 where it does not count
    Power power = Power::None;
    Real fading = 1;                           // OpenGL: attenuation times spot, else 1
    std::array<Real, kMostFactors> factors{};  // of the model's own, in the order of its row
    // What the light adds, before its shadow factor. A specular term of 0 is +0: one that is left out is.
    Vec3<Real> ambient, diffuse, specular;
};

// L for a light that stands at `place`, at infinity in that direction.
template <class Real>
Vec3<Real> towardsLight(LightKind kind, Vec3d place, Vec3<Real> position, UnitForm unit = UnitForm::Scaled) {
    return normalized(kind == LightKind::AtInfinity ? Vec3<Real>(place) : Vec3<Real>(place) - position, unit);
}
// Of an area light towards its centre: the rectangle counts in the shadow factor alone.
template <class Real>
Vec3<Real> towardsLight(const Light& light, Vec3<Real> position, UnitForm unit = UnitForm::Scaled) {
    return towardsLight(light.kind, light.position, position, unit);
}

// The directions and dot products, with nothing added yet; R and H where they are asked for.
// R = 2 (N·L) N − L, the law of reflection; H = (L + V) / |L + V|.
template <class Real>
LightSample<Real> directionsOf(const Light& light, const Surface<Real>& at, bool reflection, bool halfway,
                               UnitForm unit) {
    LightSample<Real> s{};
    s.fading = 1;
    s.L = towardsLight(light, at.position, unit);
    s.nDotL = glm::dot(at.N, s.L);
    if (reflection) {
        s.R = 2 * s.nDotL * at.N - s.L;
        s.rDotV = glm::dot(s.R, at.V);
    }
    if (halfway) {
        s.H = normalized(s.L + at.V, unit);
        s.nDotH = glm::dot(at.N, s.H);
    }
    return s;
}

// (a·b)^exponent into the sample. Where it is certain to vanish is known of its stable form alone.
template <class Real>
void raise(Vec3<Real> a, Vec3<Real> b, Real exponent, const LightDetail& detail, LightSample<Real>& s) {
    const bool vanishes = !detail.vanishing && detail.power == PowerForm::Log1p &&
                          powerVanishes(a, b, exponent, vanishesFrom<Real>(detail.logContrast));
    s.power = vanishes ? Power::Vanished : Power::Computed;
    s.specularPower = vanishes ? Real(0) : powerOfCosine(a, b, exponent, detail.power);
}

}  // namespace pipeline
