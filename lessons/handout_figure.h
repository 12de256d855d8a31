#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/buffers/buffer2d.h"
#include "pipeline/run/frame.h"

namespace lessons {

// The part of the picture that is worth its ink: what was drawn in one of these buffers, and the picked pixel, with a
// margin, in the picture's proportions. The whole picture where that is more than half of its width or height.
pipeline::Tile partToShow(const pipeline::Frame& frame, std::span<const pipeline::BufferName> buffers,
                          const std::optional<glm::ivec2>& pixel);

// What a page shows of a buffer, as an element figure in HTML: that part of its picture with a ring around the picked
// pixel and what its colours mean, or a table of what has no pixels; why there is none where the frame has none.
std::string figureHtml(const pipeline::Frame& frame, const pipeline::BufferName& name, pipeline::Tile part,
                       const std::optional<glm::ivec2>& pixel);

// The style sheet of these.
std::string_view figureStyle();

}  // namespace lessons
