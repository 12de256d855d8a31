#pragma once
#include <QImage>
#include <functional>
#include <stop_token>

#include "app/panels/wipe.h"
#include "lessons/derived_buffer.h"
#include "lessons/state/window_state.h"
#include "pipeline/run/frame.h"

namespace app {

// How a picture of a buffer is made.
struct PictureLook {
    QSize size{1280, 960};     // pixels
    bool transparent = false;  // where nothing was drawn, and around the picture
    bool marks = true;         // the picked pixel
    // Derived buffers that are there already, null where one is not; empty: they are made, however long that takes.
    std::function<const lessons::DerivedBuffer*(const pipeline::BufferName& name)> known{};
    const CanvasPictures* compared = nullptr;  // what a comparison shows in place of the buffer alone
};

// The frame that a state shows, at its place, with the buffers of its views; null when stopped. On any thread.
pipeline::FramePtr frameOf(const lessons::WindowState& state, std::shared_ptr<const pipeline::Scene> scene,
                           std::stop_token stop = {});

// A view of a state: the buffer with palette, range, overlays and the part that it shows; what is worth looking at where
// it shows what fits. Null where the frame has no such buffer, or when stopped. On any thread; rays take their time.
QImage pictureOf(const pipeline::Frame& frame, const lessons::WindowState& state, const lessons::BufferShown& view,
                 const PictureLook& look, const std::stop_token& stop = {});

}  // namespace app
