#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/stages/view.h"

namespace pipeline {

// z_view to the number that the z-buffer stores, and back to what "nearer" means.
//   perspective  d = f/(f-n) - fn/((f-n) z), reversed d = fn/((f-n) z) - n/(f-n): affine in 1/z
//   orthographic d = (z-n)/(f-n), reversed d = (f-z)/(f-n): affine in z
template <class Real>
struct DepthCode {
    DepthFormat format = DepthFormat::Linear;
    bool perspective = true;
    Real constant = 0, factor = 0;
    Real levels = 0;  // 2^bits - 1 of the fixed-point formats

    DepthCode(const View& view, DepthFormat depthFormat) : format(depthFormat), perspective(view.perspective) {
        const double n = view.near, f = view.far, range = f - n;
        const bool reversed = format == DepthFormat::Reversed;
        const double offset = perspective ? (reversed ? -n / range : f / range) : (reversed ? f / range : -n / range);
        const double slope = perspective ? (f / range) * n : 1 / range;
        constant = Real(offset);
        factor = Real(reversed == perspective ? slope : -slope);
        levels = Real(format == DepthFormat::Fixed16 ? 65535 : format == DepthFormat::Fixed24 ? 16777215 : 0);
    }
    // z = z_view; inverseZ = 1 / z, read in perspective only.
    Real encode(Real z, Real inverseZ) const {
        if (format == DepthFormat::Linear) return z;
        const Real d = std::clamp(constant + factor * (perspective ? inverseZ : z), Real(0), Real(1));
        return levels > 0 ? std::round(d * levels) / levels : d;
    }
    bool nearer(Real a, Real b) const { return format == DepthFormat::Reversed ? a > b : a < b; }
    // What the z-buffer is cleared to: farther than anything.
    static Real cleared(DepthFormat format) {
        return format == DepthFormat::Reversed ? Real(0) : std::numeric_limits<Real>::infinity();
    }
};

}  // namespace pipeline
