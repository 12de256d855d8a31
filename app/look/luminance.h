#pragma once
#include <cmath>

#include "pipeline/buffers/any_buffer.h"

namespace app {

// Relative luminance of linear red, green and blue, in their unit: Rec. ITU-R BT.709-6 (2015), item 3.2.
inline double luminance(double red, double green, double blue) { return 0.2126 * red + 0.7152 * green + 0.0722 * blue; }

// The light, 0 to 1, of a byte in an sRGB picture: IEC 61966-2-1 (1999).
inline double linearLight(int byte) {
    const double s = byte / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

// Whether a buffer's channels are red, green and blue.
bool hasLuminance(const pipeline::BufferInfo& info);
// The luminance of each element, one number instead of three, under the same name. For bytes it is that of their light,
// with 1 for white; otherwise it has the unit of the channels.
pipeline::AnyBuffer luminanceOf(const pipeline::AnyBuffer& color);

}  // namespace app
