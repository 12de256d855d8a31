#include "pipeline/simd/set_up.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <iterator>

#include "pipeline/simd/binner.h"
#include "pipeline/simd/fetch_ahead.h"
#include "pipeline/simd/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/simd/set_up.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
//
#include "pipeline/simd/plane_equations.h"
#include "pipeline/simd/tiny_triangles.h"
#include "pipeline/simd/transform.h"

#ifndef SHADESCOPE_SET_UP_OTHER
#define SHADESCOPE_SET_UP_OTHER
namespace pipeline {
namespace {

// The largest side of a small triangle's box, in steps. An edge function is a difference of two products: a side of the
// triangle times the distance of a pixel, which is up to three pixels beyond the box. L (L + 3 pixels) < 2^30 keeps it
// below 2^31. And the number of pixels has to fit into 8 bits.
std::int32_t largestBox(int bits) {
    const double beyond = 3.0 * double(1 << bits);
    const double exact = (std::sqrt(beyond * beyond + 4 * 0x1p30) - beyond) / 2;
    return std::int32_t(std::min(exact - 1, 250.0 * double(1 << bits)));
}

// The number of triangles whose vertices are snapped together, so that these vertices fit into the inner caches.
std::size_t snappedAtOnce(std::size_t triangles) {
    constexpr std::size_t kLeast = 1 << 14;
    const std::size_t parts = std::max<std::size_t>(1, triangles / kLeast);
    return std::max<std::size_t>(16, (triangles / parts + 15) / 16 * 16);
}

// Sets up a triangle that is not small, or that has to be clipped.
void setUpOther(const SetUpInputs& in, const SnappedVertices& vertices, std::uint32_t id, Binner& binner) {
    const auto& v = in.topology.triangles[id].vertices;
    const auto planesOf = [&](int corner) { return vertices.at(v[corner]).planes; };
    const auto inView = [&](int corner) { return toView(in.view, in.world[v[corner]]); };
    const bool whole = !in.clipAll && ((planesOf(0) | planesOf(1) | planesOf(2)) & SnappedVertex::kCut) == 0;
    std::vector<RasterTriangle<float>> parts;
    const std::int64_t area2 = setUpTriangle<float>(
        in.view, {inView(0), inView(1), inView(2)}, id,
        [&](const RasterTriangle<float>& part) { parts.push_back(part); }, whole);
    if (!in.facing.keeps(area2, in.topology.objectOfPolygon(in.topology.polygonOf(id)))) return;
    for (const RasterTriangle<float>& part : parts) binner.addOther(part);
}

}  // namespace
}  // namespace pipeline
#endif

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {
namespace {

// The fields of one vector of triangles after set-up: the records in quarters of 4 words each, and their boxes of
// pixels.
struct Fields {
    HWY_ALIGN std::int32_t quarters[4][16 * 4];
    HWY_ALIGN std::int32_t lowX[16], lowY[16], highX[16], highY[16];
    HWY_ALIGN std::int32_t tile[16];  // tile of the box's first pixel
    std::uint32_t inOneTile = 0;      // bit i: the whole box is in that tile
    TinyFragments fragments;

    HWY_INLINE void storeQuarter(int i, Ints one, Ints two, Ints three, Ints four) {
        hn::StoreInterleaved4(one, two, three, four, I(), quarters[i]);
    }
    HWY_INLINE void copyTo(SmallTriangle& out, std::size_t lane) const {
        static_assert(std::endian::native == std::endian::little);
        static_assert(offsetof(SmallTriangle, b2) == 16 && offsetof(SmallTriangle, column) == 32);
        static_assert(offsetof(SmallTriangle, facesViewer) == 50 && offsetof(SmallTriangle, leastW) == 52);
        auto* const to = reinterpret_cast<std::int32_t*>(&out);
        for (std::size_t i = 0; i < 4; ++i) std::memcpy(to + 4 * i, quarters[i] + 4 * lane, 16);
    }
};

// Bit i: the object of triangle first + i is mirrored.
HWY_INLINE std::uint32_t mirroredOf(const SetUpInputs& in, std::size_t first, std::uint32_t live) {
    if (in.facing.mirrored.empty()) return 0;
    std::uint32_t mirrored = 0;
    for (std::uint32_t left = live; left != 0; left &= left - 1) {
        const auto l = std::size_t(std::countr_zero(left));
        const std::uint32_t object = in.topology.objectOfPolygon(in.topology.polygonOf(first + l));
        mirrored |= std::uint32_t(in.facing.isMirrored(object)) << l;
    }
    return mirrored;
}

// Bit masks for a vector of triangles: those set up together, those of them that are tiny and have no record, and those
// set up one at a time.
struct SetUpBits {
    std::uint32_t drawn = 0, tiny = 0, others = 0;
};

// Sets up the triangles in `live` together if their boxes are below `limit`, and collects the fragments of tiny ones.
// firstId: index of the first triangle in Topology::triangles.
HWY_INLINE SetUpBits setUpVector(const SetUpInputs& in, const SnappedVertices& vertices, const Triangle* triangles,
                                 std::size_t firstId, std::int32_t limit, std::uint32_t live, int tilesAcross,
                                 Fields& out, Fragments& fragments) {
    const I whole;
    const Ints zero = hn::Zero(whole), one = hn::Set(whole, 1);
    SnappedCorners corners(vertices, [&](std::size_t l, std::size_t i) { return triangles[l].vertices[i]; });
    const Ints(&x)[3] = corners.x, (&y)[3] = corners.y, (&p)[3] = corners.planes;
    const Ints beside = hn::Or(hn::Or(p[0], p[1]), p[2]), outside = hn::And(hn::And(p[0], p[1]), p[2]);
    const auto has = [&](Ints bits, std::uint32_t mask)
                         HWY_ATTR { return hn::Ne(hn::And(bits, hn::Set(whole, std::int32_t(mask))), zero); };
    // If all vertices are beyond the same plane, clipping would leave nothing.
    if (!in.clipAll) live &= ~bitsOf(asFloats(has(outside, SnappedVertex::kOutside)));
    const auto cut = has(beside, SnappedVertex::kCut);
    const Ints lowX = hn::Min(x[0], hn::Min(x[1], x[2])), highX = hn::Max(x[0], hn::Max(x[1], x[2]));
    const Ints lowY = hn::Min(y[0], hn::Min(y[1], y[2])), highY = hn::Max(y[0], hn::Max(y[1], y[2]));
    const auto isBelow = [&](Ints high, Ints low)
                             HWY_ATTR { return hn::Lt(hn::Sub(high, low), hn::Set(whole, limit)); };
    const auto isSmall = hn::AndNot(cut, hn::And(isBelow(highX, lowX), isBelow(highY, lowY)));
    SetUpBits found;
    found.drawn = bitsOf(asFloats(isSmall)) & live;
    found.others = live & ~found.drawn;
    if (found.drawn == 0) return found;

    // SnappedTriangle::pixels, cut to the picture.
    const int bits = vertices.bits;
    const Ints half = hn::Set(whole, 1 << (bits - 1));
    const auto behind = [&](Ints steps)
                            HWY_ATTR { return hn::Add(hn::ShiftRightSame(hn::Sub(steps, half), bits), one); };
    const Ints fromX = behind(hn::Sub(lowX, one)), fromY = behind(hn::Sub(lowY, one));
    const Ints toX = behind(highX), toY = behind(highY);
    const Ints minX = hn::Max(zero, fromX), minY = hn::Max(zero, fromY);
    const Ints maxX = hn::Min(toX, hn::Set(whole, in.view.size.x));
    const Ints maxY = hn::Min(toY, hn::Set(whole, in.view.size.y));
    const Ints area = corners.area2(), size = hn::Abs(area);
    const auto seen = hn::And(hn::Ne(area, zero), hn::And(hn::Lt(minX, maxX), hn::Lt(minY, maxY)));
    const Mask turned = asFloats(hn::Lt(area, zero));
    std::uint32_t& drawn = found.drawn;
    drawn &= bitsOf(asFloats(seen));
    if (in.facing.cull != ShadowCull::None) {  // as FacingFilter::keeps
        const std::uint32_t faces = bitsOf(turned) ^ mirroredOf(in, firstId, drawn);
        drawn &= in.facing.cull == ShadowCull::Back ? faces : ~faces;
    }
    if (drawn == 0) return found;

    corners.putInOrder(turned);
    const Ints atX = SnappedCorners::centre(minX, bits), atY = SnappedCorners::centre(minY, bits);
    const auto edge = [&](int from, int to) HWY_ATTR { return corners.edge(from, to, bits, atX, atY); };
    const EdgeInVectors edge1 = edge(2, 0), edge2 = edge(0, 1);
    const Ints bias0 = edge(1, 2).bias;  // the rest of edge 0 follows from the other two
    const Ints width = hn::Sub(maxX, minX), height = hn::Sub(maxY, minY);

    // Of the whole box, also where the picture's border cuts it.
    const Ints across = hn::Sub(toX, fromX), down = hn::Sub(toY, fromY);
    const auto areWithin = [&](int side) HWY_ATTR {
        const Ints beyond = hn::Set(whole, side + 1);
        return bitsOf(asFloats(hn::And(hn::Lt(across, beyond), hn::Lt(down, beyond)))) & drawn;
    };
    if (const std::uint32_t tiny = areWithin(kTinySide); tiny != 0) {
        const Ints e1 = hn::Sub(edge1.c, edge1.bias), e2 = hn::Sub(edge2.c, edge2.bias);
        const Ints e0 = hn::Sub(hn::Sub(size, bias0), hn::Add(edge1.c, edge2.c));
        const bool areInSquares = areWithin(2) == tiny;
        const Ints square =
            areInSquares ? coveredIn<2>(e0, e1, e2, edge1, edge2) : coveredIn<kBlock>(e0, e1, e2, edge1, edge2);
        const Ints covered = pick(maskOf(tiny), hn::And(square, pixelsOfBox(width, height)), zero);
        drawn &= ~(tiny & bitsOf(asFloats(hn::Eq(covered, zero))));
        found.tiny = tiny & drawn;
        if (found.tiny != 0) {
            const Distances distances(corners.w[0], corners.w[1], corners.w[2]);
            out.fragments.append({edge1, edge2, inverseOf(size), distances, minX, minY, covered, firstId, areInSquares},
                                 in, tilesAcross, fragments);
        }
        if (found.tiny == drawn) return found;
    }
    Mask areFlat;
    const auto blockOf = [&](Ints pixel) HWY_ATTR { return hn::AndNot(hn::Set(whole, kBlock - 1), pixel); };
    const PlanesInVectors planes = planesOf(corners, size, blockOf(minX), blockOf(minY), hn::Sub(highX, lowX),
                                            hn::Sub(highY, lowY), bits, in.view.perspective, areFlat);
    const std::uint32_t steep = drawn & ~found.tiny & ~bitsOf(areFlat);
    found.others |= steep, drawn &= ~steep;
    if (found.tiny == drawn) return found;
    hn::Store(minX, whole, out.lowX), hn::Store(minY, whole, out.lowY);
    hn::Store(maxX, whole, out.highX), hn::Store(maxY, whole, out.highY);
    const Ints tile = tileAt(minX, minY, tilesAcross);
    hn::Store(tile, whole, out.tile);
    out.inOneTile = bitsOf(asFloats(hn::Eq(tile, tileAt(hn::Sub(maxX, one), hn::Sub(maxY, one), tilesAcross))));
    const auto bitsIn = [](Floats value) HWY_ATTR { return hn::BitCast(I(), value); };
    const auto pair = [](Ints low, Ints high) HWY_ATTR { return hn::Or(low, hn::ShiftLeft<16>(high)); };
    const Ints box = hn::Or(width, hn::ShiftLeft<8>(height)), facing = pick(turned, one, zero);
    const Floats(&w)[3] = corners.w;
    const Ints biased = hn::Sub(size, hn::Add(bias0, hn::Add(edge1.bias, edge2.bias)));
    out.storeQuarter(0, edge1.a, edge1.b, hn::Sub(edge1.c, edge1.bias), edge2.a);
    out.storeQuarter(1, edge2.b, hn::Sub(edge2.c, edge2.bias), biased, bitsIn(planes.first));
    out.storeQuarter(2, bitsIn(planes.column), bitsIn(planes.row), hn::Iota(whole, std::int32_t(firstId)),
                     pair(minX, minY));
    out.storeQuarter(3, pair(box, facing), bitsIn(w[0]), bitsIn(hn::Max(w[0], hn::Max(w[1], w[2]))), zero);
    return found;
}

// Bit i: triangle first + i is drawn. Counts them.
HWY_INLINE std::uint32_t liveOf(const SetUpInputs& in, std::size_t first, std::size_t count, TrianglePiece& out) {
    const hn::Rebind<std::uint8_t, I> bytes;
    // Bit i: the polygon of triangle i has the value `one` or `two`.
    const auto bitsWhere = [&](const auto* of, auto one, auto two) HWY_ATTR {
        std::uint32_t bits = 0;
        if (in.topology.polygons.empty() && count == hn::Lanes(bytes)) {
            const auto found = hn::LoadU(bytes, reinterpret_cast<const std::uint8_t*>(of + first));
            const auto is = [&](auto number) HWY_ATTR { return hn::Eq(found, hn::Set(bytes, std::uint8_t(number))); };
            std::uint8_t room[8]{};
            hn::StoreMaskBits(bytes, hn::Or(is(one), is(two)), room);
            return std::uint32_t(room[0] | room[1] << 8);
        }
        for (std::size_t l = 0; l < count; ++l) {
            const auto found = of[in.topology.polygonOf(first + l)];
            bits |= std::uint32_t(found == one || found == two) << l;
        }
        return bits;
    };
    std::uint32_t live = (1u << count) - 1, whole = 0;
    if (!in.verdicts.empty()) live &= bitsWhere(in.verdicts.data(), Verdict::Kept, Verdict::Clipped);
    if (!in.drawn.empty()) live &= ~bitsWhere(in.drawn.data(), 0, 0);
    constexpr std::uint8_t kInside = CullMark::kInside;
    if (!in.marks.empty()) whole = live & bitsWhere(in.marks.data(), kInside, kInside | CullMark::kBack);
    out.unclipped += std::popcount(live & whole), out.clipped += std::popcount(live & ~whole);
    return live;
}

// Snaps the vertices of triangles [begin, end), and those with indices between them.
HWY_NOINLINE void snapFor(std::size_t begin, std::size_t end, const SetUpInputs& in, SnappedVertices& out) {
    const VertexRange range = in.topology.verticesOf(begin, end);
    const std::size_t count = range.last - range.first;
    out.first = range.first;
    if (out.of.size() < count) out.of.resize(count);
    snapInVectors(in.view, in.world.subspan(range.first), 0, count, out);
}

}  // namespace

void setUpTriangles(const SetUpInputs& in, std::size_t begin, std::size_t end, const TrianglePieces& all,
                    TrianglePiece& out) {
    const std::span<const Triangle> triangles = in.topology.triangles;
    const std::size_t lanes = hn::Lanes(F());
    Binner binner(all, out);
    // In a closed object half of the triangles face away.
    out.small.reserve(in.verdicts.empty() && in.facing.cull == ShadowCull::None ? end - begin : (end - begin) / 2);
    out.fragments.named = in.named;
    // As many fragments as triangles, but no more than most pieces have.
    out.fragments.makeRoomFor(std::min<std::size_t>(end - begin, 1 << 15));
    const std::int32_t limit = in.clipAll ? 0 : largestBox(in.view.subPixelBits) + 1;
    Fields fields{};
    Triangle rest[16]{};
    // The vertices [base, snapped) are ready.
    SnappedVertices own;
    own.bits = in.view.subPixelBits;
    const SnappedVertices& vertices = in.vertices ? *in.vertices : own;
    std::size_t snapped = in.vertices ? end : begin;
    for (std::size_t base = begin; base < end; base += lanes) {
        if (base == snapped) {
            snapped = std::min(end, base + snappedAtOnce(end - begin));
            snapFor(base, snapped, in, own);
        }
        const std::size_t count = std::min(lanes, end - base);
        const Triangle* from = &triangles[base];
        fetchAhead(from, lanes);
        const std::uint32_t live = liveOf(in, base, count, out);
        if (live == 0) continue;
        if (count < lanes) {
            // The other lanes are read too, so they need some value.
            std::fill(std::copy_n(from, count, rest), std::end(rest), *from);
            from = rest;
        }
        const SetUpBits bits = setUpVector(in, vertices, from, base, limit, live, all.tiles.x, fields, out.fragments);
        out.tiny += std::size_t(std::popcount(bits.tiny));
        const TinyFragments& tiny = fields.fragments;
        // In the order of their polygons.
        std::size_t added = 0;  // of the fragments
        const auto addFragments = [&](std::size_t to) {
            if (to == added) return;
            binner.addFragments(tiny.first, added, to, tiny.tile, tiny.areInOneTile), added = to;
        };
        for (std::uint32_t left = (bits.drawn | bits.others) & ~bits.tiny; left != 0; left &= left - 1) {
            const auto l = std::size_t(std::countr_zero(left));
            if (bits.tiny != 0) addFragments(tiny.countBefore(l));
            if (bits.others >> l & 1) {
                setUpOther(in, vertices, std::uint32_t(base + l), binner);
            } else {
                const auto index = std::uint32_t(out.small.size());
                if (fields.inOneTile >> l & 1)
                    binner.addRun(std::uint32_t(fields.tile[l]), {index, 1});
                else
                    binner.add(index, {fields.lowX[l], fields.lowY[l]}, {fields.highX[l], fields.highY[l]});
                fields.copyTo(out.small.emplace_back(), l);
            }
        }
        if (bits.tiny != 0) addFragments(tiny.count);
    }
    binner.finish();
    // A fine mesh is mostly tiny triangles, a coarse one has few. So memory that was not needed is freed.
    if (out.small.size() < out.small.capacity() / 2) out.small.shrink_to_fit();
    if (out.fragments.count < out.fragments.z.size() / 2) out.fragments.giveBackRoom();
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(setUpTriangles);

bool TrianglePieces::touches(std::size_t tile) const {
    return std::ranges::any_of(pieces, [&](const TrianglePiece& piece) { return !piece.list(tile).empty(); });
}
std::size_t TrianglePieces::count() const {
    std::size_t count = 0;
    for (const TrianglePiece& piece : pieces) count += piece.small.size() + piece.tiny;
    return count;
}
void TrianglePieces::forgetDrawn() {
    for (TrianglePiece& piece : pieces) {
        TrianglePiece kept;
        kept.others = std::move(piece.others);
        piece = std::move(kept);
    }
}

std::size_t trianglesOfPiece(const SetUpInputs& inputs, const TrianglePieces& pieces) {
    const std::size_t each = (inputs.topology.triangles.size() + pieces.pieces.size() - 1) / pieces.pieces.size();
    return (each + 15) / 16 * 16;
}

bool snapsSeldom(const SetUpInputs& inputs, const TrianglePieces& pieces) {
    const std::size_t count = inputs.topology.triangles.size(), each = trianglesOfPiece(inputs, pieces);
    std::size_t vertices = 0;
    for (std::size_t piece = 0; piece < count; piece += each)
        for (std::size_t end, i = piece; i < std::min(count, piece + each); i = end) {
            end = std::min({count, piece + each, i + snappedAtOnce(std::min(count - piece, each))});
            const VertexRange range = inputs.topology.verticesOf(i, end);
            vertices += range.last - range.first;
        }
    // A quarter more: a grid that closes in itself ends in the piece of its beginning.
    return vertices <= 2 * inputs.world.size() + inputs.world.size() / 4;
}

TrianglePieces prepareSetUp(const SetUpInputs& inputs) {
    // Enough pieces for the threads of a large machine, but few enough to keep their lists of tiles short. Without
    // names there may be more pieces, which are then set up in larger groups.
    constexpr std::size_t kEach = 4096, kMost = TrianglePieces::kMostPieces, kLargest = 1 << 17;
    const std::size_t count = inputs.topology.triangles.size();
    const auto piecesOf = [&](std::size_t each) { return (count + each - 1) / each; };
    const std::size_t pieces = std::clamp<std::size_t>(piecesOf(kEach), 1, kMost);
    TrianglePieces out;
    out.size = inputs.view.size;
    out.tiles = (out.size + kTileSize - 1) / kTileSize;
    out.pieces.resize(inputs.named ? pieces : std::max(pieces, piecesOf(kLargest)));
    return out;
}

void setUpPiece(const SetUpInputs& inputs, std::size_t piece, TrianglePieces& out) {
    const std::size_t count = inputs.topology.triangles.size(), each = trianglesOfPiece(inputs, out);
    HWY_DYNAMIC_DISPATCH(setUpTriangles)
    (inputs, std::min(count, piece * each), std::min(count, (piece + 1) * each), out, out.pieces[piece]);
}

}  // namespace pipeline
#endif
