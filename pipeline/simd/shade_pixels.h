#pragma once
#include "pipeline/stages/shading.h"

namespace pipeline {

// Stage 6 in the processor's vectors: what shadePixels does, 4 to 16 pixels at a time. In exact arithmetic every bit is
// shadePixels'. In fast arithmetic multiply and add are one operation where the processor has one and roots are
// estimated, so that bits differ between processors; the formulas are the same, and so are the decisions but for rounding.

// The pixels of one tile, into every buffer that is there. Interpolation in perspective; polygons are lit from one side;
// formulas in their stable forms. Phong shading is that of the models Phong and Blinn-Phong; flat and Gouraud shading that
// of any model, without N, V and the vectors of lights, which no pixel has there.
ShadingCounts shadePixelsInVectors(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                                   ShadingOutput<float>& out);

// A tile in which nothing is seen: 0 everywhere.
void leaveTileDark(Tile tile, ShadingOutput<float>& out);

// The vectors' width, pixels.
int vectorLanes();

}  // namespace pipeline
