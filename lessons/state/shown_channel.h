#pragma once
#include <array>
#include <string_view>

namespace lessons {

// Which of its numbers a view shows of a buffer: all as a colour or a direction, one alone, or the luminance that is made
// of red, green and blue and shown in their place.
enum class ShownChannel : signed char { All = -1, First, Second, Third, Luminance };

// In files, from First on.
inline constexpr std::array<std::string_view, 4> kShownChannels{"first", "second", "third", "luminance"};

// As a buffer counts its channels; -1 for all.
constexpr int index(ShownChannel channel) { return static_cast<int>(channel); }
// The one that is shown alone; the first where all are.
constexpr int firstOf(ShownChannel channel) { return channel == ShownChannel::All ? 0 : index(channel); }

}  // namespace lessons
