#pragma once
#include "pipeline/stages/shading.h"

namespace pipeline {

// The arithmetic `fast` of stage 6: what shadePixels does, 4 to 16 pixels at a time, as wide as the processor's
// vectors. Multiply and add are one operation where it has one, so that bits differ between processors; every formula is shadePixels', and so is every decision but for its rounding.

// The pixels of one tile, intensity and frame buffer value; whoever wants another buffer of the pixels asks shadePixels.
// Interpolation in perspective; polygons are lit from one side. Phong shading is that of the models Phong and
// Blinn-Phong in the stable forms of their formulas, flat and Gouraud shading that of any.
ShadingCounts shadePixelsFast(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                              ShadingOutput<float>& out);

// A tile in which nothing is seen: 0 everywhere.
void leaveTileDark(Tile tile, ShadingOutput<float>& out);

// The vectors' width, pixels.
int fastLanes();

}  // namespace pipeline
