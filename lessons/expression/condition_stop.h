#pragma once
#include <functional>

#include "lessons/expression/condition.h"
#include "pipeline/steps/steps.h"

namespace lessons {

// A moment at which a condition begins to hold at a pixel: right after the pixel was drawn or shaded.
struct ConditionStop {
    pipeline::Moment moment;
    glm::ivec2 pixel{0};
};
// share: of what may have to be looked at, 0 to 1.
using StopProgress = std::function<void(double share)>;

// The first such moment after `from`. In the z-buffer stage, where the condition reads no buffer of a later one, that
// of a fragment that makes it hold where it did not hold before; in the shading stage the first pixel shaded for which
// it holds in the end. Nothing where none comes, or when stopped. The frame of `steps` holds the condition's buffers.
// Looks at the state after every polygon of the z-buffer stage, so that many polygons take their time.
std::optional<ConditionStop> nextStop(const pipeline::Steps& steps, pipeline::Moment from, const Expression& condition,
                                      const pipeline::Stop& stop = {}, const StopProgress& progress = {});

}  // namespace lessons
