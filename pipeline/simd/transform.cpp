#include "pipeline/simd/transform.h"

#include <algorithm>
#include <array>
#include <limits>

#include "pipeline/simd/targets.h"
#include "pipeline/stages/clip.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/simd/transform.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// A number a vertex, as many as there are doubles in a vector.
using D = hn::ScalableTag<double>;
using F = hn::Rebind<float, D>;
using I = hn::RebindToSigned<F>;
using Floats = hn::Vec<F>;

struct Floats3 {
    Floats x, y, z;
};

HWY_INLINE Floats all(float value) { return hn::Set(F(), value); }

// Products before sums, sums from the left, nothing fused: glm's order.
HWY_INLINE Floats dot(Vec3<float> a, Floats3 b) {
    return hn::Add(hn::Add(hn::Mul(all(a.x), b.x), hn::Mul(all(a.y), b.y)), hn::Mul(all(a.z), b.z));
}

HWY_INLINE Floats3 load(const Vec3<float>* at) {
    Floats3 v;
    hn::LoadInterleaved3(F(), &at->x, v.x, v.y, v.z);
    return v;
}
HWY_INLINE void store(Floats3 v, Vec3<float>* at) { hn::StoreInterleaved3(v.x, v.y, v.z, F(), &at->x); }

// A view's, in float.
struct Axes {
    Vec3<float> eye, right, up, forward;
    explicit Axes(const View& view) : eye(view.eye), right(view.right), up(view.up), forward(view.forward) {}
    HWY_INLINE Floats3 toView(Floats3 world) const {
        const Floats3 p{hn::Sub(world.x, all(eye.x)), hn::Sub(world.y, all(eye.y)), hn::Sub(world.z, all(eye.z))};
        return {dot(right, p), dot(up, p), dot(forward, p)};
    }
};

}  // namespace

void transformVertices(const TransformInputs& inputs, std::size_t object, std::size_t begin, std::size_t end,
                       TransformOutput<float>& out) {
    const ObjectMatrix matrix = makeObjectMatrix(inputs.transforms[object]);
    const glm::mat3 linear(matrix.linear);
    const Vec3<float> translation(matrix.translation);
    const std::vector<Vec3d>& positions = inputs.topology->meshes[object]->positions;
    const std::size_t first = inputs.topology->firstVertex[object];
    const D d;
    const F f;
    const auto row = [&](int r, Floats3 p) HWY_ATTR {
        return hn::Add(dot({linear[0][r], linear[1][r], linear[2][r]}, p), all(translation[r]));
    };
    const std::size_t lanes = hn::Lanes(f);
    std::size_t i = begin;
    for (; i + lanes <= end; i += lanes) {
        auto x = hn::Zero(d), y = x, z = x;
        hn::LoadInterleaved3(d, &positions[i].x, x, y, z);
        const Floats3 p{hn::DemoteTo(f, x), hn::DemoteTo(f, y), hn::DemoteTo(f, z)};
        store({row(0, p), row(1, p), row(2, p)}, &out.world[first + i]);
    }
    transform(inputs, object, i, end, out);
}

namespace {

// v / z, with the bits of a division, from the inverse of z, which has the bits of a float, and not nearly as far from 1 as
// double reaches. P. Markstein, "Computation of elementary functions on the IBM RISC System/6000 processor", IBM Journal
// of Research and Development 1990.
HWY_INLINE hn::Vec<D> quotient(hn::Vec<D> v, hn::Vec<D> z, hn::Vec<D> inverse) {
#if HWY_NATIVE_FMA
    const auto guess = hn::Mul(v, inverse);
    return hn::MulAdd(hn::NegMulAdd(guess, z, v), inverse, guess);
#else
    (void)inverse;
    return hn::Div(v, z);
#endif
}

// Of as many vertices as a vector holds.
HWY_INLINE void snapVertices(const View& view, const Axes& axes, const Vec3<float>* world, SnappedVertex* to) {
    const D d;
    const F f;
    const I whole;
    const Floats3 p = axes.toView(load(world));
    const auto px = hn::PromoteTo(d, p.x), py = hn::PromoteTo(d, p.y), pz = hn::PromoteTo(d, p.z);
    const auto one = hn::Set(d, 1.0), half = hn::Set(d, 0.5);
    const auto spread = view.perspective ? pz : one;
    const auto x = hn::Mul(hn::Set(d, view.scale.x), px), y = hn::Mul(hn::Set(d, view.scale.y), py);
    const auto places = hn::Set(d, double(1 << view.subPixelBits));
    const auto inverse = hn::Div(one, pz);
    const auto divided = [&](auto v) HWY_ATTR { return view.perspective ? quotient(v, pz, inverse) : v; };
    const auto sx = hn::Add(hn::Set(d, view.centre.x), divided(x));
    const auto sy = hn::Sub(hn::Set(d, view.centre.y), divided(y));
    const auto snapped = [&](auto v)
                             HWY_ATTR { return hn::DemoteTo(whole, hn::Floor(hn::Add(hn::Mul(v, places), half))); };
    const Floats w = hn::DemoteTo(f, view.perspective ? inverse : pz);

    // planesAgainst, of the picture and of the guard band. Bits as sums of powers of two, of which most vertices have none.
    const auto zero = hn::Zero(d);
    auto bits = zero;
    const auto sideOf = [&](double band) HWY_ATTR { return hn::Mul(hn::Set(d, band), spread); };
    const auto near = hn::Sub(pz, hn::Set(d, view.near)), far = hn::Sub(hn::Set(d, view.far), pz);
    const glm::dvec2 picture = glm::dvec2(view.size) / 2.0;
    const auto side = sideOf(picture.x), top = sideOf(picture.y), guard = sideOf(kGuardBand);
    const auto isInside = [&](auto right, auto above) HWY_ATTR {  // of bands on either side
        const auto across = hn::And(hn::Ge(hn::Add(right, x), zero), hn::Ge(hn::Sub(right, x), zero));
        const auto down = hn::And(hn::Ge(hn::Sub(above, y), zero), hn::Ge(hn::Add(above, y), zero));
        return hn::And(hn::And(hn::Ge(near, zero), hn::Ge(far, zero)), hn::And(across, down));
    };
    const auto within = isInside(guard, guard);
    if (HWY_UNLIKELY(!hn::AllTrue(d, hn::And(within, isInside(side, top))))) {
        const auto add = [&](auto mask, std::uint32_t bit)
                             HWY_ATTR { bits = hn::Add(bits, hn::IfThenElseZero(mask, hn::Set(d, double(bit)))); };
        const auto distances = [&](auto visit) HWY_ATTR {
            visit(0, near), visit(1, far), visit(2, hn::Add(side, x)), visit(3, hn::Sub(side, x));
            visit(4, hn::Sub(top, y)), visit(5, hn::Add(top, y));
        };
        distances([&](unsigned plane, auto distance) HWY_ATTR {
            add(hn::Lt(distance, zero), 1u << plane);
            add(hn::Not(hn::Ge(distance, zero)), 1u << (SnappedVertex::kNotInside + plane));
        });
        add(hn::Not(within), SnappedVertex::kCut);
    }
    hn::StoreInterleaved4(snapped(sx), snapped(sy), hn::BitCast(whole, w), hn::DemoteTo(whole, bits), whole, &to->x);
}

}  // namespace

