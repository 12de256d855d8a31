// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_TINY_TRIANGLES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_TINY_TRIANGLES_H
#undef SHADESCOPE_TINY_TRIANGLES_H
#else
#define SHADESCOPE_TINY_TRIANGLES_H
#endif

#include <hwy/cache_control.h>

#include <bit>
#include <cstring>

#include "pipeline/simd/blocks.h"
#include "pipeline/simd/snapped_corners.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// Which pixels of a square triangles cover, of biased edge functions at its first pixel: TinyTriangle::covered.
template <int kSide>
HWY_INLINE Ints coveredIn(Ints e0, Ints e1, Ints e2, const EdgeInVectors& edge1, const EdgeInVectors& edge2) {
    const Ints a0 = hn::Neg(hn::Add(edge1.a, edge2.a)), b0 = hn::Neg(hn::Add(edge1.b, edge2.b));
    Ints covered = hn::Zero(I());
    for (int y = 0; y < kSide; ++y) {
        Ints here0 = e0, here1 = e1, here2 = e2;
        for (int x = 0; x < kSide; ++x) {
            const Ints more = hn::Or(covered, hn::Set(I(), 1 << (kBlock * y + x)));
            covered = hn::IfNegativeThenElse(hn::Or(here0, hn::Or(here1, here2)), covered, more);
            here0 = hn::Add(here0, a0), here1 = hn::Add(here1, edge1.a), here2 = hn::Add(here2, edge2.a);
        }
        e0 = hn::Add(e0, b0), e1 = hn::Add(e1, edge1.b), e2 = hn::Add(e2, edge2.b);
    }
    return covered;
}

// The same bits of all pixels of boxes up to a block in size; of others any.
HWY_INLINE Ints pixelsOfBox(Ints width, Ints height) {
    const Ints one = hn::Set(I(), 1), most = hn::Set(I(), kBlock);
    const auto first = [&](Ints count) HWY_ATTR { return hn::Sub(hn::Shl(one, count), one); };
    const Ints columns = hn::Mul(first(hn::Min(width, most)), hn::Set(I(), 0x1111));
    return hn::And(columns, first(hn::Mul(hn::Min(height, most), most)));
}

// Tiny triangles in a tile, drawn as many at a time as a vector has lanes: a vector of pixels would hold the two or three
// that one of them covers, and many that it does not.
class TinyTriangles {
public:
    TinyTriangles(const SetUpInputs& in, Tile tile) : m_in(in), m_tile(tile) {}

