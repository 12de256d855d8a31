#pragma once
#include <vector>

#include "pipeline/core/real.h"
#include "pipeline/scene/settings.h"

namespace pipeline {

// Where the samples of a pixel stand, from its centre, pixels: side² places in [-0.5, 0.5)²; one sample stands in the
// centre itself. The same in every pixel and on every machine, also where they are random: another draw has other random numbers.
//   Grid        the middles of side × side cells
//   Jittered    anywhere in each of these cells
//   Random      anywhere in the pixel
//   Hammersley  (i / N, φ2(i)), φ2 the binary digits of i mirrored at the point, moved to be centred
// Jittered: R. Cook, "Stochastic sampling in computer graphics", ACM TOG 1986. Hammersley: T. Wong, W. Luk, P. Heng,
// "Sampling with Hammersley and Halton points", Journal of Graphics Tools 1997.
std::vector<glm::dvec2> samplePlaces(SamplePattern pattern, int side, unsigned draw = 0);

}  // namespace pipeline
