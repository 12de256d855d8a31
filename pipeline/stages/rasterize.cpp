#include "pipeline/stages/rasterize.h"

#include <limits>

namespace pipeline {

// A difference of two coordinates is up to 2^(13 + 1 + bits), an edge function two products of such.
static_assert(2 * (13 + 1 + kSubPixelBits) + 1 < 63 && kGuardBand == double(1 << 13));

std::int64_t SnappedTriangle::area2() const { return EdgeFunction(corners[0], corners[1]).at(corners[2]); }

Tile SnappedTriangle::pixels() const {
    const glm::i64vec2 low = glm::min(corners[0], glm::min(corners[1], corners[2]));
    const glm::i64vec2 high = glm::max(corners[0], glm::max(corners[1], corners[2]));
    // The first centre at or after low, and the first one after high: floor division by shifts.
    const auto after = [](std::int64_t v) { return int((v - kSubPixels / 2 + kSubPixels - 1) >> kSubPixelBits); };
    return {{after(low.x), after(low.y)}, {after(high.x + 1), after(high.y + 1)}};
}

}  // namespace pipeline
