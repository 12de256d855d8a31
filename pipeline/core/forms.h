#pragma once
#include <cstdint>

namespace pipeline {

// In which form the stages compute what can be written in several ways: the first of each is the stable one, and the
// default. The others are how the formula is often written, or approximations of it; they are there to be looked at,
// and to measure what they cost in error and save in time. None of them lets NaN or infinity into a buffer.

// (a·b)^n of the specular term, for unit vectors; powerOfCosine in numerics.h.
enum class PowerForm : std::uint8_t {
    Log1p,     // exp(n log1p(-|a - b|²/2))
    Pow,       // pow(a·b, n): near the centre of the highlight a·b has rounded its distance from 1 away
    Squaring,  // repeated squaring of a·b; n is rounded to a whole number
    Exp2,      // exp2(n log2(a·b)), as graphics hardware computes it
    Schlick,   // t / (n - n t + t) with t = a·b. C. Schlick, "A fast alternative to Phong's specular model",
               // Graphics Gems IV, 1994
    Gaussian,  // exp(n (a·b - 1))
};

// v / |v| of normals, V, L and H; normalized in numerics.h.
enum class UnitForm : std::uint8_t {
    Scaled,    // scaled by a power of two first: right over the whole range of numbers
    Direct,    // v / sqrt(v·v), whose square overflows or underflows
    Estimate,  // v times a guess of 1 / sqrt(v·v) from its bits, within 3.44 %. C. Lomont, "Fast inverse square
               // root", 2003
    Newton,    // the guess after one of Newton's steps, within 0.176 %
    Newton2,   // after two, within 4.8e-6
};

// The normal of a polygon; polygonNormals in normals.h.
enum class PolygonNormalForm : std::uint8_t {
    Newell,       // the sum over all corners, relative to the first
    FromOrigin,   // the same sum over the coordinates as they are, which loses digits far from the origin
    ThreeCorners  // of the first three corners alone: wrong where the third corner is concave or on one line with them
};

// What takes the mesh's own normals to world space; normalMatrix in transform.h.
enum class NormalMatrixForm : std::uint8_t {
    Cofactors,         // of the object's matrix, with no division: there also for an object flattened to a plane
    InverseTranspose,  // divides by the determinant
};

// How the spherical camera's axes are found; makeView in view.h.
enum class CameraBasisForm : std::uint8_t {
    Angles,        // in closed form
    CrossProduct,  // right = forward × z, which vanishes at phi = 0 and 180
};

// The angle of a polygon at a corner, which weights its normal there.
enum class CornerAngleForm : std::uint8_t {
    Atan2,  // atan2(|a × b|, a·b)
    Acos,   // acos(a·b): 0 for angles that a·b cannot tell from 0
};

struct Forms {
    PowerForm power = PowerForm::Log1p;
    UnitForm unit = UnitForm::Scaled;
    PolygonNormalForm polygonNormal = PolygonNormalForm::Newell;
    NormalMatrixForm normalMatrix = NormalMatrixForm::Cofactors;
    CameraBasisForm cameraBasis = CameraBasisForm::Angles;
    CornerAngleForm cornerAngle = CornerAngleForm::Atan2;
    bool operator==(const Forms&) const = default;
};

}  // namespace pipeline
