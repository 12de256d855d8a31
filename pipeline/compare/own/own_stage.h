#pragma once
#include "pipeline/compare/finding.h"

namespace pipeline::foreign {

// What this program's stages make of what somebody else's stages have left: it tells an error of a stage from one that it
// was handed. Inputs that were not handed in are those of the reference.
struct OwnResult {
    std::vector<std::string> from;  // the buffers of theirs that were read
    Finding finding;                // their buffer beside ours of these
};

// Of each finding, in their order; nothing where none of what its stage reads was handed in. Their numbers are looked at
// before a stage gets them: what is not finite, or so large that a stage could not be trusted with it, stays that of the
// reference.
std::vector<std::optional<OwnResult>> compareOwn(const Conventions& conventions, const std::vector<Finding>& findings,
                                                 const Reference& reference, const Stop& stop);

// For these: the buffer of a file that was handed in; null where it was not.
const Values* handedValues(const Conventions& conventions, const std::string& name);

// Shading, pixel by pixel: what the terms are with their normals, positions, shadows and dot products.
// right: the reference's values of the buffer; changed where theirs lead elsewhere. Gives the buffers that were read.
std::vector<std::string> ownShading(const Conventions& conventions, const Reference& reference,
                                    const BufferName& buffer, Values& right);

}  // namespace pipeline::foreign
