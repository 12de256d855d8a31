#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/run/frame.h"

namespace pipeline {

// One call of fixed-function OpenGL 1.1, so that it can be written as C and carried out alike:
// names first, then numbers. The numbers of a function whose name ends in v are one array; the
// names of glClear are its bits.
struct GlCall {
    std::string_view function;            // "glLightfv"
    std::vector<std::string_view> names;  // "GL_LIGHT0", "GL_POSITION"
    std::vector<double> numbers;
    std::string comment;  // what begins here; empty within a step
};

// Why the fixed functions of OpenGL cannot draw a scene as our pipeline does; empty when they can.
std::string glRefuses(const Scene& scene);

// The calls that draw a frame's scene: every polygon, with the normals that the frame computed
// (unit, world space) brought back to its object's space. The eye space of OpenGL is our view
// space with z towards the viewer. Errors: what glRefuses() says, or that the frame has no normals.
// M. Segal and K. Akeley, "The OpenGL graphics system: a specification (version 1.5)", 2003.
Result<std::vector<GlCall>> glCalls(const Frame& frame);

// "glRotated(20, 1, 0, 0);"
std::string toC(const GlCall& call);

// A C file with the calls in one function, drawScene(), that asks glGetError after each step.
// Gives the size in bytes.
Result<std::uint64_t> writeGlC(const Frame& frame, const std::filesystem::path& file);

}  // namespace pipeline
