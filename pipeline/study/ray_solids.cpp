#include "pipeline/study/ray_solids.h"

#include <span>

namespace pipeline::rays {
namespace {

// An interval of a ray, with the normals at its ends: what is common to convex parts.
template <class Real>
struct Chord {
    Real begin = -kInfinity<Real>, end = kInfinity<Real>;
    Vec3<Real> beginNormal{0}, endNormal{0};

    // begin > end: nothing in common.
    void cut(Real a, Vec3<Real> aNormal, Real b, Vec3<Real> bNormal) {
        if (a > begin) begin = a, beginNormal = aNormal;
        if (b < end) end = b, endNormal = bNormal;
    }
    void empty() { end = -kInfinity<Real>; }
    Crossings<Real> ends() const {
        Crossings<Real> both;
        if (!(begin <= end)) return both;
        both.add(begin, beginNormal);
        both.add(end, endNormal);
        return both;
    }
};

// -half <= coordinate <= half.
template <class Real>
void cutBySlab(const Ray<Real>& ray, int axis, Real half, Chord<Real>& chord) {
    const Real o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0) {
        if (std::abs(o) > half) chord.empty();
        return;
    }
    Vec3<Real> normal(0);
    normal[axis] = d > 0 ? Real(-1) : Real(1);  // of the side where the ray comes in
    const Real side = normal[axis] * half;
    chord.cut((side - o) / d, normal, (-side - o) / d, -normal);
}

template <class Real>
Crossings<Real> plane(const Ray<Real>& ray) {
    Crossings<Real> one;
    if (ray.direction.z == 0) return one;
    const Real t = -ray.origin.z / ray.direction.z;
    const Vec3<Real> p = ray.at(t);
    if (std::abs(p.x) <= Real(0.5) && std::abs(p.y) <= Real(0.5)) one.add(t, {0, 0, 1});
    return one;
}

template <class Real>
Crossings<Real> box(const Ray<Real>& ray) {
    Chord<Real> chord;
    for (int axis = 0; axis < 3; ++axis) cutBySlab(ray, axis, Real(0.5), chord);
    return chord.ends();
}

// The point closest to the centre, by t: half a chord of the unit sphere lies on either side of it.
template <class Real>
Crossings<Real> sphere(const Ray<Real>& ray) {
    Crossings<Real> two;
    const Real dd = glm::dot(ray.direction, ray.direction);
    const Real middle = -glm::dot(ray.origin, ray.direction) / dd;
    const Vec3<Real> closest = ray.at(middle);
    const Real square = (1 - glm::dot(closest, closest)) / dd;
    if (!(square >= 0)) return two;
    const Real half = std::sqrt(square);
    for (const Real t : {middle - half, middle + half}) two.add(t, ray.at(t));
    return two;
}

template <class Real>
Crossings<Real> cylinder(const Ray<Real>& ray) {
    Chord<Real> chord;
    cutBySlab(ray, 2, Real(1), chord);
    const Vec2<Real> o(ray.origin), d(ray.direction);
    const Real dd = glm::dot(d, d);
    if (dd == 0) {
        if (glm::dot(o, o) > 1) chord.empty();
        return chord.ends();
    }
    const Real middle = -glm::dot(o, d) / dd;
    const Vec2<Real> closest = o + middle * d;
    const Real square = (1 - glm::dot(closest, closest)) / dd;
    if (!(square >= 0)) return {};
    const Real half = std::sqrt(square);
    const auto normal = [&](Real t) { return Vec3<Real>(o + t * d, Real(0)); };
    chord.cut(middle - half, normal(middle - half), middle + half, normal(middle + half));
    return chord.ends();
}

// c[0] + c[1] t + c[2] t² + …
template <class Real>
Real evaluate(std::span<const Real> c, Real t) {
    Real sum = 0;
    for (std::size_t i = c.size(); i-- > 0;) sum = sum * t + c[i];
    return sum;
}

template <class Real>
struct Roots {
    std::array<Real, 4> at{};
    std::size_t count = 0;
};

// A root between a and b, where the polynomial has different signs: halved until no number lies between.
template <class Real>
Real rootBetween(std::span<const Real> c, Real a, Real b) {
    const bool falls = evaluate(c, a) > 0;
    for (;;) {
        const Real middle = a + (b - a) / 2;
        if (!(a < middle && middle < b)) return middle;
        (evaluate(c, middle) > 0) == falls ? a = middle : b = middle;
    }
}

// The roots between low and high: one where the sign changes between two neighbouring roots of the derivative. Where
// the polynomial touches 0 it may have two or none, as the rounding has it.
template <class Real>
Roots<Real> rootsOf(std::span<const Real> c, Real low, Real high) {
    Roots<Real> roots;
    if (c.size() < 2) return roots;
    std::array<Real, 5> slope{};
    for (std::size_t i = 1; i < c.size(); ++i) slope[i - 1] = Real(i) * c[i];
    const Roots<Real> turns = rootsOf(std::span<const Real>(slope).first(c.size() - 1), low, high);
    Real a = low;
    for (std::size_t i = 0; i <= turns.count; ++i) {
        const Real b = i < turns.count ? turns.at[i] : high;
        if ((evaluate(c, a) > 0) != (evaluate(c, b) > 0)) roots.at[roots.count++] = rootBetween(c, a, b);
        a = b;
    }
    return roots;
}

constexpr double kTube = 0.4, kReach = 1 + kTube;

// (|p|² + 1 − tube²)² − 4 (x² + y²) along the ray, for a direction of length 1.
template <class Real>
std::array<Real, 5> torusAlong(const Ray<Real>& ray) {
    const Vec3<Real> o = ray.origin, d = ray.direction;
    const Real b = glm::dot(o, d), k = glm::dot(o, o) + 1 - Real(kTube) * Real(kTube);
    return {k * k - 4 * (o.x * o.x + o.y * o.y), 4 * b * k - 8 * (o.x * d.x + o.y * d.y),
            4 * b * b + 2 * k - 4 * (d.x * d.x + d.y * d.y), 4 * b, 1};
}

template <class Real>
Crossings<Real> torus(const Ray<Real>& ray) {
    Crossings<Real> found;
    // From the point closest to the centre, at unit speed: the numbers are of the torus' size wherever the eye is.
    const Real speed = glm::length(ray.direction);
    const Vec3<Real> d = ray.direction / speed;
    const Real middle = -glm::dot(ray.origin, d);
    const Vec3<Real> closest = ray.origin + middle * d;
    const Real square = Real(kReach) * Real(kReach) - glm::dot(closest, closest);
    if (!(square > 0)) return found;
    const Real half = std::sqrt(square);
    const std::array<Real, 5> c = torusAlong(Ray<Real>{closest, d});
    const Roots<Real> roots = rootsOf(std::span<const Real>(c), -half, half);
    for (std::size_t i = 0; i < roots.count; ++i) {
        const Vec3<Real> p = closest + roots.at[i] * d;
        const Vec3<Real> toCircle = unit(Vec3<Real>(p.x, p.y, 0));
        found.add((middle + roots.at[i]) / speed, p - toCircle);
    }
    return found;
}

}  // namespace

template <class Real>
Crossings<Real> crossings(ShapeKind kind, const Ray<Real>& ray) {
    switch (kind) {
        case ShapeKind::Plane: return plane(ray);
        case ShapeKind::Box: return box(ray);
        case ShapeKind::Sphere: return sphere(ray);
        case ShapeKind::Cylinder: return cylinder(ray);
        case ShapeKind::Torus: return torus(ray);
        case ShapeKind::Teapot: break;
    }
    return {};
}

template <class Real>
bool torusMeetsItself(const Ray<Real>& ray, Real end) {
    const Real speed = glm::length(ray.direction);
    const std::array<Real, 5> c = torusAlong(Ray<Real>{ray.origin, ray.direction / speed});
    const Real high = std::min(end * speed, Real(2 * kReach));
    return rootsOf(std::span<const Real>(c).subspan(1), Real(0), high).count > 0;
}

#define SHADESCOPE_INSTANTIATE(Real)                                 \
    template Crossings<Real> crossings(ShapeKind, const Ray<Real>&); \
    template bool torusMeetsItself(const Ray<Real>&, Real);
SHADESCOPE_INSTANTIATE(double)
SHADESCOPE_INSTANTIATE(long double)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline::rays
