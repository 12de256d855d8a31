#pragma once
#include "pipeline/stages/normals.h"

namespace pipeline {

// Does what polygonNormals does in float, several triangles at a time, with the same bits. Other forms of Newell's
// normal, and polygons that are no triangles, are done one at a time.
void polygonNormalsInVectors(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t begin,
                             std::size_t end, NormalsOutput<float>& out);

// The same for unitVertexNormals.
void unitVertexNormalsInVectors(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t object,
                                std::size_t begin, std::size_t end, NormalsOutput<float>& out);

}  // namespace pipeline
