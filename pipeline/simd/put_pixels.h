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

// Writes the lanes in `mask` to a buffer. at: the vector's first pixel in the tile's blocks; origin: the tile's first
// pixel.
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

// Writes a row of blocks to the frame buffer, from left to right.
class ColorRows {
public:
    // y: the first of its rows of pixels, in the tile.
    HWY_INLINE ColorRows(Tile tile, int y, Buffer2D<Color8>& out)
        : m_first(&out.at(tile.min + glm::ivec2(0, y)).r),
          m_stride(std::size_t(out.size.x) * sizeof(Color8)),
          m_size(tile.max - tile.min - glm::ivec2(0, y)),
          m_next(m_size.x - 2 * kBlock + 1) {}
    // Each lane has the channels in its lowest bytes and 0 in the highest. at: the vector's first pixel in the row of
    // blocks.
    HWY_INLINE void put(Ints colors, std::size_t at) {
        const int column = int(at / kBlockPixels) * kBlock + int(at % kBlock), row = int(at % kBlockPixels) / kBlock;
#if HWY_TARGET == HWY_SCALAR
        const std::int32_t color = hn::GetLane(colors);
        if (column < m_size.x && row < m_size.y) std::memcpy(place(column, row), &color, sizeof(Color8));
#else
        // Rows of 4 pixels: 3 of the 4 bytes of each are kept. The rest is 0 and is overwritten by the next block.
        constexpr hn::Repartition<std::uint8_t, I> bytes;
        alignas(16) static constexpr std::uint8_t kKept[16]{0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 3, 7, 11, 15};
        const auto packed = hn::TableLookupBytes(hn::BitCast(bytes, colors), hn::LoadDup128(bytes, kKept));
        constexpr int kPut = kLanes / kBlock;
        if (HWY_LIKELY(column < m_next && m_size.y >= kBlock)) {
            putRows(packed, place(column, row),
                    [](auto kept, std::uint8_t* to) HWY_ATTR { hn::StoreU(kept, hn::DFromV<decltype(kept)>(), to); });
        } else if (column + kBlock <= m_size.x && m_size.y >= kBlock) {  // other threads write beyond the tile
            putRows(packed, place(column, row), [](auto kept, std::uint8_t* to) HWY_ATTR {
                const hn::Repartition<std::uint64_t, hn::DFromV<decltype(kept)>> eights;
                const hn::Repartition<std::uint32_t, hn::DFromV<decltype(kept)>> fours;
                const std::uint64_t first = hn::GetLane(hn::BitCast(eights, kept));
                const std::uint32_t last = hn::ExtractLane(hn::BitCast(fours, kept), 2);
                std::memcpy(to, &first, sizeof first), std::memcpy(to + sizeof first, &last, sizeof last);
            });
        } else if (column < m_size.x) {
            HWY_ALIGN std::uint8_t rows[64];
            hn::Store(packed, bytes, rows);
            const auto width = std::size_t(std::min(kBlock, m_size.x - column)) * sizeof(Color8);
            for (int y = 0; y < std::min(kPut, m_size.y - row); ++y)
                std::memcpy(place(column, row + y), rows + std::ptrdiff_t(16) * y, width);
        }
#endif
    }

private:
#if HWY_TARGET != HWY_SCALAR  // whose vectors have no halves
    // Calls put(row, to) for each row, of 16 bytes.
    template <class V, class Put>
    HWY_INLINE void putRows(V rows, std::uint8_t* to, Put put) {
        constexpr hn::DFromV<V> d;
        if constexpr (hn::MaxLanes(d) == 16) {
            put(rows, to);
        } else {
            constexpr hn::Half<hn::DFromV<V>> half;
            putRows(hn::LowerHalf(half, rows), to, put);
            putRows(hn::UpperHalf(half, rows), to + hn::MaxLanes(d) / 32 * m_stride, put);
        }
    }
#endif
    HWY_INLINE std::uint8_t* place(int column, int row) {
        return m_first + std::size_t(row) * m_stride + std::size_t(column) * sizeof(Color8);
    }
    static_assert(sizeof(Color8) == 3);
    std::uint8_t* m_first;
    std::size_t m_stride;
    glm::ivec2 m_size;  // pixels from the row's first one to the tile's end
    int m_next;         // first column that no whole block follows
};

