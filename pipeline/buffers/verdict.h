#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pipeline {

// What culling says of a polygon: why it goes on, or why not.
enum class Verdict : std::uint8_t {
    Kept,
    BackFacing,
    Degenerate,
    OutsideNear,
    OutsideFar,
    OutsideLeft,
    OutsideRight,
    OutsideTop,
    OutsideBottom,
    Clipped,      // kept, and cut by the near or the far plane
    Transparent,  // its object's opacity is 0
    NotYet,       // the stage has not come to it: only while stepping inside the stage
};
inline constexpr std::size_t kVerdictCount = 12;
std::string_view name(Verdict verdict);  // "back-facing", "outside the left plane"
char letter(Verdict verdict);            // K, B, D, O, C, T; - while there is none yet
constexpr bool goesOn(Verdict v) { return v == Verdict::Kept || v == Verdict::Clipped; }

}  // namespace pipeline
