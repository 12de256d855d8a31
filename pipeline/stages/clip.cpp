#include "pipeline/stages/clip.h"

namespace pipeline {

double signedDistance(const View& view, Plane plane, Vec3d p, glm::dvec2 band) {
    const double spread = view.perspective ? p.z : 1;
    switch (plane) {
        case Plane::Near: return p.z - view.near;
        case Plane::Far: return view.far - p.z;
        case Plane::Left: return band.x * spread + view.scale.x * p.x;
        case Plane::Right: return band.x * spread - view.scale.x * p.x;
        case Plane::Top: return band.y * spread - view.scale.y * p.y;
        case Plane::Bottom: return band.y * spread + view.scale.y * p.y;
    }
    return 0;
}

namespace {

void cutBy(const View& view, Plane plane, ClippedTriangle& t) {
    const glm::dvec2 guard(kGuardBand);
    const auto distance = [&](const ClipCorner& c) { return signedDistance(view, plane, c.view, guard); };

    bool anyOutside = false;
    for (std::size_t i = 0; i < t.count; ++i) anyOutside = anyOutside || !(distance(t.corners[i]) >= 0);
    if (!anyOutside) return;

    const ClippedTriangle in = t;
    t.count = 0;
    for (std::size_t i = 0; i < in.count; ++i) {
        const ClipCorner& a = in.corners[i];
        const ClipCorner& b = in.corners[(i + 1) % in.count];
        const double da = distance(a), db = distance(b);
        const bool aInside = da >= 0, bInside = db >= 0;
        if (aInside) t.corners[t.count++] = a;
        if (aInside == bInside) continue;
        const ClipCorner& from = aInside ? a : b;
        const ClipCorner& to = aInside ? b : a;
        const double inside = aInside ? da : db, outside = aInside ? db : da;
        const double s = inside / (inside - outside);
        ClipCorner& cut = t.corners[t.count++];
        cut = {from.view + s * (to.view - from.view), from.weights + s * (to.weights - from.weights)};
        // On the plane, not beside it: 1/z at a near plane close to the eye would show the difference.
        if (plane == Plane::Near) cut.view.z = view.near;
        if (plane == Plane::Far) cut.view.z = view.far;
    }
    if (t.count < 3) t.count = 0;
}

}  // namespace

ClippedTriangle wholeTriangle(const std::array<Vec3d, 3>& corners) {
    ClippedTriangle t;
    t.count = 3;
    for (std::size_t i = 0; i < 3; ++i) {
        t.corners[i].view = corners[i];
        t.corners[i].weights = Vec3d(0);
        t.corners[i].weights[int(i)] = 1;
    }
    return t;
}

ClippedTriangle clipTriangle(const View& view, const std::array<Vec3d, 3>& corners) {
    ClippedTriangle t = wholeTriangle(corners);
    // Near first: behind the eye the side planes mean nothing.
    for (Plane plane : {Plane::Near, Plane::Far, Plane::Left, Plane::Right, Plane::Top, Plane::Bottom})
        if (t.count > 0) cutBy(view, plane, t);
    return t;
}

}  // namespace pipeline
