// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_SEEN_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_SEEN_H
#undef SHADESCOPE_SEEN_H
#else
#define SHADESCOPE_SEEN_H
#endif

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "pipeline/simd/blocks.h"
#include "pipeline/simd/seen_blocks.h"
#include "pipeline/simd/snapped_corners.h"
#include "pipeline/stages/z_buffer.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// The lanes of a vector of SeenBlocks::z in which something was drawn.
HWY_INLINE Mask seenIn(const float* z) { return hn::Lt(hn::Load(F(), z), all(SeenBlocks::kNowhere)); }

// The lanes whose pixel shows this triangle. Lanes without a triangle may be set too.
HWY_INLINE Mask seesIn(const std::uint32_t* names, std::uint32_t name) {
    return hn::RebindMask(F(), hn::Eq(hn::Load(U(), names), hn::Set(U(), name)));
}

// Barycentric weights of vertices 1 and 2 at a pixel; vertex 0 has the rest up to 1.
struct Shares {
    Floats one, two;
};

// The data of a tile in which the visible triangles are looked up.
struct SeenIn {
    const View& view;
    const Topology& topology;
    const SnappedVertices& vertices;
    const TrianglePieces& pieces;  // for triangles that are not small
    Tile tile;
    const float* z;  // z_view of the visible surface, in the blocks of the tile

    // The factor that makes weights linear in the picture perspective-correct, together with the vertices' 1/z. 1
    // without perspective.
    HWY_INLINE Floats zAt(const VectorPlace& place) const {
        return view.perspective ? hn::Load(F(), z + place.at) : all(1);
    }
};

// True if every lane that shows something shows a small triangle.
HWY_INLINE bool areSmall(const std::uint32_t* names, Mask seen) {
    const auto other = hn::And(hn::Load(U(), names), hn::Set(U(), TriangleRun::kOther));
    return hn::AllFalse(F(), hn::And(seen, hn::RebindMask(F(), hn::Ne(other, hn::Zero(U())))));
}

// For lanes that each show a different triangle: these triangles, and their weights, with the bits of
// SeenTriangle::weights. Lanes without a triangle get an arbitrary one of them.
struct SeenInPixels {
    HWY_ALIGN std::uint32_t id[16], vertices[3][16], polygon[16];
    Shares weights;

    // seen: at least one lane.
    HWY_INLINE SeenInPixels(const SeenIn& in, const VectorPlace& place, const std::uint32_t* names, Mask seen) {
        const auto some = hn::Set(U(), names[hn::FindKnownFirstTrue(F(), seen)]);
        hn::Store(hn::IfThenElse(hn::RebindMask(U(), seen), hn::Load(U(), names), some), U(), id);
        // A load of four reads the next triangle's first number too; the last triangle has no next one.
        const std::span<const Triangle> all = in.topology.triangles;
        const auto& last = all.back().vertices;
        const std::uint32_t end[4]{last[0], last[1], last[2], 0};
        const auto triangles = loadFours(U(), [&](std::size_t l) {
            return id[l] + 1 == all.size() ? end : static_cast<const std::uint32_t*>(all[id[l]].vertices);
        });
        for (int corner = 0; corner < 3; ++corner) hn::Store(triangles.of[corner], U(), vertices[corner]);
        for (std::size_t l = 0; l < hn::Lanes(U()); ++l) polygon[l] = in.topology.polygonOf(id[l]);
        const SnappedCorners corners(in.vertices, [&](std::size_t l, std::size_t i) { return vertices[i][l]; });
        const int bits = in.vertices.bits;
        const auto centre = [&](Ints inTile, int first)
                                HWY_ATTR { return SnappedCorners::centre(hn::Add(inTile, hn::Set(I(), first)), bits); };
        const Ints x = centre(place.column(), in.tile.min.x), y = centre(place.row(), in.tile.min.y);
        const Ints area = corners.area2();
        const auto turned = hn::Lt(area, hn::Zero(I()));
        const Floats inverse = inverseOf(hn::Abs(area)), z = hn::Load(F(), in.z + place.at);
        const auto share = [&](int from, int to, Floats w) HWY_ATTR {
            const Ints e = corners.edge(from, to, bits, x, y).c;
            const Floats linear = hn::Mul(hn::ConvertTo(F(), hn::IfThenElse(turned, hn::Neg(e), e)), inverse);
            return in.view.perspective ? hn::Mul(hn::Mul(linear, w), z) : linear;
        };
        weights = {share(2, 0, corners.w[1]), share(0, 1, corners.w[2])};
    }
};

// For the edges opposite vertices 1 and 2 of a triangle: the edge functions in units, bias included, the rest below a
// unit, and 1 over the area. Input of linearWeight.
struct NarrowWeights {
    PixelFunction edges[2];
    float inverse, unit, below[2];                    // the last two: of middle triangles; small ones have whole units
    alignas(64) std::int32_t steps[2][kBlockPixels];  // of each pixel of a block: more than at its first pixel

