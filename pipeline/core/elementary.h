#pragma once
#include <cmath>

namespace pipeline {

// Elementary functions in operations that IEEE 754 rounds alike everywhere (+ − · / sqrt, and exact ones), so that a
// frame has the same bits on every machine: a library chooses its own by the processor, and they change from version to
// version. Nothing is multiplied and added at once; the project is compiled with -ffp-contract=off.
// Special values are those of C (ISO/IEC 9899, annex F). Bounds are in units in the last place of a normal result, one
// more below; tests/unit/numerics/elementary_test.cpp measures them over two million arguments each.

// Of x + rest radians, |x + rest| <= pi/4, |rest| at most half a unit in the last place of x.
double sinNearZero(double x, double rest);  // within 0.8
double cosNearZero(double x, double rest);  // within 0.6

double exp(double x);                      // within 0.75
double exp2(double x);                     // within 0.75
double log(double x);                      // within 0.51
double log2(double x);                     // within 0.51
double pow(double base, double exponent);  // within 0.75
double atan2(double y, double x);          // within 0.51
double acos(double x);                     // within 0.51

// In double with an error below 2^-40 of the result, and rounded: within 0.5001 units of a float.
float log2(float x);
float pow(float base, float exponent);
float atan2(float y, float x);
float acos(float x);
inline float exp(float x) { return float(exp(double(x))); }
inline float exp2(float x) { return float(exp2(double(x))); }

// Extended precision keeps the library's, like Quad (pipeline/core/quad.h): references on the machine that computes
// them, whose last bits may differ elsewhere.
inline long double exp(long double x) { return std::exp(x); }
inline long double exp2(long double x) { return std::exp2(x); }
inline long double log1p(long double x) { return std::log1p(x); }
inline long double log2(long double x) { return std::log2(x); }
inline long double pow(long double base, long double exponent) { return std::pow(base, exponent); }
inline long double atan2(long double y, long double x) { return std::atan2(y, x); }
inline long double acos(long double x) { return std::acos(x); }

}  // namespace pipeline
