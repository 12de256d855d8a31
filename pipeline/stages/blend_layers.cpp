// The half of the translucent part that shades layers and blends them.
#include <limits>

#include "pipeline/stages/translucent.h"

namespace pipeline {

template <class Real>
void shadeLayers(const ShadingInputs& inputs, const ShadingSources<Real>& in, Tile, std::span<const Layer<Real>> layers,
                 ShadingOutput<Real>& out, std::span<Vec3<Real>> intensities, ShadingCounts& counts) {
    ShadingScratch<Real> scratch(inputs);
    for (std::size_t i = 0; i < layers.size(); ++i)
        intensities[i] = layerIntensity(inputs, in, out, layers[i], scratch, counts);
}

namespace {

// What the layers of a tile's pixels come to.
template <class Real>
struct Composed {
    glm::ivec2 origin;
    Buffer2D<Vec3<Real>> added;
    Buffer2D<Real> left;
    Buffer2D<std::int32_t> count;
};

template <class Real>
Composed<Real> compose(const ShadingInputs& inputs, const ShadingSources<Real>& in, Tile tile,
                       std::span<const Layer<Real>> layers, std::span<const Vec3<Real>> intensities) {
    const Topology& topology = *in.transform.topology;
    const glm::ivec2 size = tile.max - tile.min;
    Composed<Real> c{tile.min, {size, Vec3<Real>(0)}, {size, Real(1)}, {size, 0}};
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const Layer<Real>& layer = layers[i];
        const std::uint32_t polygon = topology.polygonOf(layer.triangle);
        const Real a =
            Real(opacity(materialOf(inputs, topology.objectOfPolygon(polygon), showsBack(inputs, in, polygon))));
        const std::size_t at = c.count.offset(layer.pixel - tile.min);
        c.added.pixels[at] = a * intensities[i] + (1 - a) * c.added.pixels[at];
        c.left.pixels[at] = (1 - a) * c.left.pixels[at];
        ++c.count.pixels[at];
    }
    return c;
}

template <class Real>
void layOver(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::span<const Layer<Real>> layers,
             std::span<const Vec3<Real>> lit, const Composed<Real>& c, ShadingOutput<Real>& out) {
    auto& intensities = out.vectors[index(BufferId::Intensity)][0];
    auto& added = out.vectors[index(BufferId::Translucent)];
    auto& left = out.scalars[index(BufferId::Transmittance)];
    for (int y = 0; y < c.count.size.y; ++y)
        for (int x = 0; x < c.count.size.x; ++x) {
            const std::size_t from = c.count.offset({x, y});
            if (c.count.pixels[from] == 0) continue;
            const std::size_t at = intensities.offset(c.origin + glm::ivec2(x, y));
            Vec3<Real>& intensity = intensities.pixels[at];
            const Vec3<Real> behind = intensity;
            intensity = c.left.pixels[from] * intensity + c.added.pixels[from];
            if (inputs.planted) spoilBlended(inputs, in, layers, lit, c.origin + glm::ivec2(x, y), behind, intensity);
            storeFrameBufferValue(Vec3d(intensity), out.iMax, inputs.planted, out.color.pixels[at]);
            if (!added.empty()) added[0].pixels[at] = c.added.pixels[from];
            if (!left.empty()) left[0].pixels[at] = c.left.pixels[from];
            if (!out.layers.empty()) out.layers.pixels[at] = c.count.pixels[from];
        }
}

template <class Real>
void drawTile(const ShadingInputs& inputs, const ShadingSources<Real>& in, const LayerBins<Real>& layers,
              std::span<const std::uint32_t> order, Tile tile, ShadingOutput<Real>& out, ShadeLayers<Real> shade,
              std::size_t limit, ShadingCounts& counts) {
    const glm::ivec2 size = tile.max - tile.min;
    const bool single = size.x * size.y == 1;
    const auto found =
        layersIn(inputs, in, layers, order, tile, single ? std::numeric_limits<std::size_t>::max() : limit);
    if (found) {
        counts.layers += static_cast<long long>(found->size());
        if (found->empty()) return;
        std::vector<Vec3<Real>> intensities(found->size());
        shade(inputs, in, tile, *found, out, intensities, counts);
        layOver<Real>(inputs, in, *found, intensities, compose<Real>(inputs, in, tile, *found, intensities), out);
        return;
    }
    Tile first = tile, second = tile;
    const int axis = size.y > 1 ? 1 : 0;
    first.max[axis] = second.min[axis] = tile.min[axis] + size[axis] / 2;
    drawTile(inputs, in, layers, order, first, out, shade, limit, counts);
    drawTile(inputs, in, layers, order, second, out, shade, limit, counts);
}

}  // namespace

template <class Real>
ShadingCounts drawLayers(const ShadingInputs& inputs, const ShadingSources<Real>& in, const LayerBins<Real>& layers,
                         std::size_t tile, ShadingOutput<Real>& out, ShadeLayers<Real> shade, std::size_t limit) {
    ShadingCounts counts;
    drawTile<Real>(inputs, in, layers, layers.order[tile], layers.bins.tile(tile), out, shade, limit, counts);
    return counts;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                 \
    template void shadeLayers(const ShadingInputs&, const ShadingSources<Real>&, Tile, std::span<const Layer<Real>>, \
                              ShadingOutput<Real>&, std::span<Vec3<Real>>, ShadingCounts&);                          \
    template ShadingCounts drawLayers(const ShadingInputs&, const ShadingSources<Real>&, const LayerBins<Real>&,     \
                                      std::size_t, ShadingOutput<Real>&, ShadeLayers<Real>, std::size_t);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
