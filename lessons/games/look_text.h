#pragma once
#include <string>
#include <vector>

#include "pipeline/run/frame.h"

namespace lessons {

// What a buffer of a frame holds, in words and numbers for somebody who does not see it: its range, how long its unit
// vectors are, for how many elements the stage's contracts hold, and a table of the first elements, or of some pixels. Why there is
// none where the frame has none. Several lines, each ends in a line feed.
std::string lookText(const pipeline::Frame& frame, const pipeline::BufferName& name);

// What the inspector says of a pixel, without its remarks on what may be wrong there.
std::string lookText(const pipeline::Frame& frame, glm::ivec2 pixel);

// Of its channels: r g b, x y z, or the three weights; none of a single number.
std::vector<std::string> channelNames(const pipeline::BufferInfo& info);

std::string numberText(double value);  // in four digits, "+∞"

}  // namespace lessons
