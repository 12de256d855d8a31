#include "pipeline/scene/closed_mesh.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace pipeline {
namespace {

// False where it is stopped.
template <class Visit>
bool forEachEdge(const Mesh& mesh, StopCheck& check, Visit visit) {
    for (std::size_t i = 0; i < mesh.polygonCount(); ++i) {
        const std::span<const std::uint32_t> corners = mesh.polygon(i);
        if (check.stopped(corners.size())) return false;
        std::uint32_t from = corners.back();
        for (const std::uint32_t to : corners) {
            visit(from, to);
            from = to;
        }
    }
    return true;
}

// The other ends of the edges that leave, or that reach, the vertices in a range: those of a vertex side by side.
class EdgeEnds {
public:
    explicit EdgeEnds(std::size_t vertices) : m_first(vertices + 1) {}
    // For another range: first all edges are counted, then all are put in. vertex: within the range.
    void begin() { std::ranges::fill(m_first, 0); }
    void count(std::size_t vertex) { ++m_first[vertex]; }
    void endCount() {
        std::uint32_t sum = 0;
        for (std::uint32_t& first : m_first) first = sum += first;
        m_ends.resize(sum);
    }
    void put(std::size_t vertex, std::uint32_t end) { m_ends[--m_first[vertex]] = end; }
    // In order.
    std::span<const std::uint32_t> of(std::size_t vertex) {
        const std::span<std::uint32_t> ends(m_ends.begin() + m_first[vertex], m_ends.begin() + m_first[vertex + 1]);
        std::ranges::sort(ends);
        return ends;
    }

private:
    std::vector<std::uint32_t> m_first, m_ends;
};

}  // namespace

bool isClosed(const Mesh& mesh, StopCheck& check) {
    if (mesh.polygonCount() == 0) return false;
    const std::size_t vertices = mesh.positions.size();
    const std::size_t most = std::clamp<std::size_t>(vertices / 2, 1 << 18, 1 << 20);
    EdgeEnds leaving(std::min(most, vertices)), arriving(std::min(most, vertices));
    for (std::size_t first = 0; first < vertices; first += most) {
        const std::size_t count = std::min(most, vertices - first);
        const auto inRange = [&](std::uint32_t vertex) { return vertex - first < count; };  // below it wraps round
        leaving.begin(), arriving.begin();
        const bool counted = forEachEdge(mesh, check, [&](std::uint32_t from, std::uint32_t to) {
            if (inRange(from)) leaving.count(from - first);
            if (inRange(to)) arriving.count(to - first);
        });
        if (!counted) return false;
        leaving.endCount(), arriving.endCount();
        const bool put = forEachEdge(mesh, check, [&](std::uint32_t from, std::uint32_t to) {
            if (inRange(from)) leaving.put(from - first, to);
            if (inRange(to)) arriving.put(to - first, from);
        });
        if (!put) return false;
        for (std::size_t vertex = 0; vertex < count; ++vertex) {
            const std::span<const std::uint32_t> to = leaving.of(vertex), from = arriving.of(vertex);
            if (check.stopped(to.size() + from.size())) return false;
            if (!std::ranges::equal(to, from)) return false;
            if (std::ranges::adjacent_find(to) != to.end()) return false;
            if (std::ranges::binary_search(to, std::uint32_t(first + vertex))) return false;  // an edge to itself
        }
    }
    return true;
}

}  // namespace pipeline
