#include "pipeline/simd/transform.h"

#include <algorithm>
#include <array>
#include <limits>

#include "pipeline/simd/fetch_ahead.h"
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

// One number for each vertex, as many as a vector of doubles has.
using D = hn::ScalableTag<double>;
using F = hn::Rebind<float, D>;
using I = hn::RebindToSigned<F>;
using Floats = hn::Vec<F>;
using Ints = hn::Vec<I>;

struct Floats3 {
    Floats x, y, z;
};

HWY_INLINE Floats all(float value) { return hn::Set(F(), value); }

// Products before sums, sums from the left, nothing fused: the order of glm.
HWY_INLINE Floats dot(Vec3<float> a, Floats3 b) {
    return hn::Add(hn::Add(hn::Mul(all(a.x), b.x), hn::Mul(all(a.y), b.y)), hn::Mul(all(a.z), b.z));
}

HWY_INLINE Floats3 load(const Vec3<float>* at) {
    Floats3 v;
    hn::LoadInterleaved3(F(), &at->x, v.x, v.y, v.z);
    return v;
}
HWY_INLINE void store(Floats3 v, Vec3<float>* at) { hn::StoreInterleaved3(v.x, v.y, v.z, F(), &at->x); }

// The axes of a view, in float.
struct Axes {
    Vec3<float> pivot, right, up, forward;
    float depth;
    explicit Axes(const View& view)
        : pivot(view.pivot), right(view.right), up(view.up), forward(view.forward), depth(float(view.pivotDepth)) {}
    HWY_INLINE Floats3 toView(Floats3 world) const {
        const Floats3 p{hn::Sub(world.x, all(pivot.x)), hn::Sub(world.y, all(pivot.y)), hn::Sub(world.z, all(pivot.z))};
        return {dot(right, p), dot(up, p), hn::Add(dot(forward, p), all(depth))};
    }
};

// v / z from the inverse of z, with the bits of a division. z has the bits of a float, and is far from the limits of
// double. P. Markstein, "Computation of elementary functions on the IBM RISC System/6000 processor", IBM Journal of
// Research and Development 1990.
HWY_INLINE hn::Vec<D> quotient(hn::Vec<D> v, hn::Vec<D> z, hn::Vec<D> inverse) {
#if HWY_NATIVE_FMA
    const auto guess = hn::Mul(v, inverse);
    return hn::MulAdd(hn::NegMulAdd(guess, z, v), inverse, guess);
#else
    (void)inverse;
    return hn::Div(v, z);
#endif
}

// As many vectors as D has numbers.
HWY_INLINE Floats3 inFloat(const Vec3<float>* from) { return load(from); }
HWY_INLINE Floats3 inFloat(const Vec3d* from) {
    const D d;
    auto x = hn::Zero(d), y = x, z = x;
    hn::LoadInterleaved3(d, &from->x, x, y, z);
    return {hn::DemoteTo(F(), x), hn::DemoteTo(F(), y), hn::DemoteTo(F(), z)};
}

// Projects and snaps vertices in a view.
template <bool kPerspective>
class Snapper {
public:
    explicit Snapper(const View& view)
        : m_axes(view),
          m_scale(view.scale),
          m_centre(view.centre),
          m_half(glm::dvec2(view.size) / 2.0),
          m_near(view.near),
          m_far(view.far),
          m_places(double(1 << view.subPixelBits)) {}

