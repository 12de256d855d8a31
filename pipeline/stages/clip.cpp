#include "pipeline/stages/clip.h"

namespace pipeline {

template <class W>
W signedDistance(const View& view, Plane plane, Vec3<W> p, glm::dvec2 band) {
    const W spread = view.perspective ? p.z : W(1);
    const Vec2<W> edge(band), scale(view.scale);
    switch (plane) {
        case Plane::Near: return p.z - W(view.near);
        case Plane::Far: return W(view.far) - p.z;
        case Plane::Left: return edge.x * spread + scale.x * p.x;
        case Plane::Right: return edge.x * spread - scale.x * p.x;
        case Plane::Top: return edge.y * spread - scale.y * p.y;
        case Plane::Bottom: return edge.y * spread + scale.y * p.y;
    }
    return 0;
}

namespace {

template <class W>
void cutBy(const View& view, Plane plane, ClippedTriangle<W>& t) {
    const glm::dvec2 guard(kGuardBand);
    const auto distance = [&](const ClipCorner<W>& c) { return signedDistance(view, plane, c.view, guard); };

    bool anyOutside = false;
    for (std::size_t i = 0; i < t.count; ++i) anyOutside = anyOutside || !(distance(t.corners[i]) >= 0);
    if (!anyOutside) return;

    const ClippedTriangle<W> in = t;
    t.count = 0;
    for (std::size_t i = 0; i < in.count; ++i) {
        const ClipCorner<W>& a = in.corners[i];
        const ClipCorner<W>& b = in.corners[(i + 1) % in.count];
        const W da = distance(a), db = distance(b);
        const bool aInside = da >= 0, bInside = db >= 0;
        if (aInside) t.corners[t.count++] = a;
        if (aInside == bInside) continue;
        const ClipCorner<W>& from = aInside ? a : b;
        const ClipCorner<W>& to = aInside ? b : a;
        const W inside = aInside ? da : db, outside = aInside ? db : da;
        const W s = inside / (inside - outside);
        ClipCorner<W>& cut = t.corners[t.count++];
        cut = {from.view + s * (to.view - from.view), from.weights + s * (to.weights - from.weights)};
        // On the plane, not beside it: 1/z at a near plane close to the eye would show the difference.
        if (plane == Plane::Near) cut.view.z = W(view.near);
        if (plane == Plane::Far) cut.view.z = W(view.far);
    }
    if (t.count < 3) t.count = 0;
}

}  // namespace

template <class W>
ClippedTriangle<W> wholeTriangle(const std::array<Vec3<W>, 3>& corners) {
    ClippedTriangle<W> t;
    t.count = 3;
    for (std::size_t i = 0; i < 3; ++i) {
        t.corners[i].view = corners[i];
        t.corners[i].weights = Vec3<W>(0);
        t.corners[i].weights[int(i)] = 1;
    }
    return t;
}

template <class W>
ClippedTriangle<W> clipTriangle(const View& view, const std::array<Vec3<W>, 3>& corners) {
    ClippedTriangle<W> t = wholeTriangle(corners);
    // Near first: behind the eye the side planes mean nothing.
    for (Plane plane : {Plane::Near, Plane::Far, Plane::Left, Plane::Right, Plane::Top, Plane::Bottom})
        if (t.count > 0) cutBy(view, plane, t);
    return t;
}

#define SHADESCOPE_INSTANTIATE(W)                                             \
    template W signedDistance(const View&, Plane, Vec3<W>, glm::dvec2);       \
    template ClippedTriangle<W> wholeTriangle(const std::array<Vec3<W>, 3>&); \
    template ClippedTriangle<W> clipTriangle(const View&, const std::array<Vec3<W>, 3>&);
SHADESCOPE_INSTANTIATE(double)
SHADESCOPE_INSTANTIATE(long double)
SHADESCOPE_INSTANTIATE(Quad)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