    HWY_INLINE void findSteps() {
        for (std::size_t i = 0; i < 2; ++i)
            for (int l = 0; l < kBlockPixels; l += kLanes)
                hn::Store(edges[i].inBlock(columnOf(l), rowOf(l)), I(), steps[i] + l);
    }
    // The units of edge i at the pixels of a vector.
    HWY_INLINE Ints units(std::size_t i, const VectorPlace& place) const {
        const glm::ivec2 block = place.block();
        return hn::Add(hn::Load(I(), steps[i] + place.first()), hn::Set(I(), edges[i].atPixel(block.x, block.y)));
    }
};

// A visible triangle of a tile, evaluated at any vector of the tile. Its vertices are its own, or those of a piece if
// clipping has cut it.
class SeenTriangle {
public:
    // Data for a triangle that is not small.
    struct Other {
        const RasterTriangle<float>* triangle;
        glm::ivec3 drawn;  // the position in drawing order of each vertex
        std::optional<MiddleEdges> middle;
        std::optional<LargeEdges> large;  // if `middle` does not fit
    };
    // other: storage for that data; it must live as long as this object is used.
    HWY_NOINLINE void become(const SeenIn& in, std::uint32_t name, std::unique_ptr<Other>& other) {
        if (TrianglePieces::isOther(name)) return becomeOther(in, in.pieces.other(name), other);
        m_id = name, m_kind = Kind::Small;
        using Wraps = std::uint32_t;  // exact wherever an edge function fits
        Wraps x[3], y[3];
        const int bits = in.vertices.bits;
        for (int corner = 0; corner < 3; ++corner) {
            const SnappedVertex& v = in.vertices.at(in.topology.triangles[name].vertices[corner]);
            x[corner] = Wraps(v.x), y[corner] = Wraps(v.y), m_w[corner] = in.view.perspective ? v.w : 1;
        }
        const auto area =
            std::int32_t((x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]));  // below 0: anticlockwise
        const auto centre = [&](int pixel) { return (Wraps(pixel) << bits) + (Wraps(1) << (bits - 1)); };
        const Wraps atX = centre(in.tile.min.x), atY = centre(in.tile.min.y), sign = area < 0 ? ~Wraps(0) : 1;
        const auto edge = [&](int from, int to) {
            const Wraps dx = sign * (x[to] - x[from]), dy = sign * (y[to] - y[from]);
            const Wraps value = dx * (atY - y[from]) - dy * (atX - x[from]);
            return PixelFunction{std::int32_t(value), std::int32_t(Wraps(0) - (dy << bits)), std::int32_t(dx << bits)};
        };
        m_narrow.edges[0] = edge(2, 0), m_narrow.edges[1] = edge(0, 1);
        m_narrow.inverse = float(1 / std::abs(double(area)));
        m_narrow.findSteps();
        const auto firstPixel = [&](const Wraps(&of)[3]) {  // SnappedTriangle::pixels
            const std::int32_t least = std::min({std::int32_t(of[0]), std::int32_t(of[1]), std::int32_t(of[2])});
            return ((least - 1 - (1 << (bits - 1))) >> bits) + 1;
        };
        m_firstPixel = {firstPixel(x), firstPixel(y)};
    }
    std::uint32_t id() const { return m_id; }  // index into Topology::triangles
    // False if the triangle is so large that only weights() is available.
    bool isLinear() const { return m_kind == Kind::Small || m_other->middle; }
    float w(std::size_t corner) const { return m_w[corner]; }
    // A vertex attribute at one of the triangle's own vertices.
    Vec3<float> atCorner(std::span<const Vec3<float>> values, const std::uint32_t (&v)[3], std::size_t corner) const {
        if (m_kind != Kind::Cut) return values[v[corner]];
        const Vec3<float>& share = m_other->triangle->weights[corner];
        return share.x * values[v[0]] + share.y * values[v[1]] + share.z * values[v[2]];
    }
    // The triangle's first pixel in the tile.
    glm::ivec2 firstPixel(Tile tile) const { return glm::max(m_firstPixel - tile.min, 0); }
    // The weight of vertex 1 or 2, linear in the picture.
    Slope slope(int corner, glm::ivec2 first) const {
        if (m_kind != Kind::Small) return m_other->middle->slope(m_other->drawn[corner], first);
        const PixelFunction& edge = m_narrow.edges[corner - 1];
        const float inverse = m_narrow.inverse;
        return {float(edge.atPixel(first.x, first.y)) * inverse, float(edge.column) * inverse,
                float(edge.row) * inverse};
    }
    // Perspective-correct weights of the triangle's own vertices, with the bits of interpolate. Lanes that do not show
    // the triangle get arbitrary numbers. z: in.zAt of the place.
    HWY_INLINE Shares weights(const SeenIn& in, const VectorPlace& place, Floats z) const {
        if (HWY_UNLIKELY(m_kind > Kind::Middle)) return weightsOfLarge(in, place.at);
        const auto share = [&](std::size_t i) HWY_ATTR {
            const Ints units = m_narrow.units(i, place);
            const Floats linear = m_kind == Kind::Small
                                      ? hn::Mul(hn::ConvertTo(F(), units), all(m_narrow.inverse))
                                      : linearWeight(units, m_narrow.unit, m_narrow.below[i], m_narrow.inverse);
            return hn::Mul(hn::Mul(linear, all(m_w[i + 1])), z);
        };
        return {share(0), share(1)};
    }

