#pragma once
#include "pipeline/illumination/model_table.h"

namespace pipeline {

// Lecture 2's model: c = Σ_k S_k c_k (k_d (N·L_k) + k_s (H_k·N)^s) + k_a c_a, all coefficients and
// lights coloured. J. Blinn, "Models of light reflection for computer synthesized pictures",
// SIGGRAPH 1977.
template <class Real>
void addBlinnPhong(const LitSurface<Real>& in, LightSample<Real>& s) {
    const auto& [light, material, at, detail, exponent, halfway, attenuated] = in;
    if (!(s.nDotL > 0)) return;
    const Vec3<Real> intensity(light.intensity * light.color);
    s.diffuse = intensity * Vec3<Real>(material.diffuse) * s.nDotL;
    if (!(s.nDotH > 0) || (!detail.dull && material.specular == Vec3d(0))) return;
    raise(at.N, s.H, Real(exponent), detail, s);
    s.specular = intensity * Vec3<Real>(material.specular) * s.specularPower + Real(0);  // never -0
}

}  // namespace pipeline
