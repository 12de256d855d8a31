#pragma once
#include "pipeline/core/real.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// The camera as the stages use it. View space is left-handed: x right, y up, z away from the
// viewer; z_view is the distance along the viewing direction.
//   screen x = centre.x + scale.x · x_view / (perspective ? z_view : 1), pixels
//   screen y = centre.y − scale.y · y_view / (perspective ? z_view : 1), pixels, downwards
struct View {
    Vec3d eye{0.0};  // world space
    // A point on the viewing axis that vertices are taken relative to, world space, and its z_view; see toView.
    Vec3d pivot{0.0};
    double pivotDepth = 0;
    Vec3d right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, 1};  // world space, orthonormal
    bool perspective = true;
    glm::dvec2 scale{1.0};     // pixels per view unit (at z_view = 1 in perspective)
    glm::dvec2 centre{0.0};    // pixels
    glm::ivec2 size{0};        // pixels
    int subPixelBits = 8;      // corners are snapped to 2^-bits pixels, 1 to 16
    double near = 0, far = 0;  // z_view, 0 < near < far (near may be < 0 when orthographic)
    bool operator==(const View&) const = default;

    // Vertices are taken relative to the eye itself.
    void placeEye(Vec3d position) { eye = pivot = position, pivotDepth = 0; }
};

// The view of a scene's camera, whatever it is: where eye and target are one point, or up is parallel to the
// viewing direction or (0, 0, 0), the axis least aligned with the other takes the place of what is missing. Near and far
// come from the scene's bounds where the camera leaves them open: the largest range that holds every vertex in front of
// the eye, and in perspective no larger than nearestShare allows.
View makeView(const Scene& scene);

// The smallest near plane, as a share of far, that is chosen for a format. Linear, Reversed and Infinite keep their
// relative precision at any distance. At this share Float, Fixed24 and Fixed32 still tell apart depths at the far plane
// that differ by a sixteenth: their step is 2^-24 or 2^-32 of z² / near. Those of 16 bits are as coarse there as their
// number of bits makes them, and hide no more than Float.
double nearestShare(DepthFormat format);

// A point of world space in the view's: R (p − pivot) + (0, 0, z of the pivot). Far from the origin points and pivot are
// large and alike, so that their difference keeps its digits. A camera's pivot is the point between eye and target that is
// nearest to the origin: however far the eye is, x_view and y_view do not contain its distance, as in lecture 1's matrix.
template <class Real>
Vec3<Real> toView(const View& view, Vec3<Real> world) {
    const Vec3<Real> p = world - Vec3<Real>(view.pivot);
    return {glm::dot(Vec3<Real>(view.right), p), glm::dot(Vec3<Real>(view.up), p),
            glm::dot(Vec3<Real>(view.forward), p) + Real(view.pivotDepth)};
}

// And back.
inline Vec3d fromView(const View& view, Vec3d p) {
    return view.pivot + p.x * view.right + p.y * view.up + (p.z - view.pivotDepth) * view.forward;
}

// The point on the picture's plane through z_view = distance that pixel position p (pixels,
// centre at +0.5) looks at; world space.
Vec3d worldPoint(const View& view, glm::dvec2 p, double zView);

}  // namespace pipeline