void snapAll(const View& view, std::span<const Vec3<float>> world, std::size_t begin, std::size_t end,
             SnappedVertices& out) {
    const Axes axes(view);
    const std::size_t lanes = hn::Lanes(F());
    std::size_t i = begin;
    for (; i + lanes <= end; i += lanes) snapVertices(view, axes, &world[i], &out.of[i]);
    if (i == end) return;
    // The rest, in a vector's room of its own.
    std::array<Vec3<float>, 16> from;
    from.fill(world[i]);
    std::array<SnappedVertex, 16> snapped;
    const std::size_t rest = std::min(end - i, from.size());
    std::copy_n(&world[i], rest, from.begin());
    snapVertices(view, axes, from.data(), snapped.data());
    std::copy_n(snapped.begin(), rest, &out.of[i]);
}

Bounds boundsOf(const View& view, std::span<const Vec3<float>> points) {
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    const auto infinity = hn::Set(d, std::numeric_limits<double>::infinity());
    auto lowX = infinity, lowY = infinity, lowZ = infinity;
    auto highX = hn::Neg(infinity), highY = highX, highZ = highX;
    std::size_t i = 0;
    for (; i + lanes <= points.size(); i += lanes) {
        const Floats3 point = load(&points[i]);
        const auto apart = [&](Floats v, double from)
                               HWY_ATTR { return hn::Sub(hn::PromoteTo(d, v), hn::Set(d, from)); };
        const auto x = apart(point.x, view.eye.x), y = apart(point.y, view.eye.y), z = apart(point.z, view.eye.z);
        const auto along = [&](Vec3d axis, auto& low, auto& high) HWY_ATTR {
            const auto of = [&](double by, auto v) HWY_ATTR { return hn::Mul(hn::Set(d, by), v); };
            const auto place = hn::Add(hn::Add(of(axis.x, x), of(axis.y, y)), of(axis.z, z));
            low = hn::Min(place, low), high = hn::Max(place, high);
        };
        along(view.right, lowX, highX), along(view.up, lowY, highY), along(view.forward, lowZ, highZ);
    }
    Bounds bounds = boundsIn<float>(view, points.subspan(i));
    const auto least = [&](auto v) HWY_ATTR { return hn::GetLane(hn::MinOfLanes(d, v)); };
    const auto most = [&](auto v) HWY_ATTR { return hn::GetLane(hn::MaxOfLanes(d, v)); };
    bounds.low = glm::min(bounds.low, {least(lowX), least(lowY), least(lowZ)});
    bounds.high = glm::max(bounds.high, {most(highX), most(highY), most(highZ)});
    return bounds;
}

float largestOf(std::span<const Vec3<float>> points) {
    const hn::ScalableTag<float> f;
    const std::size_t lanes = hn::Lanes(f);
    auto largest = hn::Zero(f);
    std::size_t i = 0;
    for (; i + lanes <= points.size(); i += lanes)
        for (std::size_t part = 0; part < 3; ++part)
            largest = hn::Max(hn::Abs(hn::LoadU(f, &points[i].x + part * lanes)), largest);
    return std::max(hn::GetLane(hn::MaxOfLanes(f, largest)), largestIn<float>(points.subspan(i)));
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(transformVertices);
HWY_EXPORT(snapAll);
HWY_EXPORT(boundsOf);
HWY_EXPORT(largestOf);

void transformInVectors(const TransformInputs& inputs, std::size_t object, std::size_t begin, std::size_t end,
                        TransformOutput<float>& out) {
    HWY_DYNAMIC_DISPATCH(transformVertices)(inputs, object, begin, end, out);
}

void snapInVectors(const View& view, std::span<const Vec3<float>> world, std::size_t begin, std::size_t end,
                   SnappedVertices& out) {
    HWY_DYNAMIC_DISPATCH(snapAll)(view, world, begin, end, out);
}

Bounds boundsInVectors(const View& view, std::span<const Vec3<float>> points) {
    return HWY_DYNAMIC_DISPATCH(boundsOf)(view, points);
}

float largestInVectors(std::span<const Vec3<float>> points) { return HWY_DYNAMIC_DISPATCH(largestOf)(points); }

}  // namespace pipeline
#endif
