#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/run/frame.h"

namespace pipeline {

// Numbers that are laid over a picture of a frame.

// Per polygon the area that it has on the screen, pixels²: of what is left of it after clipping, on
// corners snapped to the sub-pixel grid; what other polygons hide counts too.
std::vector<double> screenAreas(const Frame& frame);

// How the depth tests of a pixel went.
enum class DepthTests : std::uint8_t {
    None,         // no fragment came
    OneWon,       // one came and won
    Overwritten,  // several came, each nearer than the one before: the first ones were drawn in vain
    SomeLost,     // at least one was not nearer than what was stored
};
// From overdraw and depth_writes, which the frame must hold.
std::vector<DepthTests> depthTests(const Frame& frame);

// A number that should not be there.
enum class Strange : std::uint8_t { No, Nan, Infinite, Negative };
struct StrangeNumbers {
    std::vector<Strange> elements;  // the first kind of an element's channels, in the order of the enumerators
    std::size_t nan = 0, infinite = 0, negative = 0;  // elements with at least one
};
// Whether a buffer may hold negative numbers: dot products, directions and positions may, names too, and depths in an
// orthographic view.
bool mayBeNegative(const BufferInfo& info, ProjectionKind projection);
// channel -1: all. drawn: which elements hold something; empty: all. Those that hold nothing are No.
StrangeNumbers strangeNumbers(const AnyBuffer& buffer, int channel, const std::vector<bool>& drawn,
                              ProjectionKind projection);

}  // namespace pipeline
