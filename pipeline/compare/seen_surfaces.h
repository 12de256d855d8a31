#pragma once
#include "pipeline/compare/finding.h"

namespace pipeline::foreign {

// The stages that depths which differ speak of; none where they do not. Nearly all of theirs are those
//   of polygons, in one of these readings. Then other ones are seen: culling is wrong where culled ones are seen, or where
//     those in front are seen nowhere else; the z-buffer is where they are;
//   of no polygon, most of them the same: the z-buffer begins with it;
//   of no polygon, but in the range of the one that belongs there: vertices are elsewhere, or depths are made otherwise;
//   of no polygon, and in no such range: vertices are elsewhere.
std::vector<StageId> stagesOfDepths(const ReadFile& file, const std::vector<Reading>& readings,
                                    const ReadingContext& context, const Reference& reference);

}  // namespace pipeline::foreign
