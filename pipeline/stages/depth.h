#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/scene/view.h"

namespace pipeline {

// z_view to the number that the z-buffer stores, and back to what "nearer" means. In double or better, so
// that 24 and 32 bits of fixed point mean what they say when the stages compute in float.
//   perspective  d = f/(f-n) - fn/((f-n) z), reversed d = fn/((f-n) z) - n/(f-n): affine in 1/z
//   orthographic d = (z-n)/(f-n), reversed d = (f-z)/(f-n): affine in z
//   Infinite: the reversed one with f = infinity, d = n/z; orthographic as Reversed
// N. Reed, "Depth precision visualized", 2015, for what each of them keeps.

// d rounded to the nearest number of IEEE 754's 16-bit format, 0 <= d <= 1: 11 bits, down to 2^-24.
template <class W>
W roundToHalf(W d) {
    int exponent;
    frexp(d, &exponent);  // d < 2^exponent
    const int last = std::max(exponent, -13) - 11;
    // Ties go away from zero instead of to even, as in the fixed-point formats.
    return ldexp(round(ldexp(d, -last)), last);
}

struct DepthCode {
    DepthFormat format = DepthFormat::Linear;
    bool perspective = true;
    double constant = 0, factor = 0;
    double levels = 0;         // 2^bits - 1 of the fixed-point formats
    double near = 0, far = 0;  // z_view

    DepthCode(const View& view, DepthFormat depthFormat)
        : format(depthFormat), perspective(view.perspective), near(view.near), far(view.far) {
        const double n = view.near, f = view.far, range = f - n;
        const bool reversed = isReversed(format);
        const double slope = perspective ? (f / range) * n : 1 / range;
        constant = perspective ? (reversed ? -n / range : f / range) : (reversed ? f / range : -n / range);
        factor = reversed == perspective ? slope : -slope;
        if (format == DepthFormat::Infinite && perspective) constant = 0, factor = n;
        switch (format) {
            case DepthFormat::Fixed16: levels = 0xFFFF; break;
            case DepthFormat::Fixed24: levels = 0xFFFFFF; break;
            case DepthFormat::Fixed32: levels = 0xFFFFFFFFu; break;
            default: break;
        }
    }
    // z = z_view; inverseZ = 1 / z, read in perspective only.
    template <class W>
    double encode(W z, W inverseZ) const {
        if (format == DepthFormat::Linear) return double(z);
        const W d = std::clamp(W(constant) + W(factor) * (perspective ? inverseZ : z), W(0), W(1));
        if (format == DepthFormat::Half || format == DepthFormat::ReversedHalf) return double(roundToHalf(d));
        return levels > 0 ? double(round(d * W(levels)) / W(levels)) : double(float(d));
    }
    bool nearer(double a, double b) const { return isReversed(format) ? a > b : a < b; }
    // What the z-buffer is cleared to: farther than anything.
    static double cleared(DepthFormat format) {
        return isReversed(format) ? 0 : std::numeric_limits<double>::infinity();
    }
};

}  // namespace pipeline
