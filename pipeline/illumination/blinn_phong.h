#pragma once
#include "pipeline/illumination/light_sample.h"

namespace pipeline {

// Lecture 2's model: c = Σ_k S_k c_k (k_d (N·L_k) + k_s (H_k·N)^s) + k_a c_a, all coefficients and
// lights coloured. J. Blinn, "Models of light reflection for computer synthesized pictures",
// SIGGRAPH 1977.
//
// exponentFactor multiplies the material's exponent: H leaves N half as fast as R leaves V, so
// that about 4 n gives a highlight as wide as Phong's with n.
template <class Real>
void addBlinnPhong(const Light& light, const Material& material, double exponentFactor, const Surface<Real>& at,
                   const LightDetail& detail, LightSample<Real>& s) {
    if (!(s.nDotL > 0)) return;
    const Vec3<Real> intensity(light.intensity * light.color);
    s.diffuse = intensity * Vec3<Real>(material.diffuse) * s.nDotL;
    if (!(s.nDotH > 0) || (!detail.dull && material.specular == Vec3d(0))) return;
    raise(at.N, s.H, Real(exponentFactor * material.exponent), detail, s);
    s.specular = intensity * Vec3<Real>(material.specular) * s.specularPower + Real(0);  // never -0
}

}  // namespace pipeline