// frameBufferValue for channels. In exact arithmetic it has the same bits: it estimates in float first, and computes in
// double if the estimate is too near to a rounding step.
class ToBytes {
public:
    explicit ToBytes(double iMax) : m_iMax(iMax), m_factor(iMax > 0 ? float(255 / iMax) : 0) {
        m_estimates = m_factor > 0x1p-100F && m_factor < 0x1p100F;
    }
    // Red in the lowest byte, then green and blue; 0 in the highest.
    template <class A>
    HWY_INLINE Ints of(Floats3 intensity) const {
        const Ints red = fixed(intensity.x), green = fixed(intensity.y), blue = fixed(intensity.z);
        if constexpr (A::kExact) {
            const Ints rest = hn::Min(hn::Min(restOf(red), restOf(green)), restOf(blue));
            if (HWY_UNLIKELY(!m_estimates || !hn::AllFalse(I(), hn::Eq(rest, hn::Zero(I())))))
                return hn::Or(inDouble(intensity.x), hn::Or(hn::ShiftLeft<8>(inDouble(intensity.y)),
                                                            hn::ShiftLeft<16>(inDouble(intensity.z))));
        }
        const auto byte = [](Ints value, int at) HWY_ATTR { return hn::And(value, hn::Set(I(), 255 << at)); };
        return hn::Or(byte(hn::ShiftRight<kFraction>(red), 0), hn::Or(byte(hn::ShiftRight<kFraction - 8>(green), 8),
                                                                      byte(hn::ShiftLeft<16 - kFraction>(blue), 16)));
    }

private:
    static constexpr int kFraction = 15;  // bits
    // 255 times the intensity's fraction of I_max, plus half a step and two last places, in fixed point: 8 bits above
    // kFraction.
    HWY_INLINE Ints fixed(Floats intensity) const {
        constexpr float kLastPlace = 1.0F / (1 << kFraction);
        constexpr float kFixed = 1 << (23 - kFraction);  // sums are below 2^(24 - kFraction)
        const Floats value = hn::Mul(intensity, all(m_factor));
        const Floats clamped = hn::Min(hn::Max(value, all(0)), all(255));
        return hn::BitCast(I(), hn::Add(clamped, all(kFixed + 0.5F + 2 * kLastPlace)));
    }
    // 0 if the value is within two last places of a step. Two roundings of the fraction, 255 × 2^-23, are less than one
    // of these places, and the rounding of the sum is half of one.
    HWY_INLINE static Ints restOf(Ints value) { return hn::And(value, hn::Set(I(), (1 << kFraction) - 4)); }
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

// Writes row y of a tile's blocks to the frame buffer, and the intensity if it is kept. blocks: bit i is set if block i
// shows something; the pixels of other blocks are 0. pixelsAt(i): the lanes of vector i that show something.
template <class A, class PixelsAt>
HWY_INLINE void putRow(const Row3& intensity, std::uint32_t blocks, PixelsAt pixelsAt, const ToBytes& bytes, Tile tile,
                       int y, ShadingOutput<float>& out) {
    auto& intensities = out.vectors[index(BufferId::Intensity)];
    ColorRows colors(tile, y * kBlock, out.color);
    for (std::size_t i = 0; i < kRowPixels; i += hn::Lanes(F())) {
        const bool isSeen = (blocks >> i / kBlockPixels & 1) != 0;
        const Floats3 v = isSeen ? where(pixelsAt(i), load(intensity, i)) : all(Vec3<float>(0));
        colors.put(isSeen ? bytes.template of<A>(v) : hn::Zero(I()), i);
        if (intensities.empty()) continue;
        const std::size_t at = std::size_t(y) * kRowPixels + i;
        if (const Mask inTile = within(tile, at); !hn::AllFalse(F(), inTile))
            putPixels(v, inTile, at, tile.min, intensities[0]);
    }
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
