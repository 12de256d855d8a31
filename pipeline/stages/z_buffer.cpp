#include "pipeline/stages/z_buffer.h"

#include "pipeline/defects/drawing_hooks.h"

namespace pipeline {

template <class Real>
Vec3<Real> barycentricAt(const TransformOutput<Real>& in, std::uint32_t triangle, glm::ivec2 pixel) {
    const auto& v = in.topology->triangles[triangle].vertices;
    Vec3<Real> weights(0);
    // Of the pieces that clipping leaves, one covers the pixel.
    const auto look = [&](const RasterTriangle<Real>& piece) {
        forEachCovered(piece.snapped, {pixel, pixel + 1}, [&](glm::ivec2, const std::array<std::int64_t, 3>& e) {
            weights = interpolate(piece, pixel, e, in.view.perspective).barycentric;
        });
    };
    setUpTriangle<Real>(in.view, {in.viewSpace(v[0]), in.viewSpace(v[1]), in.viewSpace(v[2])}, triangle, look);
    return weights;
}

template <class Real>
void zBuffer(const View& view, DepthFormat format, const TriangleBins<Real>& bins, std::span<const std::uint32_t> order,
             Tile tile, ZBufferOutput<Real>& out, std::vector<FragmentRecord>* record) {
    const DepthCode code(view, format);
    const bool linear = format == DepthFormat::Linear;
    for (const std::uint32_t i : order) {
        const RasterTriangle<Real>& triangle = bins.triangles[i];
        const auto draw = [&](glm::ivec2 pixel, const std::array<std::int64_t, 3>& e) {
            const std::size_t at = out.zView->offset(pixel - out.origin);
            Fragment<Real> fragment = interpolate(triangle, pixel, e, view.perspective);
            double depth = double(fragment.z);
            if (!linear) {
                const auto w = interpolateW(triangle, e);
                depth = code.encode(w, w);  // reads the one that w is
            }
            const double stored = linear ? double(out.zView->pixels[at]) : out.depth.pixels[at];
            // What is there is nearer than nothing: in the far plane a reversed depth is the cleared 0 itself.
            const bool first = out.triangle->pixels[at] == kNoTriangle;
            bool won = linear ? fragment.z < out.zView->pixels[at] : first || code.nearer(depth, stored);
            if (out.planted) spoilTest(code, triangle, e, out, at, fragment, depth, won);
            if (record) record->push_back({triangle.id, pixel, depth, stored, won});
            ++out.overdraw.pixels[at];
            if (!won) return;
            if (!linear) out.depth.pixels[at] = depth;
            writeFragment(out, at, triangle.id, fragment);
            if (out.planted) spoilWritten(code, out, at);
        };
        bool isDrawn = false;
        if (out.planted) spoilCoverage(out.planted, view, triangle, tile, draw, isDrawn);
        if (!isDrawn) forEachCovered(triangle.snapped, tile, draw);
    }
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                 \
    template Vec3<Real> barycentricAt(const TransformOutput<Real>&, std::uint32_t, glm::ivec2);                      \
    template void zBuffer(const View&, DepthFormat, const TriangleBins<Real>&, std::span<const std::uint32_t>, Tile, \
                          ZBufferOutput<Real>&, std::vector<FragmentRecord>*);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
