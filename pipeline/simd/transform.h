#pragma once
#include <span>

#include "pipeline/stages/shadow_buffer.h"
#include "pipeline/stages/transform.h"

namespace pipeline {

// Does what transform does in float, several vertices at a time, with the same bits; also snaps them.
void transformInVectors(const TransformInputs& inputs, std::size_t object, std::size_t begin, std::size_t end,
                        TransformOutput<float>& out);

// Transforms the vertices [begin, end) into a view as toView does, then projects and snaps them as setUpTriangle does.
// world: in world space. `out` has room.
void snapInVectors(const View& view, std::span<const Vec3<float>> world, std::size_t begin, std::size_t end,
                   SnappedVertices& out);

// Does what boundsIn and largestIn do.
Bounds boundsInVectors(const View& view, std::span<const Vec3<float>> points);
float largestInVectors(std::span<const Vec3<float>> points);

}  // namespace pipeline
