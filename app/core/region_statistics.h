#pragma once
#include <QString>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "lessons/state/shown_channel.h"
#include "pipeline/buffers/any_buffer.h"

namespace app {

// A rectangle of pixels or texels; both corners belong to it, in any order.
struct Region {
    glm::ivec2 a{0}, b{0};
    glm::ivec2 first() const { return glm::min(a, b); }
    glm::ivec2 last() const { return glm::max(a, b); }
    bool operator==(const Region&) const = default;
};

// What one channel of a buffer holds in a region. Minimum, maximum, mean and standard deviation are
// of the finite numbers, and nothing where there are none.
struct RegionStatistics {
    std::size_t count = 0, finite = 0, nan = 0, infinite = 0, negative = 0;
    std::optional<double> min, max, mean;
    std::optional<double> deviation;      // of all the numbers: divided by their count
    std::optional<std::size_t> distinct;  // finite values; nothing where there are too many to count at once
};

// The part of the region that lies in the buffer; nothing counts outside. The mean by B. P. Welford,
// "Note on a method for calculating corrected sums of squares and products", Technometrics, 1962.
RegionStatistics regionStatistics(const pipeline::AnyBuffer& buffer, const Region& region, int channel);

// All of them, one line a number, one column a channel; tabs between the columns, as tables are pasted.
// All channels: every one that the buffer has, by `names`.
QString regionText(const pipeline::AnyBuffer& buffer, const Region& region, lessons::ShownChannel channel,
                   const QStringList& names);

}  // namespace app
