// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_SEEN_TRIANGLES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_SEEN_TRIANGLES_H
#undef SHADESCOPE_SEEN_TRIANGLES_H
#else
#define SHADESCOPE_SEEN_TRIANGLES_H
#endif

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/simd/rows.h"
#include "pipeline/simd/seen.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// The triangles that are seen in a tile, by numbers in the order in which they are met, and their weights. A row of blocks
// meets its triangles first, and only then are they looked at, as many at once as a vector holds: what belongs to them
// stands all over the memory, and the processor waits for all of it together.
class SeenTriangles {
public:
    static constexpr std::size_t kMost = 512;  // that there is room for
    template <class T>
    struct PerTriangle {
        alignas(64) T of[kMost + 16];  // vectors reach beyond the last
    };

    // in: null where the stage's own text drew. Then names are indices, and nothing is known of weights.
    SeenTriangles(const Topology& topology, const SeenIn* in) : m_topology(topology), m_in(in) {
        m_names.fill(kNoTriangle);
    }

    // Before a row of blocks: forgets all where there might not be room for what it meets.
    void beginRow() {
        if (m_count + kRowPixels <= kMost) return;
        m_names.fill(kNoTriangle), m_count = m_known = m_otherCount = 0;
    }
    // The number of a triangle, by its name in the blocks.
    HWY_INLINE std::size_t numberOf(std::uint32_t name) {
        std::uint32_t place = name * kSpread >> (32 - kPlaceBits);
        while (m_names[place] != name) {
            if (m_names[place] == kNoTriangle) return add(name, place);
            place = (place + 1) % kPlaces;
        }
        return m_numbers[place];
    }
    // Which of these were met, or some of them.
    HWY_INLINE Mask areMet(const std::uint32_t* names) const {
        const auto all = hn::Load(U(), names);
        const auto place = hn::ShiftRight<32 - kPlaceBits>(hn::Mul(all, hn::Set(U(), kSpread)));
        return hn::RebindMask(F(), hn::Eq(hn::GatherIndex(U(), m_names.data(), hn::BitCast(I(), place)), all));
    }
    bool areUnknown() const { return m_known < m_count; }  // whether some were not looked at
    // Looks at those that were met since. found(first, of): is told of them as well, numbers from `first` on; of those
    // behind the last one nothing is read.
    template <class Found>
    HWY_INLINE void look(Found found) {
        while (m_known < m_count) {
            const std::size_t first = m_known, end = first + hn::Lanes(F());
            for (std::size_t n = m_count; n < end; ++n) m_id.of[n] = m_id.of[m_count - 1];
            const TriangleVector of(m_topology, m_id.of + first);
            m_known = std::min(end, m_count);
            if (m_in) findEdges(first, of);
            found(first, of);
        }
    }
    std::uint32_t id(std::size_t number) const { return m_id.of[number]; }  // index into Topology::triangles

    // Perspective-correct weights over the triangle's own corners, the bits of interpolate; where the triangle is not
    // seen, any numbers. z: SeenIn::zAt of the place.
    HWY_INLINE Shares weights(std::size_t number, const VectorPlace& place, Floats z) const {
        if (HWY_UNLIKELY(m_other.of[number] != kNone)) return m_others[m_other.of[number]].weights(*m_in, place, z);
        const Ints column = place.column(), row = place.row();
        const auto share = [&](const Edge& e) HWY_ATTR {
            const auto at = [&](const PerTriangle<std::int32_t>& v) HWY_ATTR { return hn::Set(I(), v.of[number]); };
            const Ints units = hn::Add(hn::Add(hn::Mul(column, at(e.column)), hn::Mul(row, at(e.row))), at(e.value));
            const Floats linear = linearWeight(units, m_unit.of[number], e.below.of[number], m_inverse.of[number]);
            return hn::Mul(hn::Mul(linear, all(e.w.of[number])), z);
        };
        return {share(m_edges[0]), share(m_edges[1])};
    }

private:
    // An edge function, opposite corner 1 or 2: how many units it has, what is below, and 1/z of that corner where the
    // picture is in perspective, else 1.
    struct Edge {
        PerTriangle<std::int32_t> value, column, row;
        PerTriangle<float> below, w;
    };
    // D. Knuth, "The Art of Computer Programming", volume 3, 6.4: multiplicative hashing, linear probing.
    static constexpr int kPlaceBits = 10;
    static constexpr std::uint32_t kSpread = 0x9e3779b1;
    static constexpr std::uint32_t kPlaces = 1 << kPlaceBits;
    static constexpr std::uint16_t kNone = 0xffff;

