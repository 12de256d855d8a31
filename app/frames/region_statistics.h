#pragma once
#include <QString>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "lessons/state/shown_channel.h"
#include "pipeline/buffers/any_buffer.h"

namespace app {

// A rectangle of pixels or texels, including both corners; these are in any order.
struct Region {
    glm::ivec2 a{0}, b{0};
    glm::ivec2 first() const { return glm::min(a, b); }
    glm::ivec2 last() const { return glm::max(a, b); }
    bool operator==(const Region&) const = default;
};

// The statistics of one channel in a region. Minimum, maximum, mean and standard deviation are those of the finite
// numbers; empty if there are none.
struct RegionStatistics {
    std::size_t count = 0, finite = 0, nan = 0, infinite = 0, negative = 0;
    std::optional<double> min, max, mean;
    std::optional<double> deviation;      // population standard deviation
    std::optional<std::size_t> distinct;  // finite values; empty if there are too many to count at once
};

// For the part of the region inside the buffer. The mean by B. P. Welford, "Note on a method for calculating corrected
// sums of squares and products", Technometrics, 1962.
RegionStatistics regionStatistics(const pipeline::AnyBuffer& buffer, const Region& region, int channel);

// All statistics, one line for each number and one column for each channel, with tabs between the columns for pasting
// into tables. All channels: every one of the buffer, with `names` as headings.
QString regionText(const pipeline::AnyBuffer& buffer, const Region& region, lessons::ShownChannel channel,
                   const QStringList& names);

}  // namespace app
