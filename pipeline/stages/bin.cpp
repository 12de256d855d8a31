#include "pipeline/stages/bin.h"

#include <algorithm>

namespace pipeline {

template <class Real>
TriangleBins<Real> binTriangles(const Topology& topology, const View& view, std::span<const Vec3<Real>> world,
                                std::span<const Verdict> verdicts, std::span<const std::uint8_t> marks,
                                std::span<const std::uint8_t> drawn, const FacingFilter& facing, TriangleRange range) {
    TriangleBins<Real> out;
    out.size = view.size;
    out.tiles = (view.size + kTileSize - 1) / kTileSize;
    out.bins.resize(std::size_t(out.tiles.x) * std::size_t(out.tiles.y));
    const auto addToBins = [&](const RasterTriangle<Real>& triangle) {
        const Tile box = triangle.snapped.pixels();
        const glm::ivec2 low = glm::max(box.min, glm::ivec2(0)), high = glm::min(box.max, out.size);
        if (low.x >= high.x || low.y >= high.y) return;
        const auto index = std::uint32_t(out.triangles.size());
        out.triangles.push_back(triangle);
        for (int y = low.y / kTileSize; y <= (high.y - 1) / kTileSize; ++y)
            for (int x = low.x / kTileSize; x <= (high.x - 1) / kTileSize; ++x)
                out.bins[std::size_t(y) * std::size_t(out.tiles.x) + std::size_t(x)].push_back(index);
    };
    std::vector<RasterTriangle<Real>> parts;  // of one that is clipped
    for (std::size_t t = range.first; t < std::min(range.last, topology.triangles.size()); ++t) {
        const std::uint32_t polygon = topology.polygonOf(t);
        if (!verdicts.empty() && !goesOn(verdicts[polygon])) continue;
        if (!drawn.empty() && !drawn[polygon]) continue;
        const auto& v = topology.triangles[t].vertices;
        const bool whole = !marks.empty() && (marks[polygon] & CullMark::kInside) != 0;
        ++(whole ? out.unclipped : out.clipped);
        parts.clear();
        const std::int64_t area2 = setUpTriangle<Real>(
            view, {toView(view, world[v[0]]), toView(view, world[v[1]]), toView(view, world[v[2]])}, std::uint32_t(t),
            [&](const RasterTriangle<Real>& part) { parts.push_back(part); }, whole);
        if (facing.keeps(area2, topology.objectOfPolygon(polygon))) std::ranges::for_each(parts, addToBins);
    }
    return out;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                    \
    template TriangleBins<Real> binTriangles(const Topology&, const View&, std::span<const Vec3<Real>>, \
                                             std::span<const Verdict>, std::span<const std::uint8_t>,   \
                                             std::span<const std::uint8_t>, const FacingFilter&, TriangleRange);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
