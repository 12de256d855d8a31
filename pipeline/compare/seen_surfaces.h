#pragma once
#include "pipeline/compare/finding.h"

namespace pipeline::foreign {

// Which stages the file's depths accuse: compares each wrong depth with the depths that the scene's polygons have at its
// pixel. Empty where they decide nothing.
//   Nearly all are depths of polygons, in one of these readings: other polygons are visible. Culling is accused if culled
//     polygons are visible, or if the missing ones are visible nowhere; otherwise the z-buffer.
//   Most are one and the same depth, of no polygon: the z-buffer is accused, whose first value it is.
//   They are of no polygon, but between the least and greatest depth of the right one: transform or z-buffer.
//   They are of no polygon, and outside that range: transform.
std::vector<StageId> stagesOfDepths(const ReadFile& file, const std::vector<Reading>& readings,
                                    const ReadingContext& context, const Reference& reference);

}  // namespace pipeline::foreign
