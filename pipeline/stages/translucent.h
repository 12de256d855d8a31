#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/stages/shading.h"

namespace pipeline {

// The translucent part of stage 6: polygons with an opacity below 1 are drawn after the opaque ones. A fragment that
// is nearer than the opaque depth is a layer; it writes no depth. A pixel's layers are laid over its opaque intensity
// I, each with its own intensity and opacity a, from the farthest to the nearest: C = a I_layer + (1 - a) C.
// T. Porter and T. Duff, "Compositing digital images", SIGGRAPH 1984.

enum class Pass : std::uint8_t { Opaque, Translucent };
// Per polygon 0 where a pass does not draw it; empty when it draws all. transparent, sides: per object, or empty.
// cull tells which side shows; null: the front.
std::vector<std::uint8_t> drawnIn(Pass pass, const Topology& topology, std::span<const std::uint8_t> transparent,
                                  std::span<const TranslucentSides> sides, const CullOutput* cull);

// The world as lights see it: without the objects that are wholly transparent. Topology and world alone are filled in.
template <class Real>
TransformOutput<Real> withoutTransparent(const TransformOutput<Real>& in);

template <class Real>
struct Layer {
    std::uint32_t triangle;
    glm::ivec2 pixel;
    double depth;  // larger is farther: -1 / z_view in perspective, z_view in orthographic projection
    Real zView;    // world units
    Vec3<Real> barycentric;
};

// The translucent triangles, and per tile their order of drawing: by number, which decides ties (exact), or by the
// mean z_view of their polygons, the farthest first (polygons).
template <class Real>
struct LayerBins {
    TriangleBins<Real> bins;
    std::vector<std::vector<std::uint32_t>> order;  // per tile: indices into bins.triangles
    bool sorts = true;                              // layers by depth, at every pixel
};
template <class Real>
LayerBins<Real> binLayers(const ShadingInputs& inputs, const ShadingSources<Real>& in);

// The layers of a tile's pixels; those of one pixel side by side, in the order in which they are laid over it. `order` holds
// indices into layers.bins.triangles. Nothing when there are more than `limit`.
template <class Real>
std::optional<std::vector<Layer<Real>>> layersIn(const ShadingInputs& inputs, const ShadingSources<Real>& in,
                                                 const LayerBins<Real>& layers, std::span<const std::uint32_t> order,
                                                 Tile tile, std::size_t limit);

// Layers that one task holds at a time. A tile with more is cut in halves, down to a single pixel: memory is bounded
// by this, or by the layers of one pixel where those are more.
inline constexpr std::size_t kLayersAtOnce = 1 << 18;

template <class Real>
Vec3<Real> layerIntensity(const ShadingInputs& inputs, const ShadingSources<Real>& in, const ShadingOutput<Real>& out,
                          const Layer<Real>& layer, ShadingScratch<Real>& scratch, ShadingCounts& counts) {
    return surfaceIntensity(inputs, in, out, layer.triangle, layer.barycentric, layer.pixel, scratch, counts);
}
// The intensity of each layer of a tile, as layersIn gives them.
template <class Real>
void shadeLayers(const ShadingInputs& inputs, const ShadingSources<Real>& in, Tile tile,
                 std::span<const Layer<Real>> layers, ShadingOutput<Real>& out, std::span<Vec3<Real>> intensities,
                 ShadingCounts& counts);
template <class Real>
using ShadeLayers = decltype(&shadeLayers<Real>);

// Lays the layers of tile `tile` over what shadePixels has left in `out`. Returns what it did, for `counts`.
template <class Real>
ShadingCounts drawLayers(const ShadingInputs& inputs, const ShadingSources<Real>& in, const LayerBins<Real>& layers,
                         std::size_t tile, ShadingOutput<Real>& out, ShadeLayers<Real> shade = &shadeLayers<Real>,
                         std::size_t limit = kLayersAtOnce);

}  // namespace pipeline
