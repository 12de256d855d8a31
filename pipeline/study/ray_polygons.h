#pragma once
#include "pipeline/study/ray_light.h"

namespace pipeline::rays {

// How a scene's settings have its polygons shaded, from the formulas of flat, Gouraud and Phong shading.

// Illumination worked out ahead of the pixels, of polygons (flat) or vertices (Gouraud); of one object.
template <class Real>
struct RayElements {
    std::vector<Vec3<Real>> unshadowed;  // per element
    std::vector<Vec3<Real>> brackets;    // lights side by side: [i * lights + k]
};

template <class Real>
struct PolygonShading {
    Shading shading{};
    Interpolation interpolation{};
    // Per object.
    std::vector<std::vector<Vec3<Real>>> vertexNormals;  // unit, world space; empty in flat shading
    std::vector<RayElements<Real>> front, back;          // empty in Phong shading; back: with two-sided lighting
};
template <class Real>
PolygonShading<Real> makePolygonShading(const Scene& scene, const RayScene<Real>& rays,
                                        const RayLighting<Real>& lighting);

// The material at a point of a mesh's triangle, of whose vertices `weights` are.
Material facetMaterial(const Mesh& mesh, std::size_t triangle, const Vec3d& weights, const Material& material);

// N and I at a point of a polygon, with S per light.
template <class Real>
struct ShadedPoint {
    Vec3<Real> normal{0}, intensity{0};
};
template <class Real>
ShadedPoint<Real> shadePolygon(const Scene& scene, const RayScene<Real>& rays, const RayLighting<Real>& lighting,
                               const PolygonShading<Real>& polygons, const SurfacePoint<Real>& at,
                               std::span<const Real> shadow);

}  // namespace pipeline::rays
