#pragma once
#include <algorithm>

#include "pipeline/illumination/model_table.h"

namespace pipeline {

// A surface of microscopic mirrors: c = k_a c_a + Σ_k S_k c_k [ k_d (1 − k_s)² T (N·L) + (k_s + (1 − k_s) f) D G ], the
// reflectance times π, so that a matte surface is as bright as in lecture 2's model, and times N·L.
//
// F = k_s + (1 − k_s) f, f = (1 − V·H)^5: Fresnel's reflectance, k_s at a right angle. C. Schlick, "An inexpensive BRDF
// model for physically-based rendering", Computer Graphics Forum 1994.
// D = α² / ((N·H)² (α² − 1) + 1)²: π times the density of mirrors that face H, GGX. B. Walter, S. Marschner, H. Li,
// K. Torrance, "Microfacet models for refraction through rough surfaces", EGSR 2007, equation 33.
// G: the part of them that both L and V see, over 4 (N·V). Heights correlate: E. Heitz, "Understanding the masking-shadowing
// function in microfacet-based BRDFs", JCGT 2014, equation 99; M. Pharr, W. Jakob, G. Humphreys, "Physically Based
// Rendering", 4th edition, section 9.6.
// D F G / (4 (N·L) (N·V)) is R. Cook and K. Torrance, "A reflectance model for computer graphics", ACM Transactions on
// Graphics 1982, in Walter's notation.
// α² = 2 / (n + 2): the roughness whose highlight is as wide as Blinn's with n; Walter et al., section 5.2.
// (1 − k_s)² T, T = (1 − (1 − N·L)^5)(1 − (1 − N·V)^5): what enters the surface, and what leaves it again. This makes the
// diffuse part reciprocal, and the sum of both is at most what falls in.
// P. Shirley, B. Smits, H. Hu, E. Lafortune, "A practitioners' assessment of light reflection models", Pacific Graphics
// 1997.
//
// A light counts only where N·L > 0. N·V below 0, where an interpolated normal turns away from the eye, counts as 0.
template <class Real>
void addCookTorrance(const LitSurface<Real>& in, LightSample<Real>& s) {
    if (!(s.nDotL > 0)) return;
    const auto cosine = [](Real c) { return std::clamp(c, Real(0), Real(1)); };
    const auto fifth = [](Real x) { return x * x * (x * x) * x; };
    const Real nDotL = cosine(s.nDotL), nDotV = cosine(glm::dot(in.at.N, in.at.V)), nDotH = cosine(s.nDotH);
    const Real square = Real(2) / (Real(in.exponent) + 2);  // α²
    const Real through = (1 - fifth(1 - nDotL)) * (1 - fifth(1 - nDotV));
    const Real grazing = fifth(1 - cosine(glm::dot(in.at.V, s.H)));
    // (N·H)² (α² − 1) + 1 is α² (N·H)² + 1 − (N·H)², whose last two terms cancel in the highlight: with q = 1 − N·H from
    // |N − H|² they are q (2 − q).
    const Vec3<Real> difference = in.at.N - s.H;
    const Real q = glm::dot(difference, difference) / 2;
    const Real spread = square * nDotH * nDotH + (nDotH > 0 ? q * (2 - q) : Real(1));
    const Real density = square / (spread * spread);
    // Divided by N·L: its products with roots may be too small for a number.
    const auto root = [&](Real c) -> Real { return sqrt(square + (1 - square) * c * c); };
    const Real seen = 1 / (2 * (root(nDotV) + nDotV / nDotL * root(nDotL)));
    s.factors = {Real(sqrt(square)), through, grazing, density, seen};
    const Vec3<Real> intensity(in.light.intensity * in.light.color), ks(in.material.specular), rest = Real(1) - ks;
    s.diffuse = intensity * Vec3<Real>(in.material.diffuse) * rest * rest * through * nDotL;
    s.specular = intensity * (ks + rest * grazing) * density * seen + Real(0);  // never -0
}

}  // namespace pipeline
