#pragma once
#include "pipeline/core/real.h"

namespace pipeline {

// Stands three times where a vertex has no position in the picture: in perspective one that is not in front of the eye
// (z_view <= 0), in any projection one whose position Real cannot hold, and one that is not done.
inline constexpr double kNoScreenPosition = -1e30;
// Of any arithmetic's buffer, also read as another: float rounds the number.
template <class Real>
constexpr bool hasScreenPosition(Vec3<Real> screen) {
    constexpr double kRounding = 0x1p-20;
    const auto isFilled = [](Real x) {
        return x >= Real(kNoScreenPosition * (1 + kRounding)) && x <= Real(kNoScreenPosition * (1 - kRounding));
    };
    return !(isFilled(screen.x) && isFilled(screen.y) && isFilled(screen.z));
}

}  // namespace pipeline
