#pragma once
#include <string>

#include "pipeline/run/frame.h"
#include "tests/twin/gl_context.h"

namespace twin {

// How our frame differs from what OpenGL drew. A pixel is interior where its 3 × 3 neighbourhood
// is of one polygon, the same in both pictures.
struct Comparison {
    long interior = 0;
    int color = 0;           // the largest difference on interior pixels, of 255
    glm::ivec2 colorAt{-1};  // where
    double depth = 0;        // the largest difference on interior pixels, of the range 0 to 1
    double depthShare = 0;   // the same, as a share of its bound there
    glm::ivec2 depthAt{-1};
    long edge = 0;      // pixels with a neighbour of another polygon, in ours
    long coverage = 0;  // pixels of another polygon than OpenGL's
    long astray = 0;    // of these, those that no edge explains
    std::string text() const;
};

// The frame's depth format is Fixed24, and its picture as large as OpenGL's.
Comparison compare(const pipeline::Frame& frame, const GlPicture& gl);

// Both colours of a pixel and our equation of it, light by light and term by term.
std::string explain(const pipeline::Frame& frame, const GlPicture& gl, glm::ivec2 pixel);

}  // namespace twin
