#pragma once
#include <span>

#include "pipeline/simd/incidence.h"

namespace pipeline {

// Runs stage 6 again in a tile with kept light, with SIMD. The inputs may differ from those of the kept light only in
// the factors of materials and lights. Then the output has the bits of shadePixelsInVectors. looks: of the new inputs,
// for each object. Returns false if the kept data does not suffice, and the tile has to be shaded: a material's
// highlight has another form, or terms were 0 before and so no shadow was looked up.
bool relightInVectors(const ShadingInputs& inputs, std::span<const Look> looks, const Incidence& kept, Tile tile,
                      ShadingOutput<float>& out, ShadingCounts& counts);

}  // namespace pipeline
