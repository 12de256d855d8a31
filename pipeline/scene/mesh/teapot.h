#pragma once
#include <array>
#include <span>

#include "pipeline/core/real.h"

namespace pipeline {

// Control points of a bicubic Bézier patch: [u][v], u along the first index.
using Patch = std::array<std::array<Vec3d, 4>, 4>;

// The ten patches that M. Newell's teapot consists of up to mirroring, z up. Mirroring y completes
// all of them; those whose x is mirrored too are quarters around the z axis. 6 · 4 + 4 · 2 = 32.
// The outside is on the side of ∂v × ∂u.
struct TeapotPatch {
    Patch points;
    bool mirrorX;
};
std::span<const TeapotPatch> teapotPatches();

}  // namespace pipeline
