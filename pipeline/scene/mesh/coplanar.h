#pragma once
#include "pipeline/core/stop.h"
#include "pipeline/scene/alike_remarks.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// Remarks on objects of which polygons lie in one plane, face the same way and overlap: rounding decides at each pixel
// which of them is seen (z-fighting). Of a scene of at most kMostCoplanarTriangles; of larger ones nothing is said.
inline constexpr std::size_t kMostCoplanarTriangles = 1 << 18;
void remarkOnCoplanar(const Scene& scene, StopCheck& check, AlikeRemarks& remarks);

}  // namespace pipeline