    HWY_NOINLINE std::size_t add(std::uint32_t name, std::uint32_t place) {
        const std::size_t number = m_count++;
        m_names[place] = name, m_numbers[place] = std::uint16_t(number);
        m_id.of[number] = name, m_other.of[number] = kNone;
        if (m_in && TrianglePieces::isOther(name)) {
            const RasterTriangle<float>& t = m_in->pieces.other(name);
            if (m_otherCount == m_others.size()) m_others.emplace_back();
            m_others[m_otherCount].become(*m_in, t);
            m_id.of[number] = t.id, m_other.of[number] = std::uint16_t(m_otherCount++);
        }
        hwy::Prefetch(&m_topology.triangles[m_id.of[number]]);
        return number;
    }
    HWY_NOINLINE void findEdges(std::size_t first, const TriangleVector& of) {
        const I d;
        const SnappedCorners corners = of.snapped(m_in->vertices);
        const Tile& tile = m_in->tile;
        const SeenEdges edges(corners, m_in->vertices.bits, hn::Set(d, tile.min.x), hn::Set(d, tile.min.y));
        for (int i = 0; i < 2; ++i) {
            const EdgeInVectors& e = i == 0 ? edges.one : edges.two;
            hn::StoreU(e.c, d, m_edges[i].value.of + first), hn::StoreU(e.a, d, m_edges[i].column.of + first);
            hn::StoreU(e.b, d, m_edges[i].row.of + first), hn::StoreU(all(0), F(), m_edges[i].below.of + first);
            hn::StoreU(m_in->view.perspective ? corners.w[i + 1] : all(1), F(), m_edges[i].w.of + first);
        }
        hn::StoreU(all(1), F(), m_unit.of + first), hn::StoreU(edges.inverse, F(), m_inverse.of + first);
        for (std::size_t n = first; m_otherCount > 0 && n < m_known; ++n)
            if (m_other.of[n] != kNone) putOther(n, m_others[m_other.of[n]]);
    }
    // Instead of what a small one would have.
    void putOther(std::size_t n, const SeenOther& other) {
        if (!other.isNarrow()) return;
        const MiddleEdges& middle = other.middle();
        for (int i = 0; i < 2; ++i) {
            const int drawn = other.drawn(i + 1);
            const PixelFunction& edge = middle.edge(drawn);
            m_edges[i].value.of[n] = edge.value, m_edges[i].column.of[n] = edge.column;
            m_edges[i].row.of[n] = edge.row, m_edges[i].below.of[n] = middle.below(drawn);
            m_edges[i].w.of[n] = other.w(i + 1);
        }
        m_unit.of[n] = middle.unit(), m_inverse.of[n] = middle.inverse();
        m_other.of[n] = kNone;
    }

    const Topology& m_topology;
    const SeenIn* m_in;
    std::size_t m_count = 0, m_known = 0;        // met; looked at
    std::array<std::uint32_t, kPlaces> m_names;  // kNoTriangle where a place is free
    std::array<std::uint16_t, kPlaces> m_numbers;
    PerTriangle<std::uint32_t> m_id;
    PerTriangle<std::uint16_t> m_other;  // of those whose weights the arrays below cannot tell, where among m_others
    Edge m_edges[2];
    PerTriangle<float> m_unit, m_inverse;  // 1 over the area
    std::vector<SeenOther> m_others;       // with room for those of other rows
    std::size_t m_otherCount = 0;
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
