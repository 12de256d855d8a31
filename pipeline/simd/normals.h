#pragma once
#include "pipeline/stages/normals.h"

namespace pipeline {

// What polygonNormals does in float, several triangles at a time, with the same bits; every other form of Newell's
// normal, and polygons that are no triangles, one by one.
void polygonNormalsInVectors(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t begin,
                             std::size_t end, NormalsOutput<float>& out);

// And unitVertexNormals.
void unitVertexNormalsInVectors(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t object,
                                std::size_t begin, std::size_t end, NormalsOutput<float>& out);

}  // namespace pipeline
