#include "pipeline/scene/view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/core/angles.h"
#include "pipeline/core/numerics.h"
#include "pipeline/scene/object_matrix.h"
#include "pipeline/scene/opacity.h"

namespace pipeline {
namespace {

// Lecture 1's camera. The closed form of the basis has no division, so phi = 0 and 180 are
// places like any other.
void placeSpherical(const Camera& camera, CameraBasisForm form, View& view) {
    const double sinTheta = sinDegrees(camera.theta), cosTheta = cosDegrees(camera.theta);
    const double sinPhi = sinDegrees(camera.phi), cosPhi = cosDegrees(camera.phi);
    const Vec3d away{sinPhi * cosTheta, sinPhi * sinTheta, cosPhi};
    view.eye = camera.rho * away, view.pivotDepth = camera.rho;
    view.forward = -away;
    view.right = {-sinTheta, cosTheta, 0};
    view.up = {-cosPhi * cosTheta, -cosPhi * sinTheta, sinPhi};
    if (form == CameraBasisForm::Angles) return;
    view.right = normalized(glm::cross(view.forward, Vec3d(0, 0, 1)));
    view.up = glm::cross(view.right, view.forward);
}

Vec3d leastAlignedAxis(Vec3d v) {
    const Vec3d a = glm::abs(v);
    return a.x <= a.y && a.x <= a.z ? Vec3d(1, 0, 0) : a.y <= a.z ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
}

void placeLookAt(const Camera& camera, View& view) {
    view.eye = camera.eye;
    view.forward = normalized(camera.target - camera.eye);
    const Vec3d up = normalized(camera.up);
    // A target in the eye says no direction: one that leaves up the most of its meaning takes its place.
    if (view.forward == Vec3d(0)) view.forward = leastAlignedAxis(up);
    view.right = normalized(glm::cross(view.forward, up));
    // So for an up that is parallel to the viewing direction, or (0, 0, 0).
    if (view.right == Vec3d(0)) view.right = normalized(glm::cross(view.forward, leastAlignedAxis(view.forward)));
    view.up = glm::cross(view.right, view.forward);
    // The pivot, from the end of the axis that is nearer to the origin: what is taken off it is small.
    const double length = glm::length(camera.target - camera.eye);
    if (glm::length(camera.target) <= glm::length(camera.eye)) {
        const double back = std::clamp(glm::dot(camera.target, view.forward), 0.0, length);
        view.pivot = camera.target - back * view.forward, view.pivotDepth = length - back;
    } else {
        view.pivotDepth = std::clamp(-glm::dot(camera.eye, view.forward), 0.0, length);
        view.pivot = camera.eye + view.pivotDepth * view.forward;
    }
}

// Margins and limits are powers of two, so that a scaled scene keeps its bits.
void chooseRange(const Scene& scene, View& view) {
    double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
    double nearestInFront = nearest;  // of the eye
    for (const Object& object : scene.objects) {
        if (isTransparent(object, scene.settings)) continue;
        const ObjectMatrix matrix = makeObjectMatrix(object.transform);
        for (const Vec3d& position : object.mesh->positions) {
            const double z = toView(view, toWorld(matrix, position)).z;
            nearest = std::min(nearest, z);
            farthest = std::max(farthest, z);
            if (z > 0) nearestInFront = std::min(nearestInFront, z);
        }
    }
    if (!(nearest <= farthest)) nearest = 1, farthest = 2;  // no vertex
    constexpr double kMargin = 1.0 / 1024, kDeepest = 1.0 / (1 << 20);
    if (view.perspective) {
        view.far = farthest > 0 ? farthest * (1 + kMargin) : 2;
        double share = nearestShare(scene.settings.depthFormat), near = nearestInFront * (1 - kMargin);
        // Polygons that reach behind the eye have no nearest point. They are cut at a share that leaves a double its digits,
        // or before the first vertex in front.
        if (nearest <= 0) near = std::min(near, view.far * kDeepest), share = std::max(share, 0x1p-40);
        view.near = std::max(near, view.far * share);
    } else {
        // z_view in float is off by some 2^-24 of these distances. A scene that is flat along the view, or far off for its
        // depth, must not fall behind a plane for that.
        const Vec3d eye = glm::abs(view.eye);
        const double away = std::max({std::abs(nearest), std::abs(farthest), eye.x, eye.y, eye.z});
        const double room = std::max((farthest - nearest) * kMargin, away * kDeepest);
        const double margin = room > 0 ? room : 1;
        view.near = nearest - margin;
        view.far = farthest + margin;
    }
}

}  // namespace

double nearestShare(DepthFormat format) {
    switch (format) {
        case DepthFormat::Linear:
        case DepthFormat::Reversed:
        case DepthFormat::Infinite: return 0x1p-100;
        case DepthFormat::Fixed32: return 0x1p-28;
        default: return 0x1p-20;
    }
}

View makeView(const Scene& scene) {
    const Camera& camera = scene.camera;
    View view;
    view.size = {scene.settings.width, scene.settings.height};
    view.centre = glm::dvec2(view.size) / 2.0;
    view.subPixelBits = scene.settings.subPixelBits;
    view.perspective = camera.projection == ProjectionKind::Perspective;
    if (camera.kind == CameraKind::Spherical) {
        placeSpherical(camera, scene.settings.forms.cameraBasis, view);
        // An orthographic picture shows the origin as large as the perspective one does. From the
        // origin itself that would be without end: there it is as large as from rho = 1.
        const double distance = view.perspective || camera.rho == 0 ? 1 : camera.rho;
        view.scale = glm::dvec2(camera.pixelsPerUnit * camera.screenDistance / distance);
    } else {
        placeLookAt(camera, view);
        const double half = sinDegrees(camera.fovY / 2) / cosDegrees(camera.fovY / 2);
        view.scale = glm::dvec2(view.perspective ? view.centre.y / half : view.size.y / camera.height);
    }
    if (camera.near == 0 || camera.far == 0) chooseRange(scene, view);
    if (camera.near != 0) view.near = camera.near;
    if (camera.far != 0) view.far = camera.far;
    // Where the whole scene lies beyond the plane that is given, the chosen one would lie there too: nothing is seen
    // whichever it is, so long as near stays below far. Factors of two keep a scaled scene's bits.
    if (!(view.near < view.far)) {
        if (camera.far == 0)
            view.far = view.near > 0 ? 2 * view.near : view.near / 2;
        else
            view.near = view.far > 0 ? view.far / 2 : 2 * view.far;
    }
    return view;
}

Vec3d worldPoint(const View& view, glm::dvec2 p, double zView) {
    const double spread = view.perspective ? zView : 1;
    const double x = (p.x - view.centre.x) / view.scale.x * spread;
    const double y = (view.centre.y - p.y) / view.scale.y * spread;
    return view.eye + x * view.right + y * view.up + zView * view.forward;
}

}  // namespace pipeline
