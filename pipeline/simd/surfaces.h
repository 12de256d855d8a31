// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_SURFACES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_SURFACES_H
#undef SHADESCOPE_SURFACES_H
#else
#define SHADESCOPE_SURFACES_H
#endif

#include <array>

#include "pipeline/simd/arithmetic.h"
#include "pipeline/simd/seen.h"
#include "pipeline/stages/shading.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// What is seen in a block. Numbers of pixels in which nothing is seen are any.
struct SurfaceBlock {
    alignas(64) std::uint32_t triangle[kBlockPixels];
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
    template <class A>
    HWY_INLINE Floats3 at(const Floats3& b) const {
        return scaledPlus<A>(all(toThird), b.z, scaledPlus<A>(all(toSecond), b.y, all(origin)));
    }
};

template <class A>
HWY_INLINE void findSurfaces(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                             TileSurfaces& out) {
    const ZBufferOutput<float>& z = in.zBuffer;
    const Topology& topology = *in.transform.topology;
    constexpr std::size_t kStride = sizeof(SurfaceBlock) / sizeof(float);
    readRows(z.triangle, tile, kNoTriangle, out[0].triangle, kStride);
    for (SurfaceBlock& block : out) std::fill_n(block.polygon, kBlockPixels, 0);
    const bool perPixel = inputs.shading == Shading::Phong, position = inputs.parts.position;
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
            store(normals.at<A>(b), mask, block.normal, first);
        else
            store(b, mask, block.weights, first);
        if (position) store(positions.at<A>(b), mask, block.position, first);
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

// Numbers of the pixels in `mask` into a buffer: of the vector at `at` of the tile whose first pixel is `origin`.
template <class Vectors, class Number, class Pixel>
HWY_INLINE void putPixels(const Vectors& x, const Vectors& y, const Vectors& z, const hn::Rebind<Number, F> d,
                          Mask mask, std::size_t at, glm::ivec2 origin, Buffer2D<Pixel>& out) {
    static_assert(sizeof(Pixel) == 3 * sizeof(Number));
    if (hn::AllTrue(F(), mask)) {
        constexpr std::size_t kRow = std::min<std::size_t>(kBlock, HWY_LANES(float) < kBlock ? 1 : kBlock);
        HWY_ALIGN Number numbers[3 * 16];
        hn::StoreInterleaved3(x, y, z, d, numbers);
        for (std::size_t l = 0; l < hn::Lanes(d); l += kRow)
            std::memcpy(&out.at(origin + pixelOf(at + l)), numbers + 3 * l, kRow * sizeof(Pixel));
        return;
    }
    HWY_ALIGN Number one[16], two[16], three[16];
    hn::Store(x, d, one), hn::Store(y, d, two), hn::Store(z, d, three);
    for (std::uint32_t bits = bitsOf(mask); bits != 0; bits &= bits - 1) {
        const auto l = std::size_t(std::countr_zero(bits));
        out.at(origin + pixelOf(at + l)) = {one[l], two[l], three[l]};
    }
}
HWY_INLINE void putPixels(Floats value, Mask mask, std::size_t at, glm::ivec2 origin, Buffer2D<float>& out) {
    HWY_ALIGN float numbers[16];
    hn::Store(value, F(), numbers);
    for (std::uint32_t bits = bitsOf(mask); bits != 0; bits &= bits - 1) {
        const auto l = std::size_t(std::countr_zero(bits));
        out.at(origin + pixelOf(at + l)) = numbers[l];
    }
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
