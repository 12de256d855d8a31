#pragma once
#include "pipeline/core/numerics.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// Lecture 1's model: I = k_d I_a + Σ_k S_k I_k [k_d (N·L_k) + k_s (R_k·V)^n], for each colour.
// B. T. Phong, "Illumination for computer generated pictures", CACM 1975.

template <class Real>
struct Surface {  // where a light is evaluated; world space, N and V unit
    Vec3<Real> position, N, V;
};

// Everything about one light at one surface point. Directions are unit vectors in world space, or
// (0, 0, 0) where they are not defined: a point light in the surface point itself, H when L = −V.
template <class Real>
struct LightSample {
    Vec3<Real> L, R, H;
    Real nDotL, rDotV, nDotH;      // −1..1, not clamped
    Real specularPower;            // (R·V)^n, 0 where it does not count
    Vec3<Real> diffuse, specular;  // what the light adds, before its shadow factor
};

template <class Real>
Vec3<Real> towardsLight(const Light& light, Vec3<Real> position) {
    return light.kind == LightKind::Point ? normalized(Vec3<Real>(light.position) - position)
                                          : normalized(Vec3<Real>(light.position));
}

// A light counts only where N·L > 0, its specular part only where also R·V > 0: the rule, not an
// optimisation, since 0 times something infinite would not be 0.
template <class Real>
LightSample<Real> sampleLight(const Light& light, const Material& material, const Surface<Real>& at) {
    LightSample<Real> s{};
    s.L = towardsLight(light, at.position);
    s.nDotL = glm::dot(at.N, s.L);
    s.R = 2 * s.nDotL * at.N - s.L;
    s.H = normalized(s.L + at.V);
    s.rDotV = glm::dot(s.R, at.V);
    s.nDotH = glm::dot(at.N, s.H);
    if (!(s.nDotL > 0)) return s;

    const Vec3<Real> intensity(light.intensity * light.color);
    s.diffuse = intensity * Vec3<Real>(material.diffuse) * s.nDotL;
    if (!(s.rDotV > 0) || material.specular == Vec3d(0)) return s;
    s.specularPower = powerOfCosine(s.R, at.V, Real(material.exponent));
    s.specular = intensity * Vec3<Real>(material.specular) * s.specularPower;
    return s;
}

template <class Real>
Vec3<Real> ambientTerm(const AmbientLight& ambient, const Material& material) {
    return Vec3<Real>(ambient.intensity * ambient.color) * Vec3<Real>(material.diffuse);
}

// The formula with every dot product 1 and every reflection coefficient at its maximum over the
// materials and the three colours: what a frame buffer value of 255 stands for.
double maximumIntensity(const std::vector<Material>& materials, const std::vector<Light>& lights,
                        const AmbientLight& ambient);

}  // namespace pipeline