    // Vertices between two loops, as many as stay in the nearest cache. Divisions have a loop of their own, so that
    // nothing else waits for the divider.
    static constexpr std::size_t kMost = 128;
    struct InView {
        HWY_ALIGN float x[kMost], y[kMost], z[kMost];
        HWY_ALIGN double inverse[kMost];  // of z, in perspective
    };
    HWY_INLINE void toView(Floats3 world, InView& to, std::size_t at) const {
        const Floats3 p = m_axes.toView(world);
        hn::Store(p.x, F(), &to.x[at]), hn::Store(p.y, F(), &to.y[at]), hn::Store(p.z, F(), &to.z[at]);
        if (kPerspective) hn::Store(hn::Div(hn::Set(D(), 1), hn::PromoteTo(D(), p.z)), D(), &to.inverse[at]);
    }
    HWY_INLINE void snap(const InView& from, std::size_t at, SnappedVertex* to) const {
        const D d;
        const I whole;
        const auto load = [&](const float* of) HWY_ATTR { return hn::PromoteTo(d, hn::Load(F(), of + at)); };
        const auto z = load(from.z), one = hn::Set(d, 1);
        const auto x = hn::Mul(hn::Set(d, m_scale.x), load(from.x)), y = hn::Mul(hn::Set(d, m_scale.y), load(from.y));
        const auto inverse = kPerspective ? hn::Load(d, from.inverse + at) : one;
        const auto divided = [&](auto v) HWY_ATTR { return kPerspective ? quotient(v, z, inverse) : v; };
        const auto inSteps = [&](auto pixels)
                                 HWY_ATTR { return hn::Add(hn::Mul(pixels, hn::Set(d, m_places)), hn::Set(d, 0.5)); };
        auto column = inSteps(hn::Add(hn::Set(d, m_centre.x), divided(x)));
        auto row = inSteps(hn::Sub(hn::Set(d, m_centre.y), divided(y)));

        // Most vertices are in the picture, and so within the guard band. They have no bits, and rounding their steps
        // down is truncation.
        const auto spread = kPerspective ? z : one;
        const auto isWithin = [&](auto v, double band)
                                  HWY_ATTR { return hn::Le(hn::Abs(v), hn::Mul(hn::Set(d, band), spread)); };
        const auto isBetween = hn::And(hn::Ge(z, hn::Set(d, m_near)), hn::Le(z, hn::Set(d, m_far)));
        const auto isInPicture = hn::And(isWithin(x, m_half.x), isWithin(y, m_half.y));
        const auto isPositive = hn::Ge(hn::Min(column, row), hn::Zero(d));
        Ints planes = hn::Zero(whole);
        if (HWY_UNLIKELY(!hn::AllTrue(d, hn::And(hn::And(isBetween, isInPicture), isPositive)))) {
            column = hn::Floor(column), row = hn::Floor(row);
            planes = planesOf(x, y, z, spread);
        }
        const Floats w = hn::DemoteTo(F(), kPerspective ? inverse : z);
        hn::StoreInterleaved4(hn::DemoteTo(whole, column), hn::DemoteTo(whole, row), hn::BitCast(whole, w), planes,
                              whole, &to->x);
    }

private:
    // planesAgainst, for the picture and the guard band.
    HWY_NOINLINE Ints planesOf(hn::Vec<D> x, hn::Vec<D> y, hn::Vec<D> z, hn::Vec<D> spread) const {
        const D d;
        const auto zero = hn::Zero(d);
        auto bits = zero;  // sums of powers of two
        const auto add = [&](auto mask, std::uint32_t bit)
                             HWY_ATTR { bits = hn::Add(bits, hn::IfThenElseZero(mask, hn::Set(d, double(bit)))); };
        const auto visit = [&](unsigned plane, auto distance) HWY_ATTR {
            add(hn::Lt(distance, zero), 1u << plane);
            add(hn::Not(hn::Ge(distance, zero)), 1u << (SnappedVertex::kNotInside + plane));
        };
        const auto near = hn::Sub(z, hn::Set(d, m_near)), far = hn::Sub(hn::Set(d, m_far), z);
        const auto sideOf = [&](double band) HWY_ATTR { return hn::Mul(hn::Set(d, band), spread); };
        const auto side = sideOf(m_half.x), top = sideOf(m_half.y), guard = sideOf(kGuardBand);
        visit(0, near), visit(1, far), visit(2, hn::Add(side, x)), visit(3, hn::Sub(side, x));
        visit(4, hn::Sub(top, y)), visit(5, hn::Add(top, y));
        const auto isInside = [&](auto v) HWY_ATTR { return hn::Le(hn::Abs(v), guard); };
        const auto isBetween = hn::And(hn::Ge(near, zero), hn::Ge(far, zero));
        add(hn::Not(hn::And(isBetween, hn::And(isInside(x), isInside(y)))), SnappedVertex::kCut);
        return hn::DemoteTo(I(), bits);
    }

    Axes m_axes;
    glm::dvec2 m_scale, m_centre, m_half;  // m_half: half of the picture's size
    double m_near, m_far, m_places;
};

