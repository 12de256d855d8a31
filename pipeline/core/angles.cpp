#include "pipeline/core/angles.h"

#include <cmath>
#include <numbers>

namespace pipeline {
namespace {

struct Reduced {
    int quadrant;    // 0..3: how many right angles were taken off
    double radians;  // the rest, within a quarter of pi
};

// Reduced in degrees, where 90 is exact, before the irrational factor comes in.
Reduced reduce(double degrees) {
    const double turn = std::fmod(degrees, 360.0);  // exact
    const double right = std::round(turn / 90.0);   // -4..4
    return {(static_cast<int>(right) + 8) % 4, (turn - 90.0 * right) * (std::numbers::pi / 180.0)};
}

}  // namespace

double sinDegrees(double degrees) {
    const auto [quadrant, radians] = reduce(degrees);
    switch (quadrant) {
        case 0: return std::sin(radians);
        case 1: return std::cos(radians);
        case 2: return -std::sin(radians);
        default: return -std::cos(radians);
    }
}

double cosDegrees(double degrees) {
    const auto [quadrant, radians] = reduce(degrees);
    switch (quadrant) {
        case 0: return std::cos(radians);
        case 1: return -std::sin(radians);
        case 2: return -std::cos(radians);
        default: return std::sin(radians);
    }
}

}  // namespace pipeline
