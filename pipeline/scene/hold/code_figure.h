#pragma once
#include <vector>

#include "pipeline/scene/scene.h"

namespace pipeline {

// How a z-buffer of 16 bits spends its codes between a scene's near and far plane; z_view, world units.
struct CodeFigure {
    double near = 0, far = 0;
    double nearest = 0, farthest = 0;  // of the objects' vertices behind the near plane
    std::vector<double> marks;  // of every 1024th code; none for an orthographic camera, whose codes are evenly spread
    double codes = 0;           // between nearest and farthest
};
CodeFigure codeFigure(const Scene& scene);

}  // namespace pipeline
