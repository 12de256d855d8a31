#pragma once
#include <QString>

#include <glm/glm.hpp>

#include "pipeline/buffers/any_buffer.h"

namespace app {

// "n_dot_l.0 at 268, 281: 0.70710677": every channel, whatever range or channel is on show. Each number has the fewest
// digits that give back the same number of the buffer's type. The buffer has pixels, and the pixel is inside. Where
// nothing was drawn: "n_dot_l.0 at 5, 5: nothing drawn (cleared to 0)".
QString copiedValue(const pipeline::AnyBuffer& buffer, glm::ivec2 pixel, bool isDrawn);

// "nothing drawn (cleared to 0)": an element that holds what its buffer was cleared to.
QString clearedText(const QString& stored);

// Why a picked pixel has no value in such a buffer, one sentence; empty if it has one.
QString whyNoValue(const pipeline::BufferInfo& info);

}  // namespace app
