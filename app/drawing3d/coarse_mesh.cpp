#include "app/drawing3d/coarse_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

using pipeline::Vec3d;

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

bool isFinite(Vec3d p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

// Of every vertex the one that stands for its cell.
std::vector<std::uint32_t> firstInCell(std::span<const Vec3d> positions, int cells) {
    Vec3d low(std::numeric_limits<double>::infinity()), high(-low);
    for (const Vec3d& p : positions)
        if (isFinite(p)) low = glm::min(low, p), high = glm::max(high, p);
    const Vec3d sides = high - low;
    const double side = std::max({sides.x, sides.y, sides.z}) / cells;
    const auto count = std::size_t(cells);
    std::vector<std::uint32_t> cellsFirst(count * count * count, kNone), firsts;
    firsts.reserve(positions.size());
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
        if (!isFinite(positions[v]) || !(side > 0)) {
            firsts.push_back(kNone);
            continue;
        }
        const glm::ivec3 cell = glm::min(glm::ivec3((positions[v] - low) / side), glm::ivec3(cells - 1));
        std::uint32_t& first =
            cellsFirst[(std::size_t(cell.z) * count + std::size_t(cell.y)) * count + std::size_t(cell.x)];
        if (first == kNone) first = v;
        firsts.push_back(first);
    }
    return firsts;
}

}  // namespace

std::vector<CoarseFace> coarseMesh(std::span<const Vec3d> positions, std::span<const pipeline::Triangle> triangles,
                                   int cells) {
    const std::vector<std::uint32_t> firsts = firstInCell(positions, cells);
    std::vector<CoarseFace> kept;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const auto [a, b, c] = triangles[i].vertices;
        const std::array<std::uint32_t, 3> v{firsts[a], firsts[b], firsts[c]};
        const bool isFlat = v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
        if (!isFlat && std::ranges::find(v, kNone) == v.end()) kept.push_back({i, v});
    }
    return kept;
}

}  // namespace app
