// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_SURFACES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_SURFACES_H
#undef SHADESCOPE_SURFACES_H
#else
#define SHADESCOPE_SURFACES_H
#endif

#include <array>

#include "pipeline/fast/seen.h"
#include "pipeline/stages/shading.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// What is seen in a block. Numbers of pixels in which nothing is seen are any.
struct SurfaceBlock {
    alignas(64) std::uint32_t triangle[kBlockPixels];
    float zView[kBlockPixels];
    std::int32_t polygon[kBlockPixels];
    float normal[3][kBlockPixels];    // of Phong shading, not unit
    float position[3][kBlockPixels];  // where it is interpolated
    float weights[3][kBlockPixels];   // of flat and Gouraud shading
};
using TileSurfaces = std::array<SurfaceBlock, kBlocks>;

// Whole vectors are stored: see rasterize.cpp.
HWY_INLINE void store(Floats3 v, Mask mask, float (&to)[3][kBlockPixels], std::size_t first) {
    hn::Store(hn::IfThenElse(mask, v.x, hn::Load(F(), &to[0][first])), F(), &to[0][first]);
    hn::Store(hn::IfThenElse(mask, v.y, hn::Load(F(), &to[1][first])), F(), &to[1][first]);
    hn::Store(hn::IfThenElse(mask, v.z, hn::Load(F(), &to[2][first])), F(), &to[2][first]);
}
HWY_INLINE Floats3 load(const float (&from)[3][kBlockPixels], std::size_t first) {
    return {hn::Load(F(), &from[0][first]), hn::Load(F(), &from[1][first]), hn::Load(F(), &from[2][first])};
}

// A quantity of a triangle's corners, to be interpolated.
struct Corners {
    Vec3<float> origin{0}, toSecond{0}, toThird{0};
    void become(const std::vector<Vec3<float>>& values, const std::uint32_t (&v)[3]) {
        origin = values[v[0]], toSecond = values[v[1]] - origin, toThird = values[v[2]] - origin;
    }
    HWY_INLINE Floats3 at(const Floats3& b) const {
        return scaledPlus(all(toThird), b.z, scaledPlus(all(toSecond), b.y, all(origin)));
    }
};

// position: whether positions are interpolated over the triangles.
HWY_INLINE void findSurfaces(const ShadingInputs& inputs, const ShadingSources<float>& in, bool position, Tile tile,
                             TileSurfaces& out) {
    const ZBufferOutput<float>& z = in.zBuffer;
    const Topology& topology = *in.transform.topology;
    constexpr std::size_t kStride = sizeof(SurfaceBlock) / sizeof(float);
    readRows(z.triangle, tile, kNoTriangle, out[0].triangle, kStride);
    readRows(z.zView, tile, 1.0F, out[0].zView, kStride);
    for (SurfaceBlock& block : out) std::fill_n(block.polygon, kBlockPixels, 0);
    const bool perPixel = inputs.shading == Shading::Phong;
    Corners normals, positions;
    Ints polygon = hn::Zero(I());
    const auto begin = [&](std::uint32_t id) HWY_ATTR {
        const Triangle& triangle = topology.triangles[id];
        polygon = hn::Set(I(), std::int32_t(triangle.polygon));
        if (perPixel) normals.become(in.normals.vertex, triangle.vertices);
        if (position) positions.become(in.transform.world, triangle.vertices);
    };
    const auto visit = [&](std::size_t at, Mask mask, const Floats3& b) HWY_ATTR {
        SurfaceBlock& block = out[at / kBlockPixels];
        const std::size_t first = at % kBlockPixels;
        const Ints before = hn::Load(I(), &block.polygon[first]);
        hn::Store(hn::IfThenElse(hn::RebindMask(I(), mask), polygon, before), I(), &block.polygon[first]);
        if (perPixel)
            store(normals.at(b), mask, block.normal, first);
        else
            store(b, mask, block.weights, first);
        if (position) store(positions.at(b), mask, block.position, first);
    };
    if (z.pieces) {
        const int columns = z.pieces->tiles.x;
        const int index = tile.min.y / kTileSize * columns + tile.min.x / kTileSize;
        return forEachSeen(in.transform.view, *z.pieces, std::size_t(index), out[0].triangle, kStride, begin, visit);
    }
    // Drawn by the stage's own text, which keeps the weights.
    const std::size_t lanes = hn::Lanes(F());
    for (std::size_t place = 0; place < kTilePixels; ++place) {
        const std::uint32_t id = out[place / kBlockPixels].triangle[place % kBlockPixels];
        if (id == kNoTriangle) continue;
        const std::size_t at = place / lanes * lanes;
        begin(id);
        const auto here = hn::Eq(hn::Iota(I(), std::int32_t(at)), hn::Set(I(), std::int32_t(place)));
        visit(at, hn::RebindMask(F(), here), all(z.barycentric.at(tile.min + pixelOf(place))));
    }
}

// What a tile's pixels become, row by row; a channel after the other.
struct TileColors {
    alignas(64) float intensity[3][kTilePixels];
    alignas(64) std::uint8_t color[3][kTilePixels];
    TileColors() {
        for (int c = 0; c < 3; ++c) {
            std::fill_n(intensity[c], kTilePixels, 0.0F);
            std::fill_n(color[c], kTilePixels, std::uint8_t(0));
        }
    }
};

// A vector of blocks into the rows it stands in.
template <class T>
HWY_INLINE void putInRows(const T* vector, std::size_t at, T* rows) {
    const glm::ivec2 first = pixelOf(at);
    constexpr int kRow = std::min(kBlock, HWY_LANES(float) < kBlock ? 1 : kBlock);
    for (int l = 0; l < int(hn::Lanes(F())); l += kRow)
        std::memcpy(rows + (first.y + l / kBlock) * kTileSize + first.x + l % kBlock, vector + l, kRow * sizeof(T));
}

// Numbers a channel after the other, into pixels.
template <class T, class Pixel>
HWY_INLINE void writePixels(const T (&rows)[3][kTilePixels], Tile tile, Buffer2D<Pixel>& out) {
    const hn::CappedTag<T, 16> d;
    const int width = tile.max.x - tile.min.x, lanes = int(hn::Lanes(d));
    for (int y = 0; y < tile.max.y - tile.min.y; ++y) {
        Pixel* to = &out.at({tile.min.x, tile.min.y + y});
        const int row = y * kTileSize;
        int x = 0;
        for (; x + lanes <= width; x += lanes)
            hn::StoreInterleaved3(hn::Load(d, &rows[0][row + x]), hn::Load(d, &rows[1][row + x]),
                                  hn::Load(d, &rows[2][row + x]), d, &to[x].x);
        for (; x < width; ++x) to[x] = {rows[0][row + x], rows[1][row + x], rows[2][row + x]};
    }
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
