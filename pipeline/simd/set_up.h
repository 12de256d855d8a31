#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/stages/bin.h"
#include "pipeline/stages/snapped_vertices.h"

namespace pipeline {

// The triangles of a picture, set up and sorted into its tiles. Does what binTriangles does for many triangles at a
// time, with vertices that have been projected before. If the edge functions of a triangle fit into 32 bits and its w
// into a plane, a record is kept until it is drawn. For a tiny triangle its fragments are kept instead: they take less
// memory, and less time than evaluating its edge functions again.

// Edge functions in steps² of the grid: c at the first pixel of the box, a and b the steps to the next column and row.
// They are 1 less if the edge does not own the samples on it, so negative is outside. The edge function of vertex 0 is
// area - e1 - e2. Vertices are ordered as in RasterTriangle: clockwise, the farthest first. w over the triangle is a
// PlaneEquation. The struct is one cache line, because drawing reads these records in no order.
struct alignas(64) SmallTriangle {
    std::int32_t a1, b1, c1, a2, b2, c2;
    std::int32_t area;           // doubled, minus the corrections of all three
    float first, column, row;    // of the PlaneEquation, from the first pixel of the block with the box's first pixel
    std::uint32_t id;            // index in Topology::triangles
    std::int16_t x, y;           // first pixel of the box
    std::uint8_t width, height;  // of the box within the picture, pixels, at least 1
    std::uint16_t facesViewer;   // 1 if its own vertices are anticlockwise, else 0
    float leastW, mostW;         // of its vertices
};
static_assert(sizeof(SmallTriangle) == 64);

// The pixel centres covered by tiny triangles, whose boxes are at most a block in size; most of them cover none. They
// are computed while the vertices are at hand, in the order of the polygons.
struct Fragments {
    RawVector<std::uint32_t> id;  // index in Topology::triangles; empty if not requested
    RawVector<float> z;           // z_view
    RawVector<std::uint16_t> at;  // index of the pixel in the blocks of its tile
    std::size_t count = 0;        // number of written fragments; there may be room for more
    bool named = true;            // whether ids are requested

    void makeRoomFor(std::size_t more) {
        if (count + more <= z.size()) return;
        const std::size_t size = std::max(count + more, 2 * z.size());
        if (named) id.resize(size);
        z.resize(size), at.resize(size);
    }
    void giveBackRoom() {
        if (named) id.resize(count);
        z.resize(count), at.resize(count);
        id.shrink_to_fit(), z.shrink_to_fit(), at.shrink_to_fit();
    }
};

// Triangles that follow each other, or fragments, all in one tile. Neighbours in a mesh mostly are.
struct TriangleRun {
    static constexpr std::uint32_t kOther = 1u << 31, kTiny = 1u << 30;
    std::uint32_t first,
        count;  // first: an index into TrianglePiece::small; with kOther into `others`, with kTiny into `fragments`
    bool isNotSmall() const { return (first & (kOther | kTiny)) != 0; }
};

// The triangles of a range of polygons. `others` has those that are too large for 32 bits, have no plane or had to be
// clipped.
struct TrianglePiece {
    std::vector<SmallTriangle, AlignsPieces<SmallTriangle>> small;
    Fragments fragments;
    std::vector<RasterTriangle<float>> others;
    std::vector<std::uint32_t> firstOfTile;  // for each tile, and one more for the end: index of its first run
    std::vector<TriangleRun> runs;           // tile after tile, in the order of the polygons
    std::size_t tiny = 0;                    // number of triangles in `fragments`
    long long clipped = 0, unclipped = 0;

    // Empty if the run was stopped before the piece was set up.
    std::span<const TriangleRun> list(std::size_t tile) const {
        if (firstOfTile.empty()) return {};
        return {runs.data() + firstOfTile[tile], runs.data() + firstOfTile[tile + 1]};
    }
};

// Drawing piece after piece keeps the order of the polygons.
struct TrianglePieces {
    // The name of a visible triangle: its index in Topology::triangles. For one of `others` it is kOther with its piece
    // and its index there, in bits that no index uses, because clipping makes several of one.
    static constexpr int kPieceBit = 26, kMostPieces = 32;
    static std::uint32_t nameOfOther(std::size_t piece, std::uint32_t index) {
        return TriangleRun::kOther + (std::uint32_t(piece) << kPieceBit) + index;
    }
    static bool isOther(std::uint32_t name) { return (name & TriangleRun::kOther) != 0; }
    const RasterTriangle<float>& other(std::uint32_t name) const {
        return pieces[name >> kPieceBit & (kMostPieces - 1)].others[name & ((1u << kPieceBit) - 1)];
    }
    // Index in Topology::triangles.
    std::uint32_t triangleOf(std::uint32_t name) const { return isOther(name) ? other(name).id : name; }

    glm::ivec2 size{0}, tiles{0};  // of the picture, pixels; columns and rows of tiles
    std::vector<TrianglePiece> pieces;

    std::size_t tileCount() const { return std::size_t(tiles.x) * std::size_t(tiles.y); }
    bool touches(std::size_t tile) const;
    std::size_t count() const;  // number of triangles that are not in `others`
    void forgetDrawn();         // keeps only `others`, which are read later too
};

struct SetUpInputs {
    const Topology& topology;
    const View& view;
    std::span<const Vec3<float>> world;     // one for each vertex
    const SnappedVertices* vertices;        // null: snapped while triangles are set up
    std::span<const Verdict> verdicts{};    // one for each polygon; empty: all are kept
    std::span<const std::uint8_t> marks{};  // for each polygon, from CullOutput, only for the counts
    std::span<const std::uint8_t> drawn{};  // for each polygon, whether this pass draws it; empty: all
    bool named = true;                      // whether the triangle of each fragment is requested
    bool clipAll = false;                   // clips triangles that need no clipping, too
    FacingFilter facing{};
};

// Whether vertices are hardly ever snapped more than twice if each piece snaps its own, as in meshes whose neighbours
// follow each other. Then they stay in the caches, and no list of all of them is needed.
bool snapsSeldom(const SetUpInputs& inputs, const TrianglePieces& pieces);
TrianglePieces prepareSetUp(const SetUpInputs& inputs);
std::size_t trianglesOfPiece(const SetUpInputs& inputs, const TrianglePieces& pieces);
void setUpPiece(const SetUpInputs& inputs, std::size_t piece, TrianglePieces& out);

}  // namespace pipeline
