#pragma once

namespace pipeline {

// While one lives, checkScene in this thread admits exponents above OpenGL's 128: its formula has no limit, only its call has,
// and renderers that somebody has written have none.
class AnyExponent {
public:
    AnyExponent();
    ~AnyExponent();
    AnyExponent(const AnyExponent&) = delete;
    AnyExponent& operator=(const AnyExponent&) = delete;
};

}  // namespace pipeline
