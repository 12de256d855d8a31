#pragma once
#include <string>

#include "pipeline/scene/scene.h"

namespace pipeline {

// Whether a scene's objects can shadow themselves or each other, decided from their meshes and
// bounds before any vertex is transformed. Each gives the reason why not, one sentence, or empty
// where a shadow is possible or not ruled out.
//
// A convex object shadows only the polygons that face away, which are dark without a look-up; and
// with the bias in closed form no polygon shadows itself. Any other bias may: that is a lesson. Each
// sample of an area light is a point light in this, and facing is asked sample by sample.
std::string whyNoSelfShadow(const Scene& scene);

// For a light at infinity: every object is convex, and no two overlap seen from the light, not
// even where the filter looks at neighbouring texels.
std::string whyNoShadowBetween(const Scene& scene, const Light& light);

}  // namespace pipeline
