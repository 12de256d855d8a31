#pragma once
#include "pipeline/stages/translucent.h"

namespace pipeline {

// Stage 6 with SIMD: does what shadePixels does, for 4 to 16 pixels at a time. In exact arithmetic it gives the bits of
// shadePixels. In fast arithmetic it uses fused multiply-add where the CPU has it, and estimates roots, so bits differ
// between CPUs. The formulas and decisions are the same, except for rounding.

// Shades the pixels of one tile and writes every buffer that `out` has room for. Supports perspective interpolation,
// one-sided lighting and the stable forms of the formulas. Phong shading supports the models in kModelKernels.
// Flat and Gouraud shading support every model, but not N, V and the vectors of lights, which pixels do not have there.
ShadingCounts shadePixelsInVectors(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                                   ShadingOutput<float>& out);

// shadeLayers, with SIMD where many pixels of a tile have a layer.
void shadeLayersInVectors(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                          std::span<const Layer<float>> layers, ShadingOutput<float>& out,
                          std::span<Vec3<float>> intensities, ShadingCounts& counts);

// A tile in which nothing was drawn: 0 everywhere.
void leaveTileDark(Tile tile, ShadingOutput<float>& out);

// Number of SIMD lanes, one pixel each.
int vectorLanes();

}  // namespace pipeline