// Snaps vertices from `begin` on while they fill whole vectors; returns the first one that is left. worldAt(i): one
// vector of positions in world space, from vertex i on.
template <bool kPerspective, class WorldAt>
HWY_INLINE std::size_t snapWith(const Snapper<kPerspective>& snapper, std::size_t begin, std::size_t end,
                                SnappedVertex* to, WorldAt worldAt) {
    typename Snapper<kPerspective>::InView some;
    const std::size_t lanes = hn::Lanes(F()), last = begin + (end - begin) / lanes * lanes;
    for (std::size_t first = begin; first < last; first += snapper.kMost) {
        const std::size_t count = std::min(snapper.kMost, last - first);
        for (std::size_t at = 0; at < count; at += lanes) snapper.toView(worldAt(first + at), some, at);
        for (std::size_t at = 0; at < count; at += lanes)
            fetchAhead(to + first + at, lanes), snapper.snap(some, at, to + first + at);
    }
    return last;
}
template <class WorldAt>
HWY_INLINE std::size_t snapVertices(const View& view, std::size_t begin, std::size_t end, SnappedVertex* to,
                                    WorldAt worldAt) {
    return view.perspective ? snapWith(Snapper<true>(view), begin, end, to, worldAt)
                            : snapWith(Snapper<false>(view), begin, end, to, worldAt);
}

}  // namespace

void snapAll(const View& view, std::span<const Vec3<float>> world, std::size_t begin, std::size_t end,
             SnappedVertices& out) {
    const std::size_t first = snapVertices(view, begin, end, out.of.data(), [&](std::size_t i) HWY_ATTR {
        fetchAhead(&world[i], hn::Lanes(D()));
        return load(&world[i]);
    });
    if (first == end) return;
    // The rest, padded to a whole vector.
    std::array<Vec3<float>, 16> from;
    from.fill(world[first]);
    std::array<SnappedVertex, 16> snapped;
    const std::size_t rest = std::min(end - first, from.size());
    std::copy_n(&world[first], rest, from.begin());
    snapVertices(view, 0, from.size(), snapped.data(), [&](std::size_t i) HWY_ATTR { return load(&from[i]); });
    std::copy_n(snapped.begin(), rest, &out.of[first]);
}

void transformVertices(const TransformInputs& inputs, std::size_t object, std::size_t begin, std::size_t end,
                       TransformOutput<float>& out) {
    if (out.world.areGiven()) return snapAll(out.view, out.world, begin, end, out.snapped);
    const ObjectMatrix matrix = makeObjectMatrix(inputs.transforms[object]);
    const glm::mat3 linear(matrix.linear);
    const Vec3<float> translation(matrix.translation);
    const VertexVectors& positions = inputs.topology->meshes[object]->positions;
    const std::size_t first = inputs.topology->firstVertex[object];
    Vec3<float>* const world = out.world.own().data() + first;
    const D d;
    const auto row = [&](int r, Floats3 p) HWY_ATTR {
        return hn::Add(dot({linear[0][r], linear[1][r], linear[2][r]}, p), all(translation[r]));
    };
    // `from`: in float or in double.
    const auto transformFrom = [&](auto from) HWY_ATTR {
        return snapVertices(out.view, begin, end, out.snapped.of.data() + first, [&](std::size_t i) HWY_ATTR {
            fetchAhead(&from[i], hn::Lanes(d)), fetchAhead(&world[i], hn::Lanes(d));
            const Floats3 p = inFloat(&from[i]);
            const Floats3 moved{row(0, p), row(1, p), row(2, p)};
            store(moved, &world[i]);
            return moved;
        });
    };
    const std::size_t rest =
        positions.doubles().empty() ? transformFrom(positions.floats()) : transformFrom(positions.doubles());
    transform(inputs, object, rest, end, out);
    snapAll(out.view, out.world, first + rest, first + end, out.snapped);
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
        const auto x = apart(point.x, view.pivot.x), y = apart(point.y, view.pivot.y), z = apart(point.z, view.pivot.z);
        const auto along = [&](Vec3d axis, double from, auto& low, auto& high) HWY_ATTR {
            const auto of = [&](double by, auto v) HWY_ATTR { return hn::Mul(hn::Set(d, by), v); };
            const auto sum = hn::Add(hn::Add(of(axis.x, x), of(axis.y, y)), of(axis.z, z));
            const auto place = from == 0 ? sum : hn::Add(sum, hn::Set(d, from));
            low = hn::Min(place, low), high = hn::Max(place, high);
        };
        along(view.right, 0, lowX, highX), along(view.up, 0, lowY, highY);
        along(view.forward, view.pivotDepth, lowZ, highZ);
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
