#pragma once
#include "pipeline/illumination/model_table.h"

namespace pipeline {

// Lecture 1's model: I = k_d I_a + Σ_k S_k I_k [k_d (N·L_k) + k_s (R_k·V)^n], for each colour.
// B. T. Phong, "Illumination for computer generated pictures", CACM 1975.
//
// A light counts only where N·L > 0, its specular part only where also R·V > 0: the rule, not an
// optimisation, since 0 times something infinite would not be 0.
template <class Real>
void addPhong(const LitSurface<Real>& in, LightSample<Real>& s) {
    const auto& [light, material, at, detail, exponent, halfway, attenuated] = in;
    if (!(s.nDotL > 0)) return;
    const Vec3<Real> intensity(light.intensity * light.color);
    s.diffuse = intensity * Vec3<Real>(material.diffuse) * s.nDotL;
    if (!(s.rDotV > 0) || (!detail.dull && material.specular == Vec3d(0))) return;
    raise(s.R, at.V, Real(exponent), detail, s);
    s.specular = intensity * Vec3<Real>(material.specular) * s.specularPower + Real(0);  // never -0
}

}  // namespace pipeline
