#pragma once
#include <cstdint>

// Ways of a defect that change another text than its way 0 does: indices into the row's otherWays, plus 1.
namespace pipeline {

inline constexpr std::uint8_t kTheOtherWay = 1;        // of trs-order: objects turn the other way
inline constexpr std::uint8_t kAlongTheLight = 1;      // of cull-axis: the light's direction for the line of sight
inline constexpr std::uint8_t kHighlightInShadow = 2;  // of ambient-in-shadow: the highlight is left in it
inline constexpr std::uint8_t kBlockedAlone = 3;       // of ambient-in-shadow: not of what faces away from the light
inline constexpr std::uint8_t kPositionToo = 1;        // of affine: V and S are those of another place
inline constexpr std::uint8_t kOneDistance = 1;        // of half-angle: divided by the distance of the target
inline constexpr std::uint8_t kExchangedDepths = 2;    // of z-affine: weights of two vertices exchanged, of depths too
inline constexpr std::uint8_t kDividedTwice = 3;       // of z-affine: the depth of 0 to 1 is divided by z again
inline constexpr std::uint8_t kNdcDividedTwice = 4;    // of z-affine: the depth of −1 to 1 is
inline constexpr std::uint8_t kPowerOfNegative = 4;    // of exponent: NaN, so that the pixel is black
inline constexpr std::uint8_t kFourByFour = 1;         // of blocks-of-four: blocks of 4 × 4 pixels
inline constexpr std::uint8_t kUntouched = 6;          // of normal-matrix: no matrix at all
inline constexpr std::uint8_t kGivenUntouched = 7;     // the same of given normals alone, not of those of polygons
inline constexpr std::uint8_t kOneVertex = 2;          // of normal-short, and those below
inline constexpr std::uint8_t kMeanNotUnit = 3;        // normals of vertices are left as means
inline constexpr std::uint8_t kAlike = 4;              // the vertices of a triangle count alike
inline constexpr std::uint8_t kSortedAlone = 5;        // vertices are sorted by y, their normals are not
inline constexpr std::uint8_t kExchanged = 6;          // the weights of two vertices are exchanged

}  // namespace pipeline
