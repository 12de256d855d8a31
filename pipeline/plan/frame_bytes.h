#pragma once
#include "pipeline/plan/memory_limit.h"

namespace pipeline {

inline constexpr double kMemoryLimit = 4.0 * 1024 * 1024 * 1024;  // bytes of a run

// What a frame takes that a request is made for: the buffers of its pixels and of its lights' shadows, and what the stages
// hand on of vertices, polygons and triangles.
double frameBytes(const Scene& scene, BufferSet wanted, StageId until = StageId::Shading);

}  // namespace pipeline