private:
    HWY_NOINLINE Shares weightsOfLarge(const SeenIn& in, std::size_t at) const {
        const VectorPlace place(at);
        if (!m_other->middle && !m_other->large->exact()) return weightsOfHuge(in, place);
        const Floats z = in.zAt(place);
        const auto share = [&](int corner) HWY_ATTR {
            const int drawn = m_other->drawn[corner];
            const Floats linear =
                m_other->middle ? m_other->middle->linear(drawn, place) : m_other->large->linear(drawn, place);
            return hn::Mul(hn::Mul(linear, all(m_w[corner])), z);
        };
        if (m_kind != Kind::Cut) return {share(1), share(2)};
        Shares sum{all(0), all(0)};
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3<float>& own = m_other->triangle->weights[std::size_t(corner)];
            const Floats b = share(corner);
            sum.one = hn::Add(sum.one, hn::Mul(b, all(own.y))), sum.two = hn::Add(sum.two, hn::Mul(b, all(own.z)));
        }
        return sum;
    }
    Shares weightsOfHuge(const SeenIn& in, const VectorPlace& place) const {
        const auto& c = m_other->triangle->snapped.corners;
        const EdgeFunction edges[3]{{c[1], c[2]}, {c[2], c[0]}, {c[0], c[1]}};
        HWY_ALIGN float one[16], two[16];
        for (std::size_t l = 0; l < hn::Lanes(F()); ++l) {
            const glm::ivec2 pixel = in.tile.min + pixelOf(place.at + l);
            const std::array<std::int64_t, 3> e{edges[0].atPixel(pixel), edges[1].atPixel(pixel),
                                                edges[2].atPixel(pixel)};
            const Vec3<float> weights = interpolate(*m_other->triangle, pixel, e, in.view.perspective).barycentric;
            one[l] = weights.y, two[l] = weights.z;
        }
        return {hn::Load(F(), one), hn::Load(F(), two)};
    }
    void becomeOther(const SeenIn& in, const RasterTriangle<float>& t, std::unique_ptr<Other>& other) {
        if (!other) other = std::make_unique<Other>();
        m_other = other.get();
        m_id = t.id, m_other->triangle = &t, m_firstPixel = t.snapped.pixels().min;
        std::optional<MiddleEdges>& middle = m_other->middle;
        middle = MiddleEdges(t, in.tile, in.view.subPixelBits);
        if (!middle->fits()) middle.reset(), m_other->large = LargeEdges(t, in.tile);
        int whole = 0;
        for (int own = 0; own < 3; ++own)
            for (int corner = 0; corner < 3; ++corner)
                if (t.weights[std::size_t(corner)][own] == 1) m_other->drawn[own] = corner, ++whole;
        m_kind = whole < 3 ? Kind::Cut : middle && middle->isNarrow() ? Kind::Middle : Kind::Large;
        if (m_kind == Kind::Cut) m_other->drawn = {0, 1, 2};
        for (int corner = 0; corner < 3; ++corner)
            m_w[corner] = in.view.perspective ? t.w[std::size_t(m_other->drawn[corner])] : 1;
        if (m_kind != Kind::Middle) return;
        const int one = m_other->drawn[1], two = m_other->drawn[2];
        m_narrow.edges[0] = middle->edge(one), m_narrow.edges[1] = middle->edge(two);
        m_narrow.unit = middle->unit(), m_narrow.inverse = middle->inverse();
        m_narrow.below[0] = middle->below(one), m_narrow.below[1] = middle->below(two);
        m_narrow.findSteps();
    }

    enum class Kind : std::uint8_t { Small, Middle, Large, Cut };
    NarrowWeights m_narrow;   // for small and middle triangles
    Other* m_other;           // for all but small triangles
    glm::ivec2 m_firstPixel;  // of its box, in the picture
    float m_w[3];             // 1/z of the vertices in perspective, else 1
    std::uint32_t m_id;
    Kind m_kind;
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
