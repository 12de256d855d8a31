#include "pipeline/compare/handed_in/shadow_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pipeline::foreign {

namespace {

constexpr double kExplained = 0.9;   // of the texels that both have drawn
constexpr double kCleared = 0.01;    // of all numbers: an extreme that is so common is what was cleared to
constexpr std::size_t kFewest = 16;  // texels along a side of what is drawn

// The texels that a buffer holds something in, and the rectangle around them.
struct Drawn {
    std::size_t width = 0, height = 0;
    std::vector<std::uint8_t> there;
    std::size_t left = 0, right = 0, top = 0, bottom = 0;  // right and bottom are not in it

    void findBounds() {
        left = width, top = height, right = bottom = 0;
        for (std::size_t i = 0; i < there.size(); ++i) {
            if (!there[i]) continue;
            const std::size_t x = i % width, y = i / width;
            left = std::min(left, x), right = std::max(right, x + 1), top = std::min(top, y);
            bottom = std::max(bottom, y + 1);
        }
    }
    bool isLarge() const { return right >= left + kFewest && bottom >= top + kFewest; }
};

Drawn drawnIn(const NumberFile& file) {
    Drawn out{file.columns(), file.rows(), std::vector<std::uint8_t>(file.values.size())};
    double extremes[2] = {HUGE_VAL, -HUGE_VAL};
    for (const double v : file.values)
        if (std::isfinite(v)) extremes[0] = std::min(extremes[0], v), extremes[1] = std::max(extremes[1], v);
    std::size_t counts[2] = {0, 0};
    for (const double v : file.values) counts[0] += v == extremes[0], counts[1] += v == extremes[1];
    const std::size_t common = counts[0] > counts[1] ? 0 : 1;
    const bool isCleared = double(counts[common]) > kCleared * double(file.values.size());
    for (std::size_t i = 0; i < file.values.size(); ++i)
        out.there[i] = std::isfinite(file.values[i]) && !(isCleared && file.values[i] == extremes[common]);
    out.findBounds();
    return out;
}

// One way of laying theirs on the reference's: whether x and y change places, and which of them run backwards.
struct Laid {
    bool swaps, flipsX, flipsY;
    std::size_t at(const Drawn& from, const Drawn& to, std::size_t x, std::size_t y) const {
        double u = (double(x - to.left) + 0.5) / double(to.right - to.left);
        double v = (double(y - to.top) + 0.5) / double(to.bottom - to.top);
        if (swaps) std::swap(u, v);
        if (flipsX) u = 1 - u;
        if (flipsY) v = 1 - v;
        const auto column = std::min(from.right - 1, from.left + std::size_t(u * double(from.right - from.left)));
        const auto row = std::min(from.bottom - 1, from.top + std::size_t(v * double(from.bottom - from.top)));
        return row * from.width + column;
    }
};

// How much z' changes from a texel to the next: what another place within a texel may change.
double changeAround(const Values& of, std::size_t x, std::size_t y) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (std::size_t v = y > 0 ? y - 1 : 0; v <= std::min(y + 1, of.rows - 1); ++v)
        for (std::size_t u = x > 0 ? x - 1 : 0; u <= std::min(x + 1, of.columns - 1); ++u) {
            const std::size_t i = v * of.columns + u;
            if (!of.there[i]) return HUGE_VAL;
            low = std::min(low, of.numbers[i]), high = std::max(high, of.numbers[i]);
        }
    return high - low;
}

}  // namespace

std::optional<Values> inFrameOf(const NumberFile& theirs, const Values& reference, double tolerance) {
    if (theirs.channels() != 1 || theirs.values.size() != theirs.rows() * theirs.columns() || reference.channels != 1)
        return {};
    const Drawn from = drawnIn(theirs);
    Drawn to{reference.columns, reference.rows, reference.there};
    to.findBounds();
    if (!from.isLarge() || !to.isLarge()) return {};
    std::optional<Values> best;
    double explained = kExplained;
    for (int way = 0; way < 8; ++way) {
        const Laid laid{(way & 1) != 0, (way & 2) != 0, (way & 4) != 0};
        Values out = reference;
        out.slack.assign(out.count(), 0);
        double n = 0, sv = 0, sz = 0, svv = 0, svz = 0;
        for (std::size_t y = to.top; y < to.bottom; ++y)
            for (std::size_t x = to.left; x < to.right; ++x) {
                const std::size_t i = y * reference.columns + x, j = laid.at(from, to, x, y);
                out.there[i] = from.there[j] && reference.there[i];
                out.numbers[i] = out.there[i] ? theirs.values[j] : 0;
                if (!out.there[i]) continue;
                const double v = theirs.values[j], z = reference.numbers[i];
                n += 1, sv += v, sz += z, svv += v * v, svz += v * z;
            }
        const double below = n * svv - sv * sv;
        if (!(below > 0)) continue;
        const double slope = (n * svz - sv * sz) / below, offset = (sz - slope * sv) / n;
        std::size_t close = 0;
        for (std::size_t y = to.top; y < to.bottom; ++y)
            for (std::size_t x = to.left; x < to.right; ++x) {
                const std::size_t i = y * reference.columns + x;
                if (!out.there[i]) continue;
                out.numbers[i] = offset + slope * out.numbers[i];
                out.slack[i] = changeAround(reference, x, y);
                close += std::abs(out.numbers[i] - reference.numbers[i]) <= tolerance + out.slack[i];
            }
        if (double(close) > explained * n) explained = double(close) / n, best = std::move(out);
    }
    return best;
}

}  // namespace pipeline::foreign
