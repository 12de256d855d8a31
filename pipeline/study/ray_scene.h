#pragma once
#include <vector>

#include "pipeline/core/triangle_tree.h"
#include "pipeline/scene/scene.h"
#include "pipeline/study/ray_solids.h"

namespace pipeline {

// What a ray caster takes for the surfaces of a scene.
//   Exact     the true ones: shapes by their formulas; a mesh of planar polygons is its own
//   Polygons  those of the meshes, as the stages draw them
enum class RaySurfaces : std::uint8_t { Exact, Polygons };

namespace rays {

// The camera of a scene; specification of the picture: pixel centres at +0.5, y downwards.
template <class Real>
struct RayCamera {
    Vec3<Real> eye{0}, right{0}, up{0}, forward{0};  // world space; the axes are orthonormal
    bool perspective = true;
    Real scale = 1;                        // pixels per view unit, at z_view = 1 in perspective
    Vec2<Real> centre{0};                  // pixels
    Real near = 0, far = kInfinity<Real>;  // z_view; what the camera itself says, and nothing behind the eye

    // Its t is z_view.
    Ray<Real> through(Vec2<Real> pixel) const;
    // Where a point of world space appears in the picture, pixels; it lies in front of the eye.
    Vec2<Real> placeOf(Vec3<Real> position) const;
    // V: unit, towards the eye; against the viewing direction where the view is orthographic.
    Vec3<Real> fromSurface(Vec3<Real> position) const;
};
template <class Real>
RayCamera<Real> makeCamera(const Scene& scene);

// What a ray met: a place on the surface of an object.
template <class Real>
struct SurfacePoint {
    int object = -1;  // -1: nothing
    Real t = kInfinity<Real>;
    Vec3<Real> position{0}, normal{0};  // world space; the normal is unit, outward, of the surface or the polygon
    bool back = false;                  // seen from behind
    std::uint32_t triangle = ~0u;       // index into RayScene::triangles; ~0u on a shape's own surface
    Vec3<Real> weights{0};              // of its corners, linear in space
    Real rounding = 0;                  // bound on the error of the position, world units
    Vec3<Real> plane{0};                // as the normal, of the plane of the triangle that was met
};

template <class Real>
struct RayObject {
    bool isThere = true;    // false: opacity 0
    bool isShape = false;   // met by its formula, not by its polygons
    bool isConvex = false;  // a ray that leaves it outwards meets it no more
    ShapeKind kind{};
    Mat3<Real> toWorld{1}, toObject{1}, normals{1};  // normals: the cofactors of toWorld, outward where it mirrors
    Vec3<Real> translation{0};
    Vec3<Real> middle{0}, half{0};           // of a shape's box, world space
    std::vector<Vec3<Real>> positions;       // per vertex, world space
    std::vector<Vec3<Real>> polygonNormals;  // unit, outward; (0, 0, 0) without area
    bool mirrors = false;                    // toWorld does
};

template <class Real>
struct RayTriangle {
    Corners<Real> corners{};                              // world space
    std::uint32_t object = 0, polygon = 0, triangle = 0;  // polygon and triangle within the object's mesh
};

template <class Real>
struct RayScene {
    RayCamera<Real> camera;
    std::vector<RayObject<Real>> objects;
    std::vector<RayTriangle<Real>>
        triangles;  // of the objects that are met by their polygons; as they stand in the tree
    TriangleTree<Real> tree;
    bool cullsBack = true;
};
template <class Real>
RayScene<Real> makeRayScene(const Scene& scene, RaySurfaces surfaces);

// Whether an object's transform can be undone; a shape's own surface needs that.
bool isInvertible(const ObjectTransform& transform);

// What is seen along a ray of the camera. Back faces are looked through where culling drops them. Of two surfaces at
// the same t the one of the earlier object.
template <class Real>
SurfacePoint<Real> firstSeen(const RayScene<Real>& scene, const Ray<Real>& ray);

// What may stand between a surface point and an area: of all triangles and shapes those whose box reaches into the
// pyramid of the point and the area's corners, and above the surface there.
struct Blockers {
    std::vector<std::uint32_t> triangles;  // indices into RayScene::triangles
    std::vector<std::uint32_t> shapes;     // indices into RayScene::objects
    bool empty() const { return triangles.empty() && shapes.empty(); }
};
// corners: in order around the area.
template <class Real>
Blockers blockersBefore(const RayScene<Real>& scene, const SurfacePoint<Real>& from,
                        const std::array<Vec3<Real>, 4>& corners);

// Whether something stands between a surface point and the place at t = end of a ray that leaves it on the side that
// its plane's normal points to. What is convex does not shadow itself, nor does a triangle; beyond that only what the
// rounding of the position may be is left out. among: null for everything.
template <class Real>
bool isBlocked(const RayScene<Real>& scene, const SurfacePoint<Real>& from, const Ray<Real>& ray, Real end,
               const Blockers* among = nullptr);

}  // namespace rays
}  // namespace pipeline
