#include "pipeline/inspect/edge_view.h"

#include "pipeline/run/frame_data.h"
#include "pipeline/stages/rasterize.h"

namespace pipeline {

static_assert(kEdgeUnits == kSubPixels);

namespace {

EdgeFunction edgeFunction(const EdgeView& view, int edge) {
    const auto ends = edgeEnds(view, edge);
    return {ends[0], ends[1]};
}

template <class Real>
std::optional<EdgeView> viewAt(const FrameData<Real>& data, glm::ivec2 pixel) {
    if (!data.zBuffer || !data.transform) return {};
    const TransformOutput<Real>& in = *data.transform;
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= in.view.size.x || pixel.y >= in.view.size.y) return {};
    const std::uint32_t id = data.zBuffer->triangle->at(pixel);
    if (id == kNoTriangle) return {};
    const auto& v = in.topology->triangles[id].vertices;
    std::optional<EdgeView> found;
    setUpTriangle<Real>(
        in.view, {in.viewSpace(v[0]), in.viewSpace(v[1]), in.viewSpace(v[2])}, id,
        [&](const RasterTriangle<Real>& piece) {
            const EdgeView view{in.topology->polygonOf(id), piece.snapped.corners, piece.snapped.area2()};
            if (!found || edgesAt(view, pixel).covered()) found = view;
        });
    return found;
}

}  // namespace

std::array<glm::i64vec2, 2> edgeEnds(const EdgeView& view, int edge) {
    return {view.corners[std::size_t(edge + 1) % 3], view.corners[std::size_t(edge + 2) % 3]};
}

EdgeSide edgeSide(const EdgeView& view, int edge) {
    const EdgeFunction function = edgeFunction(view, edge);
    if (!function.ownsBoundary()) return EdgeSide::Other;
    return function.dy < 0 ? EdgeSide::Left : EdgeSide::Top;
}

EdgeSample edgesAt(const EdgeView& view, glm::ivec2 pixel) {
    EdgeSample sample;
    for (int i = 0; i < 3; ++i) {
        const EdgeFunction function = edgeFunction(view, i);
        sample.values[std::size_t(i)] = function.atPixel(pixel);
        sample.inside[std::size_t(i)] = function.covers(sample.values[std::size_t(i)]);
    }
    return sample;
}

std::optional<EdgeView> edgeViewAt(const Frame& frame, glm::ivec2 pixel) {
    return readStages(frame, [&](const auto& data) { return viewAt(data, pixel); });
}

}  // namespace pipeline
