#pragma once
#include <span>

#include "pipeline/simd/incidence.h"

namespace pipeline {

// Stage 6 again in a tile whose light has been kept, in the processor's vectors: what shadePixelsInVectors leaves, bit by
// bit, for inputs that differ from those it was kept with in nothing but what it is multiplied with. looks: of these
// inputs, per object. False where what was kept does not suffice: a material has a highlight of another form, or terms
// that were 0 where it looked no shadow up. Then the tile has to be shaded.
bool relightInVectors(const ShadingInputs& inputs, std::span<const Look> looks, const Incidence& kept, Tile tile,
                      ShadingOutput<float>& out, ShadingCounts& counts);

}  // namespace pipeline
