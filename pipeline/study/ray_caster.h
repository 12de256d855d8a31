#pragma once
#include <optional>
#include <string>

#include "pipeline/core/stop.h"
#include "pipeline/study/picture.h"
#include "pipeline/study/ray_scene.h"

namespace pipeline {

// References by rays: what is seen at each pixel's centre, and how bright it is, by formulas that share no code with the
// stages. With exact surfaces every pixel is shaded with the true normal and shadowed by rays to the lights; against it
// a picture shows what polygons, shading method and shadow buffers cost. With the scene's polygons, shaded as its
// settings ask, a picture differs in rounding, in vertices snapped to the sub-pixel grid and in sampled shadows alone.

// Why there is no such reference for a scene, a clause: "of the teapot no closed form is known". Empty where there is one.
std::string whyNoRays(const Scene& scene, RaySurfaces surfaces);

// The scene must have passed checkScene, and whyNoRays is empty. threads 0: as many as the machine has. Nothing when it
// was stopped. The error bars: the same measures against the same rays in long double, with twice the squares of an
// area light, on a share of the pixels, where both see the same object.
std::optional<Reference> rayCast(const Scene& scene, RaySurfaces surfaces, int threads, Stop stop = {});

// Adds what antialiasing is compared with: the mean over each pixel. Where something changes from a pixel to its
// neighbours, another object, another normal, a shadow, it is taken over 987 rays, elsewhere over 16. Its error
// bars are what 610 rays make, on a share of the pixels. False when it was stopped.
bool castWholePixels(const Scene& scene, RaySurfaces surfaces, int threads, Stop stop, Reference& reference);

}  // namespace pipeline
