#pragma once
#include "pipeline/stages/cull.h"

namespace pipeline {

// What cull does in float, several triangles at a time, with the same bits; polygons that are large or to be clipped one by
// one.
void cullInVectors(const CullInputs& inputs, const TransformOutput<float>& in, std::size_t begin, std::size_t end,
                   CullOutput& out);

}  // namespace pipeline
