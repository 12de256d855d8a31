#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lessons/questions/hidden.h"
#include "pipeline/buffers/buffer2d.h"
#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"

namespace lessons {

// The frame that half a page shows: `frame`, or the moment of it that the page's place names. Null when stopped.
pipeline::FramePtr frameShown(const PageState& state, const pipeline::FramePtr& frame, const pipeline::Stop& stop);

// The part of the picture that is worth its ink: what was drawn in one of these buffers, and the picked pixel, with a
// margin, in the picture's proportions. The whole picture where that is more than half of its width or height.
pipeline::Tile partToShow(const pipeline::Frame& frame, std::span<const pipeline::BufferName> buffers,
                          const std::optional<glm::ivec2>& pixel);

// What a page shows of a buffer, as an element figure in HTML: that part of its picture with a ring around the picked
// pixel and what its colours mean, or a table of what has no pixels; why there is none where the frame has none. note:
// before its name, as of a comparison; may be empty. look: its palette's range and the channel that is shown alone.
std::string figureHtml(const pipeline::Frame& frame, const pipeline::BufferName& name, pipeline::Tile part,
                       const std::optional<glm::ivec2>& pixel, const BufferShown& look = {},
                       std::string_view note = {});

// All figures of half a page, but for hidden buffers: of its views, with what they are compared with beside them.
// Derived buffers are made; rays take their time.
std::string figuresHtml(const PageState& state, const pipeline::FramePtr& frame, const Hidden& hidden,
                        const pipeline::Stop& stop);

// What a picture shows, in a sentence or two for somebody who does not see it.
std::string pictureSentence(const pipeline::AnyBuffer& buffer, pipeline::Tile part,
                            const std::optional<glm::ivec2>& pixel);

// The style sheet of these, and that of a page for paper around them.
std::string_view figureStyle();
std::string_view paperStyle();

}  // namespace lessons
