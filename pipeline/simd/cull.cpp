#include "pipeline/simd/cull.h"

#include <bit>

#include "pipeline/simd/fetch_ahead.h"
#include "pipeline/simd/targets.h"
#include "pipeline/stages/rasterize.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/simd/cull.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
//
#include "pipeline/simd/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {
void cullTriangles(const CullInputs& inputs, const TransformOutput<float>& in, std::size_t begin, std::size_t end,
                   CullOutput& out) {
    const I whole;
    const SnappedVertices& from = in.snapped;
    const std::span<const Triangle> triangles = in.topology->triangles;
    // Products of two sides stay below 2^30.
    const Ints limit = hn::Set(whole, 1 << 15), zero = hn::Zero(whole);
    const hn::Rebind<std::uint8_t, I> bytes;
    const auto verdict = [&](Verdict one) HWY_ATTR { return hn::Set(whole, std::int32_t(one)); };
    const Ints degenerate = verdict(Verdict::Degenerate), back = verdict(Verdict::BackFacing),
               kept = verdict(Verdict::Kept);
    const bool mirrors = in.anyMirrored();
    const Ints backIs = inputs.mode == CullMode::Back ? back : kept;
    const std::size_t lanes = hn::Lanes(whole);
    std::size_t base = begin;
    for (; base + lanes <= end; base += lanes) {
        const Triangle* const here = &triangles[base];
        fetchAhead(here, lanes);
        Ints x[3], y[3], beside = zero;
        for (int i = 0; i < 3; ++i) {
            const auto corner = loadFours(whole, [&](std::size_t l) { return &from.of[here[l].vertices[i]].x; });
            x[i] = corner.of[0], y[i] = corner.of[1], beside = hn::Or(beside, corner.of[3]);
        }
        const auto extent = [&](const Ints(&c)[3]) HWY_ATTR {
            return hn::Sub(hn::Max(c[0], hn::Max(c[1], c[2])), hn::Min(c[0], hn::Min(c[1], c[2])));
        };
        const auto plain = hn::And(hn::Eq(beside, zero), hn::And(hn::Lt(extent(x), limit), hn::Lt(extent(y), limit)));
        const Ints area2 = hn::Sub(hn::Mul(hn::Sub(x[1], x[0]), hn::Sub(y[2], y[0])),
                                   hn::Mul(hn::Sub(y[1], y[0]), hn::Sub(x[2], x[0])));
        Ints front = hn::Neg(area2);
        if (mirrors) {
            std::uint32_t mirrored = 0;
            for (std::size_t l = 0; l < lanes; ++l)
                mirrored |= std::uint32_t(in.mirrored[in.topology->objectOfPolygon(base + l)] != 0) << l;
            front = hn::IfThenElse(hn::RebindMask(whole, maskOf(mirrored)), area2, front);
        }
        const Ints isBack = hn::BitCast(whole, hn::ShiftRight<31>(hn::BitCast(U(), front)));
        const Ints found =
            hn::IfThenElse(hn::Eq(front, zero), degenerate, hn::IfThenElse(hn::Lt(front, zero), backIs, kept));
        const auto put = [&](Ints values, void* to) HWY_ATTR {
            hn::StoreU(hn::DemoteTo(bytes, values), bytes, static_cast<std::uint8_t*>(to));
        };
        put(found, &out.verdicts[base]), put(isBack, &out.isBack[base]), put(hn::Set(whole, 1), &out.inside[base]);
        // The stage's own text writes over what is not plain.
        for (std::uint32_t rest = bitsOf(hn::Not(asFloats(plain))); rest != 0; rest &= rest - 1) {
            const std::size_t p = base + std::size_t(std::countr_zero(rest));
            cull(inputs, in, p, p + 1, out);
        }
    }
    cull(inputs, in, base, end, out);
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(cullTriangles);

void cullInVectors(const CullInputs& inputs, const TransformOutput<float>& in, std::size_t begin, std::size_t end,
                   CullOutput& out) {
    // Where a polygon is a triangle, it is the one of its number.
    const bool triangles = in.topology->triangles.size() == in.topology->polygonCount();
    if (!triangles || in.snapped.of.empty() || !in.transparent.empty()) return cull(inputs, in, begin, end, out);
    HWY_DYNAMIC_DISPATCH(cullTriangles)(inputs, in, begin, end, out);
}

}  // namespace pipeline
#endif
