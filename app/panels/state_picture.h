#pragma once
#include <QImage>
#include <stop_token>

#include "app/state/window_state.h"
#include "pipeline/run/frame.h"

namespace app {

// How a picture of a buffer is made.
struct PictureLook {
    QSize size{1280, 960};     // pixels
    bool transparent = false;  // where nothing was drawn, and around the picture
    bool marks = true;         // the picked pixel
};

// The frame that a state shows, at its place, with the buffers of its views; null when stopped. On any thread.
pipeline::FramePtr frameOf(const WindowState& state, std::shared_ptr<const pipeline::Scene> scene,
                           std::stop_token stop = {});

// A view of a state: the buffer with palette, range, overlays and the part that it shows; what is worth looking at where
// it shows what fits. Null where the frame has no such buffer.
QImage pictureOf(const pipeline::Frame& frame, const WindowState& state, const BufferShown& view,
                 const PictureLook& look);

}  // namespace app
