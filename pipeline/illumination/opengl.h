#pragma once
#include "pipeline/core/angles.h"
#include "pipeline/core/elementary.h"
#include "pipeline/illumination/model_table.h"

namespace pipeline {

// The fixed-function lighting of OpenGL 1.x: emission + k_a a + Σ_k fade_k [k_a a_k + k_d d_k (N·L_k)
// + k_s s_k (N·H_k)^n]. M. Segal and K. Akeley, "The OpenGL graphics system: a specification
// (version 1.5)", 2003, section 2.14.1.

// Colours are clamped to 1 soon after; up to here products with intensities stay finite.
inline constexpr double kBrightest = 1e18;

// 1 / (c + l d + q d²) at distance d from the light, world units; 1 for a light at infinity.
// 0 where the denominator is not above 0: nothing says how bright the light is there.
template <class Real>
Real attenuation(const Light& light, Vec3<Real> position) {
    if (light.kind == LightKind::AtInfinity) return 1;
    const Real d = glm::length(Vec3<Real>(light.position) - position);
    const Real denominator = Real(light.gl.constant) + d * (Real(light.gl.linear) + d * Real(light.gl.quadratic));
    return denominator > 0 ? std::min(1 / denominator, Real(kBrightest)) : Real(0);
}

// (−L·D)^exponent within the cone, 0 outside; 1 where there is no spot. 0⁰ is 1.
template <class Real>
Real spotFactor(const Light& light, Vec3<Real> L) {
    if (light.gl.spotCutoff == 180) return 1;
    const Real cosine = glm::dot(-L, normalized(Vec3<Real>(light.gl.spotDirection)));
    if (cosine < Real(cosDegrees(light.gl.spotCutoff))) return 0;
    return light.gl.spotExponent == 0 ? Real(1) : pow(cosine, Real(light.gl.spotExponent));
}

// The specular part counts where N·L > 0, whatever N·H is; with exponent 0 it is then 1.
template <class Real>
void addOpenGl(const LitSurface<Real>& in, LightSample<Real>& s) {
    const auto& [light, material, at, detail, exponent, halfway, attenuated] = in;
    s.fading = (attenuated ? attenuation(light, at.position) : Real(1)) * spotFactor(light, s.L);
    const Real strength = s.fading * Real(light.intensity);
    s.ambient = strength * Vec3<Real>(light.gl.ambient) * Vec3<Real>(material.ambient);
    if (!(s.nDotL > 0)) return;
    s.diffuse = strength * Vec3<Real>(light.color) * Vec3<Real>(material.diffuse) * s.nDotL;
    if (!detail.dull && material.specular == Vec3d(0)) return;
    if (exponent == 0)
        s.specularPower = 1;
    else
        raise(at.N, s.H, Real(exponent), detail, s);
    const Vec3<Real> reflected = strength * Vec3<Real>(light.gl.specular) * Vec3<Real>(material.specular);
    s.specular = reflected * s.specularPower + Real(0);  // never -0
}

}  // namespace pipeline
