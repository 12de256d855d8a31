#include "pipeline/simd/cull.h"

#include <algorithm>
#include <bit>
#include <cmath>

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
    const auto* planes = reinterpret_cast<const std::int32_t*>(from.planes.data());
    // Products of two sides stay below 2^30.
    const Ints limit = hn::Set(whole, 1 << 15), zero = hn::Zero(whole);
    const double toPixels = std::ldexp(0.5, -2 * from.bits);
    const std::size_t lanes = hn::Lanes(whole);
    std::size_t base = begin;
    for (; base + lanes <= end; base += lanes) {
        Ints v[3], polygon, x[3], y[3];
        hn::LoadInterleaved4(whole, reinterpret_cast<const std::int32_t*>(&in.topology->triangles[base]), v[0], v[1],
                             v[2], polygon);
        Ints beside = zero;
        for (int i = 0; i < 3; ++i) {
            beside = hn::Or(beside, hn::GatherIndex(whole, planes, v[i]));
            x[i] = hn::GatherIndex(whole, from.x.data(), v[i]), y[i] = hn::GatherIndex(whole, from.y.data(), v[i]);
        }
        const auto extent = [&](const Ints(&c)[3]) HWY_ATTR {
            return hn::Sub(hn::Max(c[0], hn::Max(c[1], c[2])), hn::Min(c[0], hn::Min(c[1], c[2])));
        };
        const auto plain = hn::And(hn::Eq(beside, zero), hn::And(hn::Lt(extent(x), limit), hn::Lt(extent(y), limit)));
        const Ints area2 = hn::Sub(hn::Mul(hn::Sub(x[1], x[0]), hn::Sub(y[2], y[0])),
                                   hn::Mul(hn::Sub(y[1], y[0]), hn::Sub(x[2], x[0])));
        const std::uint32_t isPlain = bitsOf(asFloats(plain));
        HWY_ALIGN std::int32_t clockwise[16];
        hn::Store(area2, whole, clockwise);
        for (std::size_t l = 0; l < lanes; ++l) {
            const std::size_t p = base + l;
            if (!(isPlain >> l & 1)) {
                cull(inputs, in, p, p + 1, out);
                continue;
            }
            const bool mirrored = in.mirrored[in.topology->polygonObject[p]] != 0;
            const std::int32_t front = mirrored ? clockwise[l] : -clockwise[l];
            out.verdicts[p] = front == 0                                   ? Verdict::Degenerate
                              : front < 0 && inputs.mode == CullMode::Back ? Verdict::BackFacing
                                                                           : Verdict::Kept;
            out.signedAreas[p] = front * toPixels;
            out.inside[p] = 1;
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
    if (!triangles || in.snapped.empty() || !in.transparent.empty()) return cull(inputs, in, begin, end, out);
    HWY_DYNAMIC_DISPATCH(cullTriangles)(inputs, in, begin, end, out);
}

}  // namespace pipeline
#endif
