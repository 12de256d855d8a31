#include "pipeline/stages/cull.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "pipeline/stages/rasterize.h"

namespace pipeline {

CullOutput prepareCull(std::size_t polygons) {
    return {RawVector<Verdict>(polygons), RawVector<std::uint8_t>(polygons)};
}

namespace {

__extension__ using Int128 = __int128;  // a polygon of a million corners overflows 64 bits

struct Crossed {
    bool depth = false;  // near or far runs through the polygon
    bool any = false;    // or a side of the picture
};

// The first plane that has all corners outside, as a verdict; Kept when there is none.
template <class Real>
Verdict outside(const TransformOutput<Real>& in, const Topology::Corners& corners, Crossed& crossed) {
    const glm::dvec2 picture = glm::dvec2(in.view.size) / 2.0;
    unsigned all = ~0u, any = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const PlaneBits bits = planesAgainst(in.view, Vec3<AtLeastDouble<Real>>(in.viewSpace(corners[i])), picture);
        all &= bits.outside, any |= bits.notInside;
    }
    if (all != 0) return Verdict(unsigned(Verdict::OutsideNear) + unsigned(std::countr_zero(all)));
    crossed.any = any != 0;
    crossed.depth = (any & 3u) != 0;
    return Verdict::Kept;
}

struct ScreenArea {
    double signedArea;  // px², with mirroring undone
    bool covers;        // some piece has area; a bow-tie's signed area can be 0 all the same
};

// Sum over the polygon's triangles, each clipped as the rasterizer clips it.
template <class Real>
ScreenArea screenArea(const TransformOutput<Real>& in, std::size_t polygon, bool inside) {
    const std::size_t first = in.topology->firstTriangleOf(polygon);
    Int128 area2 = 0;
    bool covers = false;
    for (std::size_t t = first; t < first + in.topology->triangleCountOf(polygon); ++t) {
        const auto& v = in.topology->triangles[t].vertices;
        area2 += setUpTriangle<Real>(
            in.view, {in.viewSpace(v[0]), in.viewSpace(v[1]), in.viewSpace(v[2])}, std::uint32_t(t),
            [&](const RasterTriangle<Real>&) { covers = true; }, inside, false);
    }
    if (in.mirrored[in.topology->objectOfPolygon(polygon)]) area2 = -area2;
    return {double(area2) / (2.0 * double(kSubPixels * kSubPixels)), covers};
}

}  // namespace

template <class Real>
void cull(const CullInputs& inputs, const TransformOutput<Real>& in, std::size_t begin, std::size_t end,
          CullOutput& out) {
    for (std::size_t polygon = begin; polygon < end; ++polygon) {
        const std::uint32_t object = in.topology->objectOfPolygon(polygon);
        if (!in.transparent.empty() && in.transparent[object]) {
            out.verdicts[polygon] = Verdict::Transparent, out.marks[polygon] = 0;
            continue;
        }
        Crossed crossed;
        Verdict verdict = outside(in, in.topology->corners(polygon), crossed);
        std::uint8_t marks = 0;
        if (verdict == Verdict::Kept && !crossed.any) marks |= CullMark::kInside;
        if (verdict == Verdict::Kept) {
            const ScreenArea screen = screenArea(in, polygon, !crossed.any);
            const bool isBack = screen.signedArea < 0;
            if (isBack) marks |= CullMark::kBack;
            if (!screen.covers)
                verdict = Verdict::Degenerate;
            else if (isBack && inputs.mode == CullMode::Back)
                verdict = Verdict::BackFacing;
            else if (crossed.depth)
                verdict = Verdict::Clipped;
        }
        out.verdicts[polygon] = verdict;
        out.marks[polygon] = marks;
    }
}

template <class Real>
std::optional<double> signedArea(const TransformOutput<Real>& in, const CullOutput& cull, std::size_t polygon) {
    const Verdict verdict = cull.verdicts[polygon];
    if (!goesOn(verdict) && verdict != Verdict::BackFacing && verdict != Verdict::Degenerate) return {};
    return screenArea(in, polygon, (cull.marks[polygon] & CullMark::kInside) != 0).signedArea;
}

namespace {

// A planted defect may call an area above 0 back-facing.
std::string areaReason(double area) {
    return fmt::format("back-facing, signed area {}{:.1f} px²", area < 0 ? "−" : "", std::abs(area));
}

}  // namespace

template <class Real>
std::string reason(const TransformOutput<Real>& in, const CullOutput& cull, std::size_t polygon) {
    const Verdict verdict = cull.verdicts[polygon];
    if (verdict == Verdict::BackFacing) return areaReason(*signedArea(in, cull, polygon));
    if (verdict == Verdict::Degenerate) return "degenerate, area 0 after snapping";
    return std::string(name(verdict));
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                            \
    template void cull(const CullInputs&, const TransformOutput<Real>&, std::size_t, std::size_t, CullOutput&); \
    template std::optional<double> signedArea(const TransformOutput<Real>&, const CullOutput&, std::size_t);    \
    template std::string reason(const TransformOutput<Real>&, const CullOutput&, std::size_t);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
