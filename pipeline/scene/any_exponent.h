#pragma once

namespace pipeline {

// While one lives, checkScene in this thread admits exponents above 128 with OpenGL's model. The limit belongs to the call
// glMaterial, not to the formula, and a student's renderer has none.
class AnyExponent {
public:
    AnyExponent();
    ~AnyExponent();
    AnyExponent(const AnyExponent&) = delete;
    AnyExponent& operator=(const AnyExponent&) = delete;
};

}  // namespace pipeline
