// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_TINY_TRIANGLES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_TINY_TRIANGLES_H
#undef SHADESCOPE_TINY_TRIANGLES_H
#else
#define SHADESCOPE_TINY_TRIANGLES_H
#endif

#include <array>
#include <bit>
#include <cstring>

#include "pipeline/simd/blocks.h"
#include "pipeline/simd/snapped_corners.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// For each byte: the codes of its set bits, lowest first, one byte each.
template <class CodeOf>
constexpr std::array<std::uint64_t, 256> setBits(CodeOf codeOf) {
    std::array<std::uint64_t, 256> all{};
    for (unsigned bits = 0; bits < all.size(); ++bits)
        for (unsigned bit = 0, at = 0; bit < 8; ++bit)
            if (bits >> bit & 1) all[bits] |= std::uint64_t(codeOf(bit)) << 8 * at++;
    return all;
}
// The pixels of two rows of a block; and those of two triangles that each cover at most a square of 2 × 2 pixels.
constexpr auto kBitsOfHalfBlock = setBits([](unsigned bit) { return bit; });
constexpr auto kBitsOfSquares =
    setBits([](unsigned bit) { return bit / 4 * kBlockPixels + bit / 2 % 2 * kBlock + bit % 2; });

// The covered pixels of a square, from biased edge functions at its first pixel: TinyTriangles::covered.
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

// The bits of all pixels of a box up to the size of a block; any bits for larger boxes.
HWY_INLINE Ints pixelsOfBox(Ints width, Ints height) {
    const Ints one = hn::Set(I(), 1), most = hn::Set(I(), kBlock);
    const auto first = [&](Ints count) HWY_ATTR { return hn::Sub(hn::Shl(one, count), one); };
    const Ints columns = hn::Mul(first(hn::Min(width, most)), hn::Set(I(), 0x1111));
    return hn::And(columns, first(hn::Mul(hn::Min(height, most), most)));
}

// The index of the tile of pixels.
HWY_INLINE Ints tileAt(Ints x, Ints y, int tilesAcross) {
    static_assert(kTileSize == 64);
    return hn::Add(hn::Mul(hn::ShiftRight<6>(y), hn::Set(I(), tilesAcross)), hn::ShiftRight<6>(x));
}

// A vector of tiny triangles. They are too small for a plane equation to pay off: w comes from the weights of their
// vertices.
struct TinyTriangles {
    EdgeInVectors edge1, edge2;  // c: at their boxes' first pixels
    Floats inverse;              // 1 over their areas
    Distances distances;
    Ints x, y;          // first pixels of the boxes
    Ints covered;       // bit kBlock y + x: covers the pixel in column x and row y of its box; else 0
    std::size_t id;     // index of the first triangle in Topology::triangles
    bool areInSquares;  // boxes of 2 × 2 pixels: only bits 0, 1, 4 and 5 are set
};

// Appends the fragments of tiny triangles to those of a piece, one fragment in each lane. A vector of pixels would hold
// the two or three pixels that a tiny triangle covers, and many that it does not.
struct TinyFragments {
    std::size_t first = 0, count = 0;  // in TrianglePiece::fragments
    bool areInOneTile = true;
    HWY_ALIGN std::int32_t tile[17 * 16];  // of each fragment, with some spare entries

    HWY_INLINE void append(const TinyTriangles& t, const SetUpInputs& in, int tilesAcross, Fragments& out) {
        HWY_ALIGN std::uint8_t codes[17 * 16];
        const hn::Rebind<std::uint16_t, I> each;
        hn::StoreU(hn::DemoteTo(each, t.covered), each, m_covered);
        first = out.count, count = t.areInSquares ? listSquares(m_covered, codes) : listBlocks(m_covered, codes);
        out.makeRoomFor(count + kLanes);  // the last vector is stored as a whole
        Ints elsewhere = hn::Zero(I());
        for (std::size_t n = 0; n < count; n += kLanes) {
            const Ints tiles = in.view.perspective ? find<true>(t, codes + n, tilesAcross, first + n, out)
                                                   : find<false>(t, codes + n, tilesAcross, first + n, out);
            hn::Store(tiles, I(), tile + n);
            const Ints apart = hn::Xor(tiles, hn::Set(I(), tile[0]));
            const auto inList = hn::FirstN(I(), count - n);
            elsewhere = hn::Or(elsewhere, hn::IfThenElseZero(inList, apart));
        }
        areInOneTile = hn::AllTrue(I(), hn::Eq(elsewhere, hn::Zero(I())));
        out.count += count;
    }

    // The number of fragments of the triangles in lanes below l.
    HWY_INLINE std::size_t countBefore(std::size_t l) const {
        std::size_t before = 0;
        for (std::size_t i = 0; i < l; ++i) before += std::size_t(std::popcount(m_covered[i]));
        return before;
    }

private:
    HWY_ALIGN std::uint16_t m_covered[16];  // of each triangle

