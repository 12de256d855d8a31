#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/stages/bin.h"
#include "pipeline/stages/snapped_vertices.h"

namespace pipeline {

// The triangles of a picture, set up and sorted into its tiles: what binTriangles does, many triangles at a time, into
// records whose edge functions fit into 32 bits. It reads vertices that have been projected before.

// Edge functions in steps² of the grid, c at the first pixel of its box, a more at the next column, b at the next row.
// The one of corner 0 is its triangle's area, doubled, - e1 - e2. Corners and w as in RasterTriangle: clockwise, the
// farthest first. One line of the cache: what draws and what shades jumps about in them.
struct alignas(64) SmallTriangle {
    std::int32_t a1, b1, c1, a2, b2, c2;
    std::int32_t bias1, bias2;       // 0 where the edge owns the samples on it, else 1: e - bias is below 0 outside
    std::int32_t biasedArea;         // less the bias of edge 0
    float w0, w1, w2, inverseArea2;  // in steps too: exactly that of RasterTriangle by a power of two
    std::uint32_t id;                // index into Topology::triangles
    std::int16_t x, y;               // the box's first pixel
    std::uint8_t width, height;      // of the box within the picture, pixels, at least 1
    std::uint8_t order;              // of its corners: 0 to 2 as the triangle's own, 3 to 5 turned round
    std::uint8_t bias0;              // of edge 0, as bias1

    bool facesViewer() const { return order >= 3; }
    // By the order: which of its corners each of the triangle's own is.
    static constexpr std::uint8_t kCorners[6][3]{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    int corner(int own) const { return kCorners[order][own]; }
};
static_assert(sizeof(SmallTriangle) == 64);

// Those of a range of polygons. What is too large for 32 bits, or had to be clipped, stands in `others`.
struct TrianglePiece {
    static constexpr std::uint32_t kOther = 1u << 31;  // an index into `others`
    std::vector<SmallTriangle, AlignsPieces<SmallTriangle>> small;
    std::vector<RasterTriangle<float>> others;
    std::vector<std::uint32_t> firstOfTile;  // per tile, and one past the last: where its list begins
    std::vector<std::uint32_t> lists;        // indices, tile after tile, in the order of the polygons
    long long clipped = 0, unclipped = 0;

    // Empty where the run was stopped before the piece was set up.
    std::span<const std::uint32_t> list(std::size_t tile) const {
        if (firstOfTile.empty()) return {};
        return {lists.data() + firstOfTile[tile], lists.data() + firstOfTile[tile + 1]};
    }
};

// Drawn piece after piece, the order is that of the polygons.
struct TrianglePieces {
    // A record of all pieces: its index in a list of its piece, and which piece, in bits that no index reaches.
    static constexpr int kPieceBit = 26, kMostPieces = 32;
    static constexpr std::uint32_t kIndex = (1u << kPieceBit) - 1;
    static std::uint32_t record(std::size_t piece, std::uint32_t index) {
        return index + (std::uint32_t(piece) << kPieceBit);
    }
    const TrianglePiece& pieceOf(std::uint32_t record) const { return pieces[record >> kPieceBit & (kMostPieces - 1)]; }
    const SmallTriangle& smallOf(std::uint32_t record) const { return pieceOf(record).small[record & kIndex]; }
    // Index into Topology::triangles.
    std::uint32_t triangleOf(std::uint32_t record) const {
        return record & TrianglePiece::kOther ? pieceOf(record).others[record & kIndex].id : smallOf(record).id;
    }

    glm::ivec2 size{0}, tiles{0};  // of the picture, pixels; columns and rows of tiles
    std::vector<TrianglePiece> pieces;

    std::size_t tileCount() const { return std::size_t(tiles.x) * std::size_t(tiles.y); }
    bool touches(std::size_t tile) const;
};

struct SetUpInputs {
    const Topology& topology;
    const View& view;
    std::span<const Vec3<float>> world;  // per vertex
    const SnappedVertices& vertices;
    std::span<const Verdict> verdicts{};     // per polygon; empty: all go on
    std::span<const std::uint8_t> inside{};  // per polygon, for the counts alone
    std::span<const std::uint8_t> drawn{};   // per polygon, whether this pass draws it; empty: all
    bool clipAll = false;                    // also those that need no clipping go through the clipper
    FacingFilter facing{};
};

TrianglePieces prepareSetUp(const SetUpInputs& inputs);
std::size_t trianglesOfPiece(const SetUpInputs& inputs, const TrianglePieces& pieces);
void setUpPiece(const SetUpInputs& inputs, std::size_t piece, TrianglePieces& out);

}  // namespace pipeline
