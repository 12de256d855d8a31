#include "pipeline/stages/z_buffer.h"

#include <limits>

namespace pipeline {

template <class Real>
ZBufferOutput<Real> prepareZBuffer(Tile extent, DepthFormat format) {
    const glm::ivec2 size = extent.max - extent.min;
    ZBufferOutput<Real> out;
    out.origin = extent.min;
    out.zView = {size, std::numeric_limits<Real>::infinity()};
    if (format != DepthFormat::Linear) out.depth = {size, DepthCode<Real>::cleared(format)};
    out.triangle = {size, kNoTriangle};
    out.barycentric = {size, Vec3<Real>(0)};
    out.overdraw = {size, 0};
    out.depthWrites = {size, 0};
    return out;
}

template <class Real>
void zBuffer(const View& view, DepthFormat format, const TriangleBins<Real>& bins, std::span<const std::uint32_t> order,
             Tile tile, ZBufferOutput<Real>& out, std::vector<FragmentRecord<Real>>* record) {
    const DepthCode<Real> code(view, format);
    Buffer2D<Real>& stored = format == DepthFormat::Linear ? out.zView : out.depth;
    for (const std::uint32_t i : order) {
        const RasterTriangle<Real>& triangle = bins.triangles[i];
        forEachCovered(triangle.snapped, tile, [&](glm::ivec2 pixel, const std::array<std::int64_t, 3>& e) {
            const Fragment<Real> fragment = interpolate(triangle, e, view.perspective);
            const Real depth = code.encode(fragment.z, fragment.inverseZ);
            const std::size_t at = out.zView.offset(pixel - out.origin);
            const bool won = code.nearer(depth, stored.pixels[at]);
            if (record) record->push_back({triangle.id, pixel, depth, stored.pixels[at], won});
            ++out.overdraw.pixels[at];
            if (!won) return;
            stored.pixels[at] = depth;
            out.zView.pixels[at] = fragment.z;
            out.triangle.pixels[at] = triangle.id;
            out.barycentric.pixels[at] = fragment.barycentric;
            ++out.depthWrites.pixels[at];
        });
    }
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                 \
    template ZBufferOutput<Real> prepareZBuffer(Tile, DepthFormat);                                                  \
    template void zBuffer(const View&, DepthFormat, const TriangleBins<Real>&, std::span<const std::uint32_t>, Tile, \
                          ZBufferOutput<Real>&, std::vector<FragmentRecord<Real>>*);
SHADESCOPE_INSTANTIATE(float)
SHADESCOPE_INSTANTIATE(double)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
