#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/stages/bin.h"
#include "pipeline/stages/snapped_vertices.h"

namespace pipeline {

// The triangles of a picture, set up and sorted into its tiles: what binTriangles does, many triangles at a time, from
// vertices that have been projected before. Of a triangle whose edge functions fit into 32 bits, and w into a plane, a
// record is kept until it is drawn; of a tiny one its fragments are, which take less room, and less time than its edge
// functions once more.

// Edge functions in steps² of the grid, c at the first pixel of its box, a more at the next column, b at the next row; less
// 1 where the edge does not own the samples on it: below 0 outside. The one of corner 0 is area - e1 - e2. Corners as in
// RasterTriangle: clockwise, the farthest first; w over it is a PlaneEquation. One line of the cache: what draws jumps about
// in them.
struct alignas(64) SmallTriangle {
    std::int32_t a1, b1, c1, a2, b2, c2;
    std::int32_t area;           // doubled, less what is taken off the three of them
    float first, column, row;    // PlaneEquation's, from the first pixel of the block that holds the box's first pixel
    std::uint32_t id;            // index into Topology::triangles
    std::int16_t x, y;           // the box's first pixel
    std::uint8_t width, height;  // of the box within the picture, pixels, at least 1
    std::uint16_t facesViewer;   // 1 where its own corners run anticlockwise, else 0
    float leastW, mostW;         // of its corners
};
static_assert(sizeof(SmallTriangle) == 64);

// The pixels' centres that tiny triangles cover: those whose boxes are at most a block in size, of which most cover none.
// Found while their corners are at hand, in the order of the polygons.
struct Fragments {
    RawVector<std::uint32_t> id;  // index into Topology::triangles; empty where nobody asks
    RawVector<float> z;           // z_view
    RawVector<std::uint16_t> at;  // the pixel's place in the blocks of its tile
    std::size_t count = 0;        // of those that are written; there may be room for more
    bool named = true;            // whether somebody asks for id

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

// Triangles that stand side by side, or fragments, all in one tile: a mesh's neighbours mostly are.
struct TriangleRun {
    static constexpr std::uint32_t kOther = 1u << 31, kTiny = 1u << 30;
    std::uint32_t first,
        count;  // first: an index into TrianglePiece::small; with kOther into `others`, kTiny `fragments`
    bool isNotSmall() const { return (first & (kOther | kTiny)) != 0; }
};

// Those of a range of polygons. What is too large for 32 bits, has no plane or had to be clipped stands in `others`.
struct TrianglePiece {
    std::vector<SmallTriangle, AlignsPieces<SmallTriangle>> small;
    Fragments fragments;
    std::vector<RasterTriangle<float>> others;
    std::vector<std::uint32_t> firstOfTile;  // per tile, and one past the last: where its runs begin
    std::vector<TriangleRun> runs;           // tile after tile, in the order of the polygons
    std::size_t tiny = 0;                    // triangles that the fragments are of
    long long clipped = 0, unclipped = 0;

    // Empty where the run was stopped before the piece was set up.
    std::span<const TriangleRun> list(std::size_t tile) const {
        if (firstOfTile.empty()) return {};
        return {runs.data() + firstOfTile[tile], runs.data() + firstOfTile[tile + 1]};
    }
};

// Drawn piece after piece, the order is that of the polygons.
struct TrianglePieces {
    // The name of a triangle that is seen: its index in Topology::triangles; of one of the others kOther, its piece and
    // where it stands there, in bits that no index reaches, for clipping makes several of one.
    static constexpr int kPieceBit = 26, kMostPieces = 32;
    static std::uint32_t nameOfOther(std::size_t piece, std::uint32_t index) {
        return TriangleRun::kOther + (std::uint32_t(piece) << kPieceBit) + index;
    }
    static bool isOther(std::uint32_t name) { return (name & TriangleRun::kOther) != 0; }
    const RasterTriangle<float>& other(std::uint32_t name) const {
        return pieces[name >> kPieceBit & (kMostPieces - 1)].others[name & ((1u << kPieceBit) - 1)];
    }
    // Index into Topology::triangles.
    std::uint32_t triangleOf(std::uint32_t name) const { return isOther(name) ? other(name).id : name; }

    glm::ivec2 size{0}, tiles{0};  // of the picture, pixels; columns and rows of tiles
    std::vector<TrianglePiece> pieces;

    std::size_t tileCount() const { return std::size_t(tiles.x) * std::size_t(tiles.y); }
    bool touches(std::size_t tile) const;
    std::size_t count() const;  // of the triangles that are not others
    void forgetDrawn();         // but the others, which are looked into later as well
};

struct SetUpInputs {
    const Topology& topology;
    const View& view;
    std::span<const Vec3<float>> world;     // per vertex
    const SnappedVertices* vertices;        // null: snapped as triangles are set up
    std::span<const Verdict> verdicts{};    // per polygon; empty: all go on
    std::span<const std::uint8_t> marks{};  // per polygon, CullOutput's, for the counts alone
    std::span<const std::uint8_t> drawn{};  // per polygon, whether this pass draws it; empty: all
    bool named = true;                      // whether somebody asks which triangle a fragment is of
    bool clipAll = false;                   // also those that need no clipping go through the clipper
    FacingFilter facing{};
};

// Whether vertices are hardly ever snapped more than twice where each piece's are as it is set up: where a mesh's neighbours
// stand side by side. Their room stays in the caches, and no list of all of them is needed.
bool snapsSeldom(const SetUpInputs& inputs, const TrianglePieces& pieces);
TrianglePieces prepareSetUp(const SetUpInputs& inputs);
std::size_t trianglesOfPiece(const SetUpInputs& inputs, const TrianglePieces& pieces);
void setUpPiece(const SetUpInputs& inputs, std::size_t piece, TrianglePieces& out);

}  // namespace pipeline
