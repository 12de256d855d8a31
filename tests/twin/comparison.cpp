#include "tests/twin/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/inspect/pixel_report.h"

namespace twin {
namespace {

using namespace pipeline;

struct Ours {
    AnyBuffer color, depth, polygon;
    explicit Ours(const Frame& frame)
        : color(*frame.buffer({BufferId::Color})),
          depth(*frame.buffer({BufferId::Depth})),
          polygon(*frame.buffer({BufferId::PolygonId})) {}
    int polygonAt(int x, int y) const { return int(polygon.value(std::size_t(x), std::size_t(y))); }
    double depthAt(int x, int y) const { return depth.value(std::size_t(x), std::size_t(y)); }
};

// Calls see(x, y) for the pixels of the 3 × 3 neighbourhood that are in the picture.
template <class See>
void around(glm::ivec2 size, int x, int y, See see) {
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size.y - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size.x - 1); ++i) see(i, j);
}

// How far apart two 24-bit depths of the same plane may be at an interior pixel. Each side moves
// the corners by at most 1/512 pixel in x and in y to its sub-pixel grid, which moves the plane by
// as much: 2 · (|dz/dx| + |dz/dy|) / 512. Each rounds to a step of 2^-24, which is at most one step
// between them. Each evaluates the plane in floats of 24 bits, with terms up to |dz/dx| W,
// |dz/dy| H and z, in at most 4 operations with an error of 2^-24 of those: 8 steps of their sum.
double depthBound(const Ours& ours, glm::ivec2 size, int x, int y) {
    const double step = std::ldexp(1, -24);
    const double dx = std::abs(ours.depthAt(x + 1, y) - ours.depthAt(x - 1, y)) / 2 + step;
    const double dy = std::abs(ours.depthAt(x, y + 1) - ours.depthAt(x, y - 1)) / 2 + step;
    return 2 * (dx + dy) / 512 + step + 8 * step * (dx * size.x + dy * size.y + ours.depthAt(x, y));
}

}  // namespace

std::string Comparison::text() const {
    return fmt::format(
        "interior {} px: colour {}/255 at ({}, {}), depth {:.2e} ({:.2f} of its bound); coverage {} of {} edge px{}",
        interior, color, colorAt.x, colorAt.y, depth, depthShare, coverage, edge,
        astray > 0 ? fmt::format(", {} astray", astray) : std::string());
}

Comparison compare(const Frame& frame, const GlPicture& gl) {
    const Ours ours(frame);
    Comparison found;
    for (int y = 0; y < gl.size.y; ++y) {
        for (int x = 0; x < gl.size.x; ++x) {
            const int mine = ours.polygonAt(x, y), theirs = gl.polygon[gl.at(x, y)];
            bool inside = x > 0 && y > 0 && x + 1 < gl.size.x && y + 1 < gl.size.y, edge = false;
            bool mineIsNear = false, theirsIsNear = false;
            around(gl.size, x, y, [&](int i, int j) {
                const int m = ours.polygonAt(i, j), t = gl.polygon[gl.at(i, j)];
                edge = edge || m != mine;
                inside = inside && m == mine && t == mine;
                theirsIsNear = theirsIsNear || m == theirs;
                mineIsNear = mineIsNear || t == mine;
            });
            found.edge += edge;
            found.coverage += mine != theirs;
            // A sliver can be seen in one picture alone: then the pixel is on an edge all the same.
            found.astray += mine != theirs && !theirsIsNear && !mineIsNear && !edge;
            if (!inside) continue;
            ++found.interior;
            for (int c = 0; c < 3; ++c) {
                const int difference =
                    std::abs(int(ours.color.value(std::size_t(x), std::size_t(y), c)) - int(gl.color[gl.at(x, y)][c]));
                if (difference > found.color) found.color = difference, found.colorAt = {x, y};
            }
            if (mine < 0) continue;
            const double difference = std::abs(ours.depthAt(x, y) - gl.depth[gl.at(x, y)]);
            const double share = difference / depthBound(ours, gl.size, x, y);
            found.depth = std::max(found.depth, difference);
            if (share > found.depthShare) found.depthShare = share, found.depthAt = {x, y};
        }
    }
    return found;
}

std::string explain(const Frame& frame, const GlPicture& gl, glm::ivec2 pixel) {
    if (pixel.x < 0) return {};
    const Color8 theirs = gl.color[gl.at(pixel.x, pixel.y)];
    return fmt::format("pixel ({}, {}): OpenGL has ({}, {}, {}), depth {:.9g}; ours:\n{}", pixel.x, pixel.y,
                       int(theirs.r), int(theirs.g), int(theirs.b), gl.depth[gl.at(pixel.x, pixel.y)],
                       toText(frame, inspectPixel(frame, pixel)));
}

}  // namespace twin
