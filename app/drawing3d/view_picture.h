#pragma once
#include <vector>

#include "pipeline/core/real.h"

namespace app {

// A picture for a plane in a 3D view. Row 0 on top.
struct Picture {
    glm::ivec2 size{0};
    std::vector<pipeline::Color8> pixels;
};

}  // namespace app