    // Lists the covered pixels, triangle after triangle, as kBlockPixels l + pixel for lane l; returns their number. By
    // a table, because a CPU cannot predict the end of a loop over bits. `codes` needs room for one more entry.
    HWY_INLINE static std::size_t listBlocks(const std::uint16_t* covered, std::uint8_t* codes) {
        std::size_t count = 0;
        for (std::size_t half = 0; half < 2 * std::size_t(kLanes); ++half)
            count += put(kBitsOfHalfBlock, covered[half / 2] >> 8 * (half % 2) & 0xff, 8 * half, codes + count);
        return count;
    }
    HWY_INLINE static std::size_t listSquares(const std::uint16_t* covered, std::uint8_t* codes) {
        const auto square = [&](std::size_t l) { return (covered[l] & 3u) | (covered[l] >> 2 & 12u); };
        std::size_t count = 0;
        for (std::size_t l = 0; l < std::size_t(kLanes); l += 2)
            count += put(kBitsOfSquares, square(l) | square(l + 1) << 4, kBlockPixels * l, codes + count);
        return count;
    }
    // Writes an entry with its codes offset by `first`; returns their number.
    HWY_INLINE static std::size_t put(const std::array<std::uint64_t, 256>& table, std::size_t bits, std::size_t first,
                                      std::uint8_t* to) {
        static_assert(std::endian::native == std::endian::little && kBlockPixels == 16);
        const std::uint64_t entry = table[bits] + first * 0x0101010101010101;
        std::memcpy(to, &entry, sizeof entry);
        return std::size_t(std::popcount(bits));
    }
    // Computes one vector of fragments and writes it at `at`; returns their tiles.
    template <bool kPerspective>
    HWY_INLINE static Ints find(const TinyTriangles& t, const std::uint8_t* codes, int tilesAcross, std::size_t at,
                                Fragments& out) {
        static_assert(kBlock == 4);
        const I whole;
        const hn::Rebind<std::uint8_t, I> bytes;
        const Ints code = hn::PromoteTo(whole, hn::LoadU(bytes, codes)), three = hn::Set(whole, 3);
        const Ints lane = hn::And(hn::ShiftRight<4>(code), hn::Set(whole, kLanes - 1));
        const auto ofInts = hn::IndicesFromVec(whole, lane);
        const auto ofFloats = hn::IndicesFromVec(F(), lane);
        const auto pickInts = [&](Ints of) HWY_ATTR { return hn::TableLookupLanes(of, ofInts); };
        const auto pickFloats = [&](Floats of) HWY_ATTR { return hn::TableLookupLanes(of, ofFloats); };
        const Ints column = hn::And(code, three), row = hn::And(hn::ShiftRight<2>(code), three);
        const auto share = [&](const EdgeInVectors& edge) HWY_ATTR {
            const Ints right = hn::Mul(pickInts(edge.a), column), down = hn::Mul(pickInts(edge.b), row);
            return hn::Mul(hn::ConvertTo(F(), hn::Add(hn::Add(pickInts(edge.c), right), down)), pickFloats(t.inverse));
        };
        Distances distances = t.distances;
        for (Floats* of : {&distances.w0, &distances.toW1, &distances.toW2}) *of = pickFloats(*of);
        hn::StoreU(zOf<kPerspective>(distances.w(share(t.edge1), share(t.edge2))), F(), &out.z[at]);
        if (out.named)
            hn::StoreU(hn::Add(lane, hn::Set(whole, std::int32_t(t.id))), whole,
                       reinterpret_cast<std::int32_t*>(&out.id[at]));
        const Ints x = hn::Add(pickInts(t.x), column), y = hn::Add(pickInts(t.y), row),
                   inTile = hn::Set(whole, kTileSize - 1);
        const Ints place = hn::Add(placeOfColumn(hn::And(x, inTile)), placeOfRow(hn::And(y, inTile)));
        const hn::Rebind<std::uint16_t, I> shorts;
        hn::StoreU(hn::DemoteTo(shorts, place), shorts, &out.at[at]);
        return tileAt(x, y, tilesAcross);
    }
    // placeOf is the sum of placeOfColumn and placeOfRow.
    HWY_INLINE static Ints placeOfColumn(Ints x) {
        return hn::Add(hn::ShiftLeft<4>(hn::ShiftRight<2>(x)), hn::And(x, hn::Set(I(), 3)));
    }
    HWY_INLINE static Ints placeOfRow(Ints y) {
        static_assert(kBlocksAcross == 16);
        return hn::Add(hn::ShiftLeft<8>(hn::ShiftRight<2>(y)), hn::ShiftLeft<2>(hn::And(y, hn::Set(I(), 3))));
    }
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
