#pragma once
#include "pipeline/compare/handed_in/values.h"
#include "pipeline/formats/numbers/number_file.h"

namespace pipeline::foreign {

// Somebody else's shadow buffer of a light at infinity, in the frame and extent of the reference's. Right renderers turn
// the light's frame otherwise, fit it to the scene otherwise and count depth from elsewhere: the eight ways of laying one
// square on another are tried, what is drawn in both is laid over each other, and z' is fitted linearly. Nothing where no
// such frame explains most of the texels: then the buffer cannot be compared. tolerance: of z', world units.
std::optional<Values> inFrameOf(const NumberFile& theirs, const Values& reference, double tolerance);

}  // namespace pipeline::foreign
