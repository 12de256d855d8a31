#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/simd/set_up.h"

namespace pipeline {

// Collects triangles in order and sorts them by tile at the end.
class Binner {
public:
    Binner(const TrianglePieces& all, TrianglePiece& out)
        : m_all(all), m_out(out), m_runs{{0, kNoRun}}, m_last(all.tileCount(), 0) {}

    void add(std::uint32_t index, glm::ivec2 low, glm::ivec2 high) {  // pixels [low, high) of the picture
        const glm::uvec2 first = glm::uvec2(low) / kSide, last = glm::uvec2(high - 1) / kSide;
        for (std::uint32_t y = first.y; y <= last.y; ++y)
            for (std::uint32_t x = first.x; x <= last.x; ++x) addRun(y * std::uint32_t(m_all.tiles.x) + x, {index, 1});
    }
    void addRun(std::uint32_t tile, TriangleRun of) {
        TriangleRun& last = m_runs[m_last[tile]].of;
        if (last.first + last.count == of.first) {
            last.count += of.count;
            return;
        }
        m_last[tile] = std::uint32_t(m_runs.size());
        m_runs.push_back({tile, of});
    }
    // Adds the fragments [begin, end) of those that start at `first`. tile: the tile of each of them.
    void addFragments(std::size_t first, std::size_t begin, std::size_t end, const std::int32_t* tile,
                      bool areInOneTile) {
        while (begin < end) {
            std::size_t next = areInOneTile ? end : begin + 1;
            while (next < end && tile[next] == tile[begin]) ++next;
            addRun(std::uint32_t(tile[begin]),
                   {std::uint32_t(first + begin) | TriangleRun::kTiny, std::uint32_t(next - begin)});
            begin = next;
        }
    }
    void addOther(const RasterTriangle<float>& triangle) {
        const Tile box = triangle.snapped.pixels();
        const glm::ivec2 low = glm::max(box.min, glm::ivec2(0)), high = glm::min(box.max, m_all.size);
        if (low.x >= high.x || low.y >= high.y) return;
        add(std::uint32_t(m_out.others.size()) | TriangleRun::kOther, low, high);
        m_out.others.push_back(triangle);
    }
    void finish() {
        m_out.firstOfTile.assign(m_all.tileCount() + 1, 0);
        const std::span<const Run> runs = std::span<const Run>(m_runs).subspan(1);
        for (const Run& run : runs) ++m_out.firstOfTile[run.tile + 1];
        for (std::size_t i = 1; i < m_out.firstOfTile.size(); ++i) m_out.firstOfTile[i] += m_out.firstOfTile[i - 1];
        m_out.runs.resize(runs.size());
        std::vector<std::uint32_t> next(m_out.firstOfTile.begin(), m_out.firstOfTile.end() - 1);
        for (const Run& run : runs) m_out.runs[next[run.tile]++] = run.of;
    }

private:
    static constexpr std::uint32_t kSide = kTileSize;
    const TrianglePieces& m_all;
    TrianglePiece& m_out;
    struct Run {
        std::uint32_t tile;
        TriangleRun of;
    };
    static constexpr TriangleRun kNoRun{~std::uint32_t(0), 0};  // a run that nothing extends
    std::vector<Run> m_runs;                                    // the first one is kNoRun
    std::vector<std::uint32_t> m_last;                          // for each tile: its last run
};

}  // namespace pipeline
