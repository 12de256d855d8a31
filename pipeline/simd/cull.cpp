#include "pipeline/simd/cull.h"

#include <algorithm>
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
namespace {

// For one vector of triangles: twice the signed areas in steps², negative if counter-clockwise on the screen. isPlain:
// the lanes in front of every plane that are small enough for these areas to be exact.
struct SnappedAreas {
    Ints area2;
    hn::Mask<I> isPlain;

    // triangleAt(l): the triangle of lane l.
    template <class TriangleAt>
    HWY_INLINE SnappedAreas(const SnappedVertices& from, TriangleAt triangleAt) {
        // Keeps products of two sides below 2^30.
        const Ints limit = hn::Set(I(), 1 << 15), zero = hn::Zero(I());
        Ints x[3], y[3], beside = zero;
        const SnappedVertex* const all = from.of.data();
        for (int i = 0; i < 3; ++i) {
            const auto corner = loadFours(I(), [&](std::size_t l) { return &all[triangleAt(l).vertices[i]].x; });
            x[i] = corner.of[0], y[i] = corner.of[1], beside = hn::Or(beside, corner.of[3]);
        }
        const auto extent = [&](const Ints(&c)[3]) HWY_ATTR {
            return hn::Sub(hn::Max(c[0], hn::Max(c[1], c[2])), hn::Min(c[0], hn::Min(c[1], c[2])));
        };
        isPlain = hn::And(hn::Eq(beside, zero), hn::And(hn::Lt(extent(x), limit), hn::Lt(extent(y), limit)));
        area2 = hn::Sub(hn::Mul(hn::Sub(x[1], x[0]), hn::Sub(y[2], y[0])),
                        hn::Mul(hn::Sub(y[1], y[0]), hn::Sub(x[2], x[0])));
    }
};

}  // namespace

// For meshes of triangles only.
void cullTriangles(const CullInputs& inputs, const TransformOutput<float>& in, std::size_t begin, std::size_t end,
                   CullOutput& out) {
    const I whole;
    const std::span<const Triangle> triangles = in.topology->triangles;
    const Ints zero = hn::Zero(whole);
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
        const SnappedAreas areas(in.snapped, [&](std::size_t l) -> const Triangle& { return here[l]; });
        Ints front = hn::Neg(areas.area2);
        if (mirrors) {
            std::uint32_t mirrored = 0;
            for (std::size_t l = 0; l < lanes; ++l)
                mirrored |= std::uint32_t(in.mirrored[in.topology->objectOfPolygon(base + l)] != 0) << l;
            front = hn::IfThenElse(hn::RebindMask(whole, maskOf(mirrored)), areas.area2, front);
        }
        static_assert(CullMark::kBack == 1);
        const Ints isBack = hn::BitCast(whole, hn::ShiftRight<31>(hn::BitCast(U(), front)));
        const Ints found =
            hn::IfThenElse(hn::Eq(front, zero), degenerate, hn::IfThenElse(hn::Lt(front, zero), backIs, kept));
        const auto put = [&](Ints values, void* to) HWY_ATTR {
            hn::StoreU(hn::DemoteTo(bytes, values), bytes, static_cast<std::uint8_t*>(to));
        };
        put(found, &out.verdicts[base]), put(hn::Or(isBack, hn::Set(whole, CullMark::kInside)), &out.marks[base]);
        // The scalar stage overwrites the lanes that are not plain.
        for (std::uint32_t rest = bitsOf(hn::Not(asFloats(areas.isPlain))); rest != 0; rest &= rest - 1) {
            const std::size_t p = base + std::size_t(std::countr_zero(rest));
            cull(inputs, in, p, p + 1, out);
        }
    }
    cull(inputs, in, base, end, out);
}

// For polygons of any kind: sums over their triangles, for as many triangles as there is room. The scalar stage does
// polygons with more triangles.
void cullSums(const CullInputs& inputs, const TransformOutput<float>& in, std::size_t begin, std::size_t end,
              CullOutput& out) {
    constexpr std::size_t kRoom = 256;
    const Topology& topology = *in.topology;
    const std::span<const Triangle> triangles = topology.triangles;
    HWY_ALIGN std::int32_t area2[kRoom], plain[kRoom];
    for (std::size_t polygon = begin; polygon < end;) {
        const std::size_t first = topology.firstTriangleOf(polygon);
        std::size_t next = polygon, last = first;
        while (next < end && last + topology.triangleCountOf(next) <= first + kRoom)
            last += topology.triangleCountOf(next++);
        if (next == polygon) {
            cull(inputs, in, polygon, polygon + 1, out), ++polygon;
            continue;
        }
        for (std::size_t t = first; t < last; t += hn::Lanes(I())) {
            const SnappedAreas areas(
                in.snapped, [&](std::size_t l) -> const Triangle& { return triangles[std::min(t + l, last - 1)]; });
            hn::Store(areas.area2, I(), area2 + (t - first));
            hn::Store(hn::VecFromMask(I(), areas.isPlain), I(), plain + (t - first));
        }
        for (std::size_t t = 0; polygon < next; ++polygon) {
            std::int64_t front = 0;
            bool covers = false, isPlain = true;
            for (const std::size_t behind = t + topology.triangleCountOf(polygon); t < behind; ++t)
                front -= area2[t], covers = covers || area2[t] != 0, isPlain = isPlain && plain[t] != 0;
            if (!isPlain) {
                cull(inputs, in, polygon, polygon + 1, out);
                continue;
            }
            if (in.mirrored[topology.objectOfPolygon(polygon)]) front = -front;
            out.marks[polygon] = std::uint8_t(CullMark::kInside | (front < 0 ? CullMark::kBack : 0));
            out.verdicts[polygon] = !covers                                      ? Verdict::Degenerate
                                    : front < 0 && inputs.mode == CullMode::Back ? Verdict::BackFacing
                                                                                 : Verdict::Kept;
        }
    }
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(cullTriangles);
HWY_EXPORT(cullSums);

void cullInVectors(const CullInputs& inputs, const TransformOutput<float>& in, std::size_t begin, std::size_t end,
                   CullOutput& out) {
    if (in.snapped.of.empty() || !in.transparent.empty()) return cull(inputs, in, begin, end, out);
    // If every polygon is a triangle, both have the same index.
    if (in.topology->triangles.size() == in.topology->polygonCount())
        HWY_DYNAMIC_DISPATCH(cullTriangles)(inputs, in, begin, end, out);
    else
        HWY_DYNAMIC_DISPATCH(cullSums)(inputs, in, begin, end, out);
}

}  // namespace pipeline
#endif
