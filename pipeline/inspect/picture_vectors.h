#pragma once
#include <optional>
#include <vector>

#include "pipeline/run/frame.h"

namespace pipeline {

// N and the first light's L at what a pixel shows, as lines in the picture, with the arc between them and the horizon: the
// circle of directions at a right angle to N. Pixels, row 0 on top.
struct PictureVectors {
    glm::dvec2 at{0.0}, N{0.0}, L{0.0};  // where they begin and end
    std::optional<glm::dvec2> H{};       // where the highlight of the surface reads it
    double nDotL = 0;
    std::vector<glm::dvec2> arc{}, horizon{};
};
// N is as long as a fifth of the picture's height where nothing shortens it. Nothing where the pixel is not lit, or not in
// the picture.
std::optional<PictureVectors> vectorsInPicture(const Frame& frame, glm::ivec2 pixel);

}  // namespace pipeline
