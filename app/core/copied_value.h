#pragma once
#include <QString>

#include <glm/glm.hpp>

#include "pipeline/buffers/any_buffer.h"

namespace app {

// "n_dot_l.0 at 268, 281: 0.70710677": every channel, each in the fewest digits that give back the same number of the
// buffer's type, whatever range or channel is on show. The buffer stands on pixels, and the pixel lies in it. Where nothing
// was drawn: "n_dot_l.0 at 5, 5: no value, 0 is stored".
QString copiedValue(const pipeline::AnyBuffer& buffer, glm::ivec2 pixel, bool isDrawn);

// Why a picked pixel has no value in such a buffer, one sentence; empty where it has one.
QString whyNoValue(const pipeline::BufferInfo& info);

}  // namespace app
