#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/buffers/buffer2d.h"
#include "pipeline/core/real.h"
#include "pipeline/study/study.h"

namespace pipeline {

// What is seen at every pixel, in double whatever it was computed in: a frame, or a reference that a
// frame is compared with. Empty buffers: the picture does not say.
struct Picture {
    glm::ivec2 size{0};                    // pixels
    Buffer2D<std::int32_t> object;         // index into Scene::objects; -1 where nothing is seen
    Buffer2D<double> zView;                // world units; infinity where nothing is seen
    Buffer2D<Vec3d> position;              // world space
    Buffer2D<Vec3d> normal;                // world space, unit; 0 where nothing is seen
    std::vector<Buffer2D<double>> shadow;  // per light, S_k: 0 in shadow, 1 lit
    Buffer2D<Vec3d> intensity;             // before it is scaled by I_max; 0 where nothing is seen
    Buffer2D<Vec3d> antialiased;           // the mean of the intensity over the whole pixel
};

// A picture to compare with, and how far it may itself be wrong.
struct Reference {
    Picture picture;
    std::string name;                 // "analytic", "polygons by rays, double", "the stages in quad"
    std::vector<ErrorRow> errorBars;  // model errors that the reference may itself have, by the measures of errors.h
    std::string errorWhy;             // how they were found: "against the same rays in long double, at 1024 pixels"
};

}  // namespace pipeline
