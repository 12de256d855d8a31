#pragma once
#include <memory>
#include <string>
#include <vector>

#include "pipeline/export/buffers/gl_calls.h"

namespace twin {

// What OpenGL drew, row 0 on top.
struct GlPicture {
    glm::ivec2 size{0};
    std::vector<pipeline::Color8> color;
    std::vector<double> depth;  // 0 to 1, a multiple of 1 / (2^24 - 1); 1 where nothing was drawn
    std::vector<int> polygon;   // counted as glBegin comes; -1 where nothing was drawn
    std::string error;          // the first call that glGetError complains of; empty: none
    std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(size.x) + std::size_t(x); }
};

// An OpenGL with fixed functions, and a picture of its own to draw into: no display, no window.
class GlContext {
public:
    // Null where there is none; `whyNot` then says what is missing.
    static std::unique_ptr<GlContext> make(std::string& whyNot);
    virtual ~GlContext() = default;

    virtual std::string renderer() const = 0;  // "llvmpipe (LLVM 15.0.6, 256 bits)"
    virtual std::string version() const = 0;   // "4.5 (Core Profile) Mesa 22.3.6"
    virtual int subPixelBits() const = 0;      // as it says itself
    // Carries the calls out twice: lit, and with a colour per polygon.
    virtual GlPicture draw(const std::vector<pipeline::GlCall>& calls, glm::ivec2 size) = 0;
};

}  // namespace twin
