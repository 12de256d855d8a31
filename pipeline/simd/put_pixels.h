// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_PUT_PIXELS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_PUT_PIXELS_H
#undef SHADESCOPE_PUT_PIXELS_H
#else
#define SHADESCOPE_PUT_PIXELS_H
#endif

#include <bit>
#include <cstring>

#include "pipeline/core/power.h"
#include "pipeline/simd/arithmetic.h"
#include "pipeline/simd/blocks.h"
#include "pipeline/simd/surfaces.h"
#include "pipeline/stages/shading.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// Numbers of the pixels in `mask` into a buffer: of the vector at `at` of the tile whose first pixel is `origin`.
HWY_INLINE void putPixels(Floats3 v, Mask mask, std::size_t at, glm::ivec2 origin, Buffer2D<Vec3<float>>& out) {
    if (hn::AllTrue(F(), mask)) {
        constexpr std::size_t kRow = std::min<std::size_t>(kBlock, HWY_LANES(float) < kBlock ? 1 : kBlock);
        HWY_ALIGN float numbers[3 * 16];
        hn::StoreInterleaved3(v.x, v.y, v.z, F(), numbers);
        for (std::size_t l = 0; l < hn::Lanes(F()); l += kRow)
            std::memcpy(&out.at(origin + pixelOf(at + l)), numbers + 3 * l, kRow * sizeof(Vec3<float>));
        return;
    }
    HWY_ALIGN float one[16], two[16], three[16];
    hn::Store(v.x, F(), one), hn::Store(v.y, F(), two), hn::Store(v.z, F(), three);
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

// The colors of a row of blocks: four rows of a tile's pixels. 0 where none is put.
class ColorRows {
public:
    // isFull: every block is put.
    HWY_INLINE explicit ColorRows(bool isFull) {
        if (!isFull) std::memset(m_rows, 0, sizeof m_rows);
    }
    // Channels in the lowest bytes of each, of the vector at `at` of the row of blocks.
    HWY_INLINE void put(Ints colors, std::size_t at) {
#if HWY_TARGET == HWY_SCALAR
        const std::int32_t color = hn::GetLane(colors);
        std::memcpy(place(at), &color, sizeof(Color8));
#else
        // Rows of 4 pixels, of whose 4 bytes each 3 are kept, and 0 where the next block begins, which is put later.
        constexpr hn::Repartition<std::uint8_t, I> bytes;
        alignas(16) static constexpr std::uint8_t kKept[16]{0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 3, 7, 11, 15};
        const auto packed = hn::TableLookupBytes(hn::BitCast(bytes, colors), hn::LoadDup128(bytes, kKept));
        HWY_ALIGN std::uint8_t rows[64];
        hn::Store(packed, bytes, rows);
        std::uint8_t* const to = place(at);
        for (std::size_t l = 0; l < hn::Lanes(F()); l += kBlock)
            std::memcpy(to + l / kBlock * sizeof m_rows[0], rows + 4 * l, 16);
#endif
    }
    // y: the first row's, in the tile.
    void copyTo(Tile tile, int y, Buffer2D<Color8>& out) const {
        const glm::ivec2 size = tile.max - tile.min;
        for (int row = 0; row < std::min(kBlock, size.y - y); ++row)
            std::memcpy(&out.at(tile.min + glm::ivec2(0, y + row)), m_rows[row], std::size_t(size.x) * sizeof(Color8));
    }

private:
    HWY_INLINE std::uint8_t* place(std::size_t at) {
        const std::size_t block = at / kBlockPixels, pixel = at % kBlockPixels;
        return m_rows[pixel / kBlock] + (block * kBlock + pixel % kBlock) * sizeof(Color8);
    }
    static_assert(sizeof(Color8) == 3);
    std::uint8_t m_rows[kBlock][kTileSize * sizeof(Color8) + 16];
};

// frameBufferValue of channels. In exact arithmetic its bits: what it rounds is estimated in float first, and computed
// in double where the estimate is too near to a step for its error.
class ToBytes {
public:
    explicit ToBytes(double iMax) : m_iMax(iMax), m_factor(iMax > 0 ? float(255 / iMax) : 0) {
        m_estimates = m_factor > 0x1p-100F && m_factor < 0x1p100F;
    }
    // Red in the lowest byte, then green and blue; 0 in the highest.
    template <class A>
    HWY_INLINE Ints of(Floats3 intensity) const {
        const Floats red = scaledUp(intensity.x), green = scaledUp(intensity.y), blue = scaledUp(intensity.z);
        const Floats wholeRed = hn::Add(red, all(kToWhole)), wholeGreen = hn::Add(green, all(kToWhole));
        const Floats wholeBlue = hn::Add(blue, all(kToWhole));
        if constexpr (A::kExact) {
            // Two roundings of the share: 255 (2^-23) < 2^-15.
            const auto rest = [](Floats value, Floats whole)
                                  HWY_ATTR { return hn::Abs(hn::Sub(value, hn::Sub(whole, all(kToWhole)))); };
            const Floats most = hn::Max(hn::Max(rest(red, wholeRed), rest(green, wholeGreen)), rest(blue, wholeBlue));
            const bool sure = hn::AllTrue(F(), hn::Lt(most, all(0.5F - 0x1p-14F)));
            if (HWY_UNLIKELY(!m_estimates || !sure))
                return packed(inDouble(intensity.x), inDouble(intensity.y), inDouble(intensity.z));
        }
        return packed(hn::BitCast(I(), wholeRed), hn::BitCast(I(), wholeGreen), hn::BitCast(I(), wholeBlue));
    }

private:
    HWY_INLINE Floats scaledUp(Floats intensity) const {
        const Floats value = hn::Mul(intensity, all(m_factor));
        return hn::IfThenElseZero(hn::Gt(value, all(0)), hn::Min(value, all(255)));
    }
    // Each in its lowest byte; those above of blue are 0 up to where they are shifted away.
    HWY_INLINE static Ints packed(Ints r, Ints g, Ints b) {
        const Ints low = hn::Set(I(), 255);
        return hn::Or(hn::And(r, low), hn::Or(hn::ShiftLeft<8>(hn::And(g, low)), hn::ShiftLeft<16>(b)));
    }
    HWY_NOINLINE Ints inDouble(Floats intensity) const {
#if HWY_TARGET == HWY_SCALAR
        return hn::Set(I(), frameBufferValue(Vec3d(double(hn::GetLane(intensity))), m_iMax).x);
#else
        if (!(m_iMax > 0)) return hn::Zero(I());
        const hn::Half<F> half;
        const hn::Rebind<double, hn::Half<F>> d;
        const auto rounded = [&](auto some) HWY_ATTR {
            const auto share = hn::Div(hn::PromoteTo(d, some), hn::Set(d, m_iMax));
            const auto value = hn::Add(hn::Mul(share, hn::Set(d, 255)), hn::Set(d, 0.5));
            const auto clamped = hn::IfThenElseZero(hn::Gt(share, hn::Zero(d)), hn::Min(value, hn::Set(d, 255.5)));
            return hn::DemoteTo(hn::Rebind<std::int32_t, decltype(d)>(), clamped);
        };
        const auto low = rounded(hn::LowerHalf(half, intensity)), high = rounded(hn::UpperHalf(half, intensity));
        return hn::Combine(I(), high, low);
#endif
    }
    double m_iMax;
    float m_factor;
    bool m_estimates;
};

// Row y of a tile's blocks into the frame buffer, and the intensity where that is kept. blocks: bit i: of block i, the
// others see nothing, and whatever numbers stand there, their pixels are 0. pixelsAt(i): likewise, the pixels of vector i.
template <class A, class PixelsAt>
HWY_INLINE void putRow(const Row3& intensity, std::uint32_t blocks, PixelsAt pixelsAt, const ToBytes& bytes, Tile tile,
                       int y, ShadingOutput<float>& out) {
    auto& intensities = out.vectors[index(BufferId::Intensity)];
    ColorRows colors(blocks == (1U << kBlocksAcross) - 1);
    for (std::size_t i = 0; i < kRowPixels; i += hn::Lanes(F())) {
        const bool isSeen = (blocks >> i / kBlockPixels & 1) != 0;
        if (!isSeen && intensities.empty()) continue;
        const Mask pixels = isSeen ? pixelsAt(i) : maskOf(0);
        const Floats3 v = isSeen ? where(pixels, load(intensity, i)) : all(Vec3<float>(0));
        if (isSeen) colors.put(bytes.template of<A>(v), i);
        if (intensities.empty()) continue;
        const std::size_t at = std::size_t(y) * kRowPixels + i;
        if (const Mask inTile = within(tile, at); !hn::AllFalse(F(), inTile))
            putPixels(v, inTile, at, tile.min, intensities[0]);
    }
    colors.copyTo(tile, y * kBlock, out.color);
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
