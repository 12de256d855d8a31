#pragma once
#include <span>

#include "pipeline/stages/transform.h"

namespace pipeline {

// What transform does in float, several vertices at a time, with the same bits.
void transformInVectors(const TransformInputs& inputs, std::size_t object, std::size_t begin, std::size_t end,
                        TransformOutput<float>& out);

// Projects and snaps the vertices [begin, end) as setUpTriangle does; positions in the view's space. `out` has room.
void snapInVectors(const View& view, std::span<const Vec3<float>> positions, std::size_t begin, std::size_t end,
                   SnappedVertices& out);

// Takes world-space points [begin, end) into a light's view, as toLightView does.
void toLightViewInVectors(const View& face, std::span<const Vec3<float>> world, std::size_t begin, std::size_t end,
                          std::span<Vec3<float>> out);

}  // namespace pipeline
