#include "pipeline/compare/coverage_verifier.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pipeline::foreign {
namespace {

__extension__ using Int128 = __int128;

constexpr int kFinestBits = 16;
constexpr double kSteps = 1 << kFinestBits;  // of a pixel

// The grid's points that a coordinate may be taken to, in steps of 2^-16 pixel: one or two.
struct Span {
    std::int64_t low, high;
};
Span placesOf(double coordinate, int bits, Snapping snapping) {
    const double places = double(1 << bits);
    const double scaled = coordinate * places, below = std::floor(scaled), rest = scaled - below;
    const auto steps = std::int64_t(1) << (kFinestBits - bits);
    const std::int64_t low = std::int64_t(below) * steps, high = low + steps;
    if (rest == 0) return {low, low};
    if (snapping == Snapping::Within || rest == 0.5) return {low, high};
    return rest < 0.5 ? Span{low, low} : Span{high, high};
}

int clampedToInt(std::int64_t value) {
    return int(std::clamp<std::int64_t>(value, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
}

// Rounded down, whatever the sign.
std::int64_t pixelOf(std::int64_t steps) { return steps >> kFinestBits; }

int sign(Int128 value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

}  // namespace

std::optional<CoverageVerifier> CoverageVerifier::make(const std::array<glm::dvec2, 3>& vertices, int bits,
                                                       Snapping snapping) {
    CoverageVerifier out;
    out.m_snapping = snapping;
    std::int64_t low[2], high[2];
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 v = vertices[i];
        if (!(std::abs(v.x) <= kReach) || !(std::abs(v.y) <= kReach)) return std::nullopt;
        const Span x = placesOf(v.x, bits, snapping), y = placesOf(v.y, bits, snapping);
        Choices& choices = out.m_choices[i];
        for (std::int64_t px = x.low;; px = x.high) {
            choices.points[choices.count++] = {px, y.low};
            if (y.high != y.low) choices.points[choices.count++] = {px, y.high};
            if (px == x.high) break;
        }
        low[0] = i == 0 ? x.low : std::min(low[0], x.low), high[0] = i == 0 ? x.high : std::max(high[0], x.high);
        low[1] = i == 0 ? y.low : std::min(low[1], y.low), high[1] = i == 0 ? y.high : std::max(high[1], y.high);
    }
    out.m_first = {clampedToInt(pixelOf(low[0])), clampedToInt(pixelOf(low[1]))};
    out.m_end = {clampedToInt(pixelOf(high[0]) + 1), clampedToInt(pixelOf(high[1]) + 1)};
    return out;
}

Coverage CoverageVerifier::at(glm::ivec2 pixel, glm::dvec2 at) const {
    const Point s{std::int64_t(pixel.x) * (1 << kFinestBits) + std::llround(at.x * kSteps),
                  std::int64_t(pixel.y) * (1 << kFinestBits) + std::llround(at.y * kSteps)};
    // On which side of each edge the sample is, for each choice of its two ends.
    int side[3][4][4];
    bool always[3][2]{{true, true}, {true, true}, {true, true}};  // edge, side: whether it is there in every choice
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const Choices &from = m_choices[edge], &to = m_choices[(edge + 1) % 3];
        for (std::size_t i = 0; i < from.count; ++i) {
            for (std::size_t j = 0; j < to.count; ++j) {
                const Point p = from.points[i], q = to.points[j];
                const int there = sign(Int128(q.x - p.x) * (s.y - p.y) - Int128(q.y - p.y) * (s.x - p.x));
                side[edge][i][j] = there;
                always[edge][0] = always[edge][0] && there < 0;
                always[edge][1] = always[edge][1] && there > 0;
            }
        }
    }
    const auto isInside = [&](int way) { return always[0][way] && always[1][way] && always[2][way]; };
    if (isInside(0) || isInside(1)) return Coverage::Forced;
    // An edge function is linear in each coordinate of its ends, so that its extremes over a box are at the box's corners:
    // on one side of an edge in every choice is on that side wherever the vertices are between them. A triangle that turns
    // the other way needs the sample on the other side of all three.
    bool outside[2]{false, false};
    for (const auto& edge : always) outside[0] = outside[0] || edge[0], outside[1] = outside[1] || edge[1];
    if (outside[0] && outside[1]) return Coverage::Forbidden;
    const auto isBeside = [&](auto of, std::int64_t here) {
        bool below = true, above = true;
        for (const Choices& vertex : m_choices)
            for (const Point& p : vertex) below = below && of(p) < here, above = above && of(p) > here;
        return below || above;
    };
    if (isBeside([](const Point& p) { return p.x; }, s.x) || isBeside([](const Point& p) { return p.y; }, s.y))
        return Coverage::Forbidden;
    if (m_snapping == Snapping::Within) return Coverage::Free;

    bool covered = false, missed = false, free = false;
    for (std::size_t i = 0; i < m_choices[0].count; ++i) {
        for (std::size_t j = 0; j < m_choices[1].count; ++j) {
            for (std::size_t k = 0; k < m_choices[2].count; ++k) {
                const Point a = m_choices[0].points[i], b = m_choices[1].points[j], c = m_choices[2].points[k];
                const int turn = sign(Int128(b.x - a.x) * (c.y - a.y) - Int128(b.y - a.y) * (c.x - a.x));
                const int sides[3]{turn * side[0][i][j], turn * side[1][j][k], turn * side[2][k][i]};
                const int least = std::min({sides[0], sides[1], sides[2]});
                if (turn == 0 || least < 0)
                    missed = true;
                else
                    (least > 0 ? covered : free) = true;
            }
        }
    }
    return free || (covered && missed) ? Coverage::Free : covered ? Coverage::Forced : Coverage::Forbidden;
}

}  // namespace pipeline::foreign
