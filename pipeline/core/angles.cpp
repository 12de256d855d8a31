#include "pipeline/core/angles.h"

#include <cmath>

#include "pipeline/core/elementary.h"

namespace pipeline {
namespace {

struct Reduced {
    int quadrant;          // 0..3: how many right angles were taken off
    double radians, rest;  // what is left, within a quarter of pi, and what rounding takes off that
};

// Reduced in degrees, where 90 is exact, before the irrational factor comes in.
Reduced reduce(double degrees) {
    const double turn = std::fmod(degrees, 360.0);  // exact
    const double right = std::round(turn / 90.0);   // -4..4
    const double left = turn - 90.0 * right;        // exact
    // Products of 24 bits by 29 are exact: the rest has as many bits as the radians.
    constexpr double kPerDegree = 0x1.1df46a2529d39p-6, kHead = 0x1.1df46a2p-6, kTail = 0x1.4a74e4570763p-36;
    const double head = float(left), radians = left * kPerDegree;
    return {(static_cast<int>(right) + 8) % 4, radians,
            (head * kHead - radians) + (head * kTail + (left - head) * kPerDegree)};
}

}  // namespace

double sinDegrees(double degrees) {
    const auto [quadrant, radians, rest] = reduce(degrees);
    switch (quadrant) {
        case 0: return sinNearZero(radians, rest);
        case 1: return cosNearZero(radians, rest);
        case 2: return -sinNearZero(radians, rest);
        default: return -cosNearZero(radians, rest);
    }
}

double cosDegrees(double degrees) {
    const auto [quadrant, radians, rest] = reduce(degrees);
    switch (quadrant) {
        case 0: return cosNearZero(radians, rest);
        case 1: return -sinNearZero(radians, rest);
        case 2: return -cosNearZero(radians, rest);
        default: return sinNearZero(radians, rest);
    }
}

}  // namespace pipeline
