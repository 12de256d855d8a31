#include "pipeline/simd/shade_pixels.h"

#include <algorithm>
#include <cstring>
#include <memory>

#include "pipeline/simd/peels.h"
#include "pipeline/simd/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/simd/shade_pixels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
//
#include "pipeline/simd/tile_shader.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {
namespace {

template <class A>
ShadingCounts shadeTile(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                        ShadingOutput<float>& out) {
    TileShader<A> shader(inputs, in, tile, out);
    const ToBytes bytes(out.iMax);
    shader.shade([&](int y, const ShadedRow& row, std::uint32_t blocks) HWY_ATTR {
        const auto pixelsAt = [&](std::size_t i) HWY_ATTR { return row.surface.seenAt(i); };
        putRow<A>(row.intensity, blocks, pixelsAt, bytes, tile, y, out);
    });
    return shader.counts();
}

// Shades layers as pictures of a tile: the farthest layer of each pixel, then the next farthest, and so on.
template <class A>
void shadeLayers(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                 std::span<const Layer<float>> layers, ShadingOutput<float>& out, std::span<Vec3<float>> intensities,
                 ShadingCounts& counts) {
    // A picture with fewer layers costs more than shading them one by one.
    constexpr std::size_t kLeast = 64;
    const Peels peels(layers);
    auto drawn = std::make_unique_for_overwrite<DrawnTile>();
    TileShader<A> shader(inputs, in, tile, out, drawn.get());
    ShadingScratch<float> scratch(inputs);
    for (std::size_t k = 0; k < peels.count(); ++k) {
        const std::span<const std::uint32_t> peel = peels.of(k);
        if (peel.size() < kLeast) {
            for (const std::uint32_t i : peel)
                intensities[i] = layerIntensity(inputs, in, out, layers[i], scratch, counts);
            continue;
        }
        std::ranges::fill(drawn->triangle, kNoTriangle);
        std::uint32_t at[kTilePixels];
        for (const std::uint32_t i : peel) {
            const std::size_t place = placeOf(layers[i].pixel - tile.min);
            drawn->triangle[place] = layers[i].triangle, at[place] = i;
            for (int c = 0; c < 2; ++c) drawn->weights[c][place] = layers[i].barycentric[c + 1];
        }
        shader.shade([&](int y, const ShadedRow& row, std::uint32_t) HWY_ATTR {
            const std::size_t first = std::size_t(y) * kRowPixels;
            for (std::size_t i = 0; i < kRowPixels; ++i)
                if (drawn->triangle[first + i] != kNoTriangle)
                    intensities[at[first + i]] = {row.intensity.x.of[i], row.intensity.y.of[i], row.intensity.z.of[i]};
        });
    }
    counts += shader.counts();
}

}  // namespace

ShadingCounts shadeTileInVectors(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                                 ShadingOutput<float>& out) {
    return inputs.parts[Part::FastVectors] ? shadeTile<Fast>(inputs, in, tile, out)
                                           : shadeTile<Exact>(inputs, in, tile, out);
}

void shadeLayersInVectorsHere(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                              std::span<const Layer<float>> layers, ShadingOutput<float>& out,
                              std::span<Vec3<float>> intensities, ShadingCounts& counts) {
    const auto shade = inputs.parts[Part::FastVectors] ? shadeLayers<Fast> : shadeLayers<Exact>;
    shade(inputs, in, tile, layers, out, intensities, counts);
}

int lanesHere() { return int(hn::Lanes(F())); }

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(shadeTileInVectors);
HWY_EXPORT(shadeLayersInVectorsHere);
HWY_EXPORT(lanesHere);

void leaveTileDark(Tile tile, ShadingOutput<float>& out) {
    for (int y = tile.min.y; y < tile.max.y; ++y) {
        const std::size_t at = out.color.offset({tile.min.x, y});
        std::memset(&out.color.pixels[at], 0, std::size_t(tile.max.x - tile.min.x) * sizeof(Color8));
        for (auto& intensity : out.vectors[index(BufferId::Intensity)])
            std::fill_n(&intensity.pixels[at], tile.max.x - tile.min.x, Vec3<float>(0));
    }
}

ShadingCounts shadePixelsInVectors(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                                   ShadingOutput<float>& out) {
    return HWY_DYNAMIC_DISPATCH(shadeTileInVectors)(inputs, in, tile, out);
}

void shadeLayersInVectors(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                          std::span<const Layer<float>> layers, ShadingOutput<float>& out,
                          std::span<Vec3<float>> intensities, ShadingCounts& counts) {
    HWY_DYNAMIC_DISPATCH(shadeLayersInVectorsHere)(inputs, in, tile, layers, out, intensities, counts);
}

int vectorLanes() { return HWY_DYNAMIC_DISPATCH(lanesHere)(); }

}  // namespace pipeline
#endif
