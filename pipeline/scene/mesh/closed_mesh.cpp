#include "pipeline/scene/mesh/closed_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "pipeline/core/numerics.h"

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

// Of one vertex, both in order. False where an edge is not used twice, or leads to the vertex itself.
bool addUse(std::uint32_t vertex, std::span<const std::uint32_t> to, std::span<const std::uint32_t> from,
            std::size_t& turned) {
    std::size_t i = 0, k = 0;
    while (i < to.size() || k < from.size()) {
        const std::uint32_t end = k == from.size() || (i < to.size() && to[i] < from[k]) ? to[i] : from[k];
        std::size_t leaving = 0, arriving = 0;
        while (i < to.size() && to[i] == end) ++i, ++leaving;
        while (k < from.size() && from[k] == end) ++k, ++arriving;
        if (leaving + arriving != 2 || end == vertex) return false;
        turned += leaving == 2;  // the other end has it arrive twice
    }
    return true;
}

// Vertices that polygons connect, one of them for each piece.
class Pieces {
public:
    explicit Pieces(std::size_t vertices) : m_of(vertices) { std::iota(m_of.begin(), m_of.end(), 0u); }
    std::uint32_t of(std::uint32_t vertex) {
        while (m_of[vertex] != vertex) vertex = m_of[vertex] = m_of[m_of[vertex]];
        return vertex;
    }
    void unite(std::uint32_t a, std::uint32_t b) { m_of[of(a)] = of(b); }

private:
    std::vector<std::uint32_t> m_of;
};

struct Piece {
    double volume = 0, terms = 0;  // their sum, and that of their absolute values
    Vec3d low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
    std::size_t polygons = 0;
};

}  // namespace

std::size_t inwardPolygons(const Mesh& mesh, StopCheck& check) {
    const Vec3d middle = 0.5 * mesh.facts.low + 0.5 * mesh.facts.high, extent = mesh.facts.high - mesh.facts.low;
    const double size = std::max({extent.x, extent.y, extent.z});
    if (!(size > 0)) return 0;
    Pieces pieces(mesh.positions.size());
    for (const Triangle& triangle : mesh.triangles) {
        if (check.stopped(3)) return 0;
        pieces.unite(triangle.vertices[0], triangle.vertices[1]),
            pieces.unite(triangle.vertices[1], triangle.vertices[2]);
    }
    std::vector<std::uint32_t> numberOf(mesh.positions.size(), UINT32_MAX);
    std::vector<Piece> found;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (check.stopped(3)) return 0;
        std::uint32_t& number = numberOf[pieces.of(mesh.triangles[t].vertices[0])];
        if (number == UINT32_MAX) number = std::uint32_t(found.size()), found.emplace_back();
        Piece& piece = found[number];
        Vec3d p[3];
        for (int k = 0; k < 3; ++k) {
            p[k] = (mesh.positions[mesh.triangles[t].vertices[k]] - middle) / size;
            piece.low = glm::min(piece.low, p[k]), piece.high = glm::max(piece.high, p[k]);
        }
        const double term = glm::dot(p[0], glm::cross(p[1], p[2]));  // six times the volume under it
        piece.volume += term, piece.terms += std::abs(term);
        piece.polygons += t == mesh.firstTriangleOf(mesh.polygonOf(t));
    }
    // What rounding of so many terms explains is no sign.
    const double doubt = 0x1p-50 * double(mesh.triangles.size());
    const auto isInward = [&](const Piece& piece) { return piece.volume < -doubt * piece.terms; };
    Piece outside;  // the box of the others
    for (const Piece& piece : found)
        if (!isInward(piece))
            outside.low = glm::min(outside.low, piece.low), outside.high = glm::max(outside.high, piece.high);
    std::size_t inward = 0;
    for (const Piece& piece : found)
        if (isInward(piece) &&
            !(glm::all(glm::greaterThan(piece.low, outside.low)) && glm::all(glm::lessThan(piece.high, outside.high))))
            inward += piece.polygons;
    return inward;
}

EdgeUse edgeUseOf(const Mesh& mesh, StopCheck& check) {
    if (mesh.polygonCount() == 0) return {};
    std::size_t turned = 0;
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
        if (!counted) return {};
        leaving.endCount(), arriving.endCount();
        const bool put = forEachEdge(mesh, check, [&](std::uint32_t from, std::uint32_t to) {
            if (inRange(from)) leaving.put(from - first, to);
            if (inRange(to)) arriving.put(to - first, from);
        });
        if (!put) return {};
        for (std::size_t vertex = 0; vertex < count; ++vertex) {
            const std::span<const std::uint32_t> to = leaving.of(vertex), from = arriving.of(vertex);
            if (check.stopped(to.size() + from.size())) return {};
            if (!addUse(std::uint32_t(first + vertex), to, from, turned)) return {};
        }
    }
    return {turned == 0, turned};
}

bool isSliver(const Mesh& mesh, std::size_t polygon) {
    const auto corners = mesh.polygon(polygon);
    const Vec3d first = mesh.positions[corners[0]];
    constexpr double kSliver = 0x1p-16;
    double longest = 0;
    for (const std::uint32_t corner : corners)
        longest = std::max(longest, largestComponent(mesh.positions[corner] - first));
    if (!(longest > 0)) return false;
    Vec3d twice(0);  // the area, of sides up to about 1: no product underflows
    for (std::size_t i = 2; i < corners.size(); ++i)
        twice += glm::cross((mesh.positions[corners[i - 1]] - first) / longest,
                            (mesh.positions[corners[i]] - first) / longest);
    const double area = largestComponent(twice);
    return area > 0 && area < kSliver;
}

}  // namespace pipeline
