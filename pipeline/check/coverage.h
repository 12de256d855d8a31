#pragma once
#include <array>
#include <vector>

#include "pipeline/check/scenes.h"

// Which pixels triangles cover, decided without any of the stages.
namespace pipeline::check {

using ScreenTriangle = std::array<glm::dvec2, 3>;  // pixels, y down

// The triangles of a mesh as pixelScene shows them.
std::vector<ScreenTriangle> onScreen(const Mesh& mesh, int height);

// How often each pixel of a picture is covered, row by row: corners are multiples of 1/subPixels, edge functions 128
// bit wide, a centre on an edge belongs to the triangle right of a left edge or below a top one.
std::vector<int> exactCoverage(const std::vector<ScreenTriangle>& triangles, glm::ivec2 size, int subPixels = 256);

// The usual A x + B y + C in float, from corners that are not snapped; `inclusive`: what is 0 counts. `offset`: where
// in a larger picture, in x and in y, the pixels stand.
std::vector<int> floatCoverage(const std::vector<ScreenTriangle>& triangles, glm::ivec2 size, bool inclusive,
                               double offset = 0);

// The overdraw buffer of a frame.
std::vector<int> overdrawOf(const FramePtr& frame);

// Pixels in which two coverages differ; that differ from a number.
double differing(const std::vector<int>& a, const std::vector<int>& b);
double differing(const std::vector<int>& a, int expected);

}  // namespace pipeline::check
