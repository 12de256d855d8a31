#pragma once
#include <vector>

#include "pipeline/study/picture.h"
#include "pipeline/study/study.h"

namespace pipeline {

// Which stage a picture's error comes from: how much of it is left when one stage alone is replaced by its reference.
// At each pixel the frame's intensity is taken apart into I = shade(object, position, N, S) + δ, with the frame's own
// object, position, N and S: shade is the illumination by its formula, and δ what the stage shading did otherwise, by
// evaluating at polygons or vertices, by interpolating, by clamping. Then one of them is exchanged:
//   shading        δ = 0
//   normals        N of the reference, where both see the same object
//   shadow buffer  S of the reference, where both see the same object
//   z-buffer       the reference's place where both see the same object; where not, the reference's intensity
// Transform and cull have no row: their errors move or drop what is seen, which is counted with the z-buffer.
//
// Errors are RMSE over the pixels that either of the two sees, in shares of white (I_max); nothing is black. The shares
// need not sum to 1: errors of two stages can cancel, or take effect only together. In the order of the stages; empty
// where the picture lacks a buffer, and with two-sided materials and colours of vertices, of which a picture does not say which they are.
std::vector<StageBlame> blame(const Scene& scene, const Picture& ours, const Picture& reference);

}  // namespace pipeline
