#include "pipeline/stages/painter.h"

#include <algorithm>

namespace pipeline {

bool PaintingOrder::has(const PaintPiece& piece, glm::ivec2 pixel) const {
    const glm::dvec2 p = glm::dvec2(pixel) * double(kSubPixels) + double(kSubPixels) / 2;
    return std::ranges::all_of(piece.cuts, [&](const PaintPiece::Cut& cut) {
        return (planes[piece.triangle].at(p) - planes[cut.by].at(p) >= 0) == cut.behind;
    });
}

template <class Real>
PaintingOrder paintingOrder(const Topology& topology, const View& view, std::span<const Vec3<Real>> world,
                            const TriangleBins<Real>& bins, bool split, const Stop& stop) {
    std::vector<PaintTriangle> triangles;
    triangles.reserve(bins.triangles.size());
    for (const RasterTriangle<Real>& t : bins.triangles) {
        PaintTriangle paint{t.snapped, {}, 0, topology.polygonOf(t.id)};
        for (std::size_t i = 0; i < 3; ++i) paint.depth[i] = double(view.perspective ? -t.exactW[i] : t.exactW[i]);
        const Topology::Corners corners = topology.corners(paint.polygon);
        for (std::size_t i = 0; i < corners.size(); ++i) paint.mean += double(toView(view, world[corners[i]]).z);
        paint.mean /= double(corners.size());
        triangles.push_back(paint);
    }
    return paintingOrder(triangles, split, stop);
}

template <class Real>
std::vector<std::vector<std::uint32_t>> binPieces(const TriangleBins<Real>& bins, const PaintingOrder& order) {
    std::vector<std::vector<std::uint32_t>> out(bins.bins.size());
    for (std::uint32_t i = 0; i < order.pieces.size(); ++i) {
        const Tile box = bins.triangles[order.pieces[i].triangle].snapped.pixels();
        const glm::ivec2 low = glm::max(box.min, glm::ivec2(0)), high = glm::min(box.max, bins.size);
        for (int y = low.y / kTileSize; y <= (high.y - 1) / kTileSize; ++y)
            for (int x = low.x / kTileSize; x <= (high.x - 1) / kTileSize; ++x)
                out[std::size_t(y) * std::size_t(bins.tiles.x) + std::size_t(x)].push_back(i);
    }
    return out;
}

template <class Real>
void paint(const View& view, const TriangleBins<Real>& bins, const PaintingOrder& order,
           std::span<const std::uint32_t> pieces, Tile tile, ZBufferOutput<Real>& out,
           std::vector<FragmentRecord>* record) {
    for (const std::uint32_t i : pieces) {
        const PaintPiece& piece = order.pieces[i];
        const RasterTriangle<Real>& triangle = bins.triangles[piece.triangle];
        forEachCovered(triangle.snapped, tile, [&](glm::ivec2 pixel, const std::array<std::int64_t, 3>& e) {
            if (!order.has(piece, pixel)) return;
            const Fragment<Real> fragment = interpolate(triangle, pixel, e, view.perspective);
            const std::size_t at = out.zView->offset(pixel - out.origin);
            if (record)
                record->push_back({triangle.id, pixel, double(fragment.z), double(out.zView->pixels[at]), true});
            ++out.overdraw.pixels[at];
            writeFragment(out, at, triangle.id, fragment);
        });
    }
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                  \
    template PaintingOrder paintingOrder(const Topology&, const View&, std::span<const Vec3<Real>>,                   \
                                         const TriangleBins<Real>&, bool, const Stop&);                               \
    template std::vector<std::vector<std::uint32_t>> binPieces(const TriangleBins<Real>&, const PaintingOrder&);      \
    template void paint(const View&, const TriangleBins<Real>&, const PaintingOrder&, std::span<const std::uint32_t>, \
                        Tile, ZBufferOutput<Real>&, std::vector<FragmentRecord>*);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