    bool isFull() const { return m_count == kLanes; }
    void add(const TinyTriangle& t) {
        m_id[m_count] = t.id, m_left[m_count] = t.x, m_top[m_count] = t.y;
        m_covered[m_count++] = std::int32_t(t.covered);
        hwy::Prefetch(&m_in.topology.triangles[t.id]);
    }
    // Calls visit(at, z, id) for the pixels in the tile that they cover, triangle after triangle in the order in which they
    // were added, and forgets them. at: the pixel's place in the blocks.
    template <bool kPerspective, class Visit>
    HWY_INLINE void draw(Visit visit) {
        if (m_count == 0) return;
        const std::size_t fragments = findFragments<kPerspective>();
        for (std::size_t n = 0; n < fragments; ++n) {
            const std::uint32_t i = m_fragments[n];
            visit(std::size_t(m_at[i]), m_z[i], m_id[i % kRoom]);
        }
        m_count = 0;
    }

private:
    // Leaves in m_fragments where in m_z and m_at the pixels stand; gives how many there are.
    template <bool kPerspective>
    HWY_NOINLINE std::size_t findFragments() {
        for (int l = m_count; l < kLanes; ++l)
            m_id[l] = m_id[0], m_left[l] = m_left[0], m_top[l] = m_top[0], m_covered[l] = 0;
        const I whole;
        const Ints x = hn::Load(whole, m_left), y = hn::Load(whole, m_top);
        const Ints left = hn::Sub(x, hn::Set(whole, m_tile.min.x)), top = hn::Sub(y, hn::Set(whole, m_tile.min.y));
        hn::Store(hn::And(hn::Load(whole, m_covered), pixelsInTile(left, top)), whole, m_covered);
        std::uint32_t anywhere = 0;
        const std::size_t fragments = listFragments(anywhere);

        const std::span<const Triangle> triangles = m_in.topology.triangles;
        SnappedCorners corners(m_in.vertices,
                               [&](std::size_t l, std::size_t i) { return triangles[m_id[l]].vertices[i]; });
        const Ints area = corners.area2();
        corners.putInOrder(asFloats(hn::Lt(area, hn::Zero(whole))));
        const int bits = m_in.vertices.bits;
        const Ints atX = SnappedCorners::centre(x, bits), atY = SnappedCorners::centre(y, bits);
        const EdgeInVectors edge1 = corners.edge(2, 0, bits, atX, atY), edge2 = corners.edge(0, 1, bits, atX, atY);
        const Floats inverse = inverseOf(hn::Abs(area));
        const Distances distances(corners.w[0], corners.w[1], corners.w[2]);
        Ints row1 = edge1.c, row2 = edge2.c;
        for (int row = 0; row < kBlock; ++row, row1 = hn::Add(row1, edge1.b), row2 = hn::Add(row2, edge2.b)) {
            const Ints rowAt = placeOfRow(hn::Add(top, hn::Set(whole, row)));
            Ints e1 = row1, e2 = row2;
            for (int column = 0; column < kBlock; ++column, e1 = hn::Add(e1, edge1.a), e2 = hn::Add(e2, edge2.a)) {
                const int pixel = kBlock * row + column;
                if ((anywhere >> pixel & 1) == 0) continue;
                const auto share = [&](Ints e) HWY_ATTR { return hn::Mul(hn::ConvertTo(F(), e), inverse); };
                hn::Store(distances.z<kPerspective>(share(e1), share(e2)), F(), m_z + pixel * kRoom);
                const Ints columnAt = placeOfColumn(hn::Add(left, hn::Set(whole, column)));
                hn::Store(hn::Add(rowAt, columnAt), whole, m_at + pixel * kRoom);
            }
        }
        return fragments;
    }
    // Which pixels of blocks that begin there are in the tile: TinyTriangle::covered.
    HWY_INLINE static Ints pixelsInTile(Ints left, Ints top) {
        const auto within = [](Ints first, int bitsEach, int all) HWY_ATTR {
            const Ints zero = hn::Zero(I()), each = hn::Set(I(), bitsEach), pixels = hn::Set(I(), all);
            const Ints before = hn::Max(hn::Neg(first), zero);
            const Ints behind = hn::Max(hn::Sub(first, hn::Set(I(), kTileSize - kBlock)), zero);
            return hn::And(hn::Shl(pixels, hn::Mul(before, each)), hn::Shr(pixels, hn::Mul(behind, each)));
        };
        return hn::And(hn::Mul(within(left, 1, 15), hn::Set(I(), 0x1111)), within(top, kBlock, 0xffff));
    }
    // Without a loop whose end cannot be guessed: four pixels of each triangle are noted, and the next triangle's over
    // those that it does not have.
    HWY_INLINE std::size_t listFragments(std::uint32_t& anywhere) {
        static_assert(std::endian::native == std::endian::little);
        std::size_t count = 0;
        for (int l = 0; l < m_count; ++l) {
            auto bits = std::uint32_t(m_covered[l]);
            anywhere |= bits;
            std::uint16_t* to = m_fragments + count;
            count += std::size_t(std::popcount(bits));
            do {
                std::uint64_t four = 0;
                for (int i = 0; i < 4; ++i, bits &= bits - 1)
                    four |= std::uint64_t(std::countr_zero(bits | 1u << kBlockPixels)) << (16 * i);
                four = four * kRoom + std::uint64_t(l) * 0x0001000100010001;
                std::memcpy(to, &four, sizeof four), to += 4;
            } while (HWY_UNLIKELY(bits != 0));
        }
        return count;
    }
    // placeOf is the sum of the two.
    HWY_INLINE static Ints placeOfColumn(Ints x) {
        static_assert(kBlock == 4);
        return hn::Add(hn::ShiftLeft<4>(hn::ShiftRight<2>(x)), hn::And(x, hn::Set(I(), 3)));
    }
    HWY_INLINE static Ints placeOfRow(Ints y) {
        static_assert(kBlocksAcross == 16);
        return hn::Add(hn::ShiftLeft<8>(hn::ShiftRight<2>(y)), hn::ShiftLeft<2>(hn::And(y, hn::Set(I(), 3))));
    }

    static constexpr int kRoom = 16;
    const SetUpInputs& m_in;
    Tile m_tile;
    int m_count = 0;
    std::uint32_t m_id[kRoom];
    HWY_ALIGN std::int32_t m_left[kRoom], m_top[kRoom], m_covered[kRoom];
    std::uint16_t m_fragments[kRoom * kBlockPixels + 4];  // the pixel, and in which lane
    HWY_ALIGN float m_z[kBlockPixels * kRoom];            // of each pixel of the boxes, triangle beside triangle
    HWY_ALIGN std::int32_t m_at[kBlockPixels * kRoom];
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
