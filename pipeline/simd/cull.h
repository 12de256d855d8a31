#pragma once
#include "pipeline/stages/cull.h"

namespace pipeline {

// Does what cull does in float, several triangles at a time, with the same bits. Polygons that are large or have to be
// clipped are done one at a time.
void cullInVectors(const CullInputs& inputs, const TransformOutput<float>& in, std::size_t begin, std::size_t end,
                   CullOutput& out);

}  // namespace pipeline
