#pragma once
#include <span>
#include <string>

#include "pipeline/study/ray_scene.h"

namespace pipeline::rays {

// The illumination models, from their formulas:
//   Phong        k_d I_a + Σ S I [k_d (N·L) + k_s (R·V)^n]; B. T. Phong, CACM 1975
//   Blinn-Phong  k_a c_a + Σ S c (k_d (N·L) + k_s (H·N)^s); J. Blinn, SIGGRAPH 1977
//   Cook-Torrance  the same with microfacets; R. Cook and K. Torrance, ACM TOG 1982, B. Walter et al., EGSR 2007
//   OpenGL       emission, attenuation, spots, ambient parts; M. Segal and K. Akeley, the OpenGL specification 1.5, 2.14.1

// Why rays cannot evaluate a model, as part of a sentence; empty where they can.
std::string whyNoRayModel(Model model);

template <class Real>
struct RayLight {
    LightKind kind{};
    Vec3<Real> place{0};                 // world space; at infinity the unit direction towards it
    Vec3<Real> width{0}, height{0};      // sides of an area light
    Vec3<Real> color{0};                 // times the intensity: of the diffuse part
    Vec3<Real> specular{0}, ambient{0};  // times the intensity
    bool castsShadow = false;
    Real constant = 1, linear = 0, quadratic = 0;  // attenuation
    bool isSpot = false;
    Vec3<Real> spotDirection{0};  // unit, away from the light
    Real spotCosine = -1, spotExponent = 0;
};

template <class Real>
struct RayLighting {
    Model model{};
    Real exponentFactor = 1;  // of (N·H)^n
    bool infiniteViewer = false, twoSided = false;
    Vec3<Real> ambient{0};
    std::vector<RayLight<Real>> lights;
    std::vector<Material> materials, backMaterials;  // per object
    RayCamera<Real> camera;

    // Which a side of an object has.
    const Material& material(int object, bool back) const {
        return (back && twoSided ? backMaterials : materials)[std::size_t(object)];
    }
};
template <class Real>
RayLighting<Real> makeLighting(const Scene& scene);

// Where light is reflected; world space, N unit.
template <class Real>
struct LitPoint {
    Vec3<Real> position{0}, N{0};
};

// Unit, towards the light or its centre; (0, 0, 0) in the light itself.
template <class Real>
Vec3<Real> towards(const RayLight<Real>& light, Vec3<Real> position);

// A material of an object whose mesh has this colour there.
inline Material colored(Material material, const Vec3d& color) {
    material.diffuse *= color, material.ambient *= color;
    return material;
}

// What is there without any light's shadow: emission and all ambient parts.
template <class Real>
Vec3<Real> unshadowed(const RayLighting<Real>& lighting, const Material& material, const LitPoint<Real>& at);
// What light k adds where S is 1.
template <class Real>
Vec3<Real> bracket(const RayLighting<Real>& lighting, std::size_t k, const Material& material,
                   const LitPoint<Real>& at);
// The two together, with S per light.
template <class Real>
Vec3<Real> shade(const RayLighting<Real>& lighting, const Material& material, const LitPoint<Real>& at,
                 std::span<const Real> shadow);

// S of light k: 0 where the surface faces away, else what part of the light is seen, by rays. An area light's
// outline of shadow is followed through cells × cells squares of its rectangle: exact for straight edges that go
// across a square, and a part smaller than a square may be missed.
template <class Real>
Real lightSeen(const RayScene<Real>& scene, const RayLighting<Real>& lighting, std::size_t k,
               const SurfacePoint<Real>& at, int cells);

}  // namespace pipeline::rays
