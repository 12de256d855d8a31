#include "pipeline/check/coverage.h"

#include <algorithm>
#include <cmath>

namespace pipeline::check {
namespace {

__extension__ using Int128 = __int128;

struct Grid {
    std::int64_t x, y;
};

// Calls visit(pixel) for the pixels of the picture within the box of a triangle.
template <class Visit>
void forBox(const ScreenTriangle& t, glm::ivec2 size, Visit visit) {
    const glm::dvec2 low = glm::min(t[0], glm::min(t[1], t[2])), high = glm::max(t[0], glm::max(t[1], t[2]));
    const auto first = [](double v, int limit) { return int(std::clamp(std::floor(v) - 1, 0.0, double(limit))); };
    const auto last = [](double v, int limit) { return int(std::clamp(std::ceil(v) + 1, 0.0, double(limit))); };
    for (int y = first(low.y, size.y); y < last(high.y, size.y); ++y)
        for (int x = first(low.x, size.x); x < last(high.x, size.x); ++x) visit(x, y);
}

}  // namespace

std::vector<ScreenTriangle> onScreen(const Mesh& mesh, int height) {
    std::vector<ScreenTriangle> triangles;
    for (const Triangle& t : mesh.triangles) {
        ScreenTriangle& out = triangles.emplace_back();
        for (std::size_t i = 0; i < 3; ++i)
            out[i] = {mesh.positions[t.vertices[i]].x, height - mesh.positions[t.vertices[i]].y};
    }
    return triangles;
}

std::vector<int> exactCoverage(const std::vector<ScreenTriangle>& triangles, glm::ivec2 size, int subPixels) {
    std::vector<int> counts(std::size_t(size.x) * std::size_t(size.y), 0);
    for (const ScreenTriangle& t : triangles) {
        Grid p[3];
        for (std::size_t i = 0; i < 3; ++i) p[i] = {std::llround(t[i].x * subPixels), std::llround(t[i].y * subPixels)};
        const auto cross = [](Grid a, Grid b, std::int64_t x, std::int64_t y) {
            return Int128(b.x - a.x) * (y - a.y) - Int128(b.y - a.y) * (x - a.x);
        };
        const Int128 area = cross(p[0], p[1], p[2].x, p[2].y);
        if (area == 0) continue;
        if (area < 0) std::swap(p[1], p[2]);
        forBox(t, size, [&](int x, int y) {
            const std::int64_t cx = std::int64_t(x) * subPixels + subPixels / 2;
            const std::int64_t cy = std::int64_t(y) * subPixels + subPixels / 2;
            bool inside = true;
            for (int i = 0; i < 3; ++i) {
                const Grid a = p[i], b = p[(i + 1) % 3];
                const Int128 side = cross(a, b, cx, cy);
                const bool left = b.y < a.y, top = b.y == a.y && b.x > a.x;
                inside = inside && (side > 0 || (side == 0 && (left || top)));
            }
            counts[std::size_t(y * size.x + x)] += inside;
        });
    }
    return counts;
}

std::vector<int> floatCoverage(const std::vector<ScreenTriangle>& triangles, glm::ivec2 size, bool inclusive,
                               double offset) {
    std::vector<int> counts(std::size_t(size.x) * std::size_t(size.y), 0);
    for (const ScreenTriangle& t : triangles) {
        glm::vec2 p[3]{glm::vec2(t[0] + offset), glm::vec2(t[1] + offset), glm::vec2(t[2] + offset)};
        if ((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x) < 0) std::swap(p[1], p[2]);
        forBox(t, size, [&](int x, int y) {
            bool inside = true;
            for (int i = 0; i < 3; ++i) {
                const glm::vec2 a = p[i], b = p[(i + 1) % 3];
                const float A = a.y - b.y, B = b.x - a.x, C = a.x * b.y - a.y * b.x;
                const float side = A * (float(offset + x) + 0.5f) + B * (float(offset + y) + 0.5f) + C;
                inside = inside && (inclusive ? side >= 0 : side > 0);
            }
            counts[std::size_t(y * size.x + x)] += inside;
        });
    }
    return counts;
}

std::vector<int> overdrawOf(const FramePtr& frame) {
    const AnyBuffer buffer = *frame->buffer({BufferId::Overdraw});
    std::vector<int> counts(buffer.count());
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = int(buffer.flat(i));
    return counts;
}

double differing(const std::vector<int>& a, const std::vector<int>& b) {
    double count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
    return count;
}

double differing(const std::vector<int>& a, int expected) {
    return double(std::ranges::count_if(a, [&](int n) { return n != expected; }));
}

}  // namespace pipeline::check
