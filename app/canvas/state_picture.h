#pragma once
#include <QImage>
#include <functional>
#include <stop_token>

#include "app/canvas/shown_buffer.h"
#include "app/canvas/wipe.h"
#include "lessons/derived_buffer.h"
#include "lessons/state/window_state.h"
#include "pipeline/run/frame.h"

namespace app {

// How a picture of a buffer is made.
struct PictureLook {
    QSize size{1280, 960};     // pixels
    bool transparent = false;  // where nothing was drawn, and around the picture
    bool marks = true;         // the picked pixel, pins, the selection and the region
    // Derived buffers that are there already, null where one is not; empty: they are made, however long that takes.
    std::function<const lessons::DerivedBuffer*(const pipeline::BufferName& name)> known{};
    const CanvasPictures* compared = nullptr;  // what a comparison shows in place of the buffer alone
    // How much larger lines and text are than on the screen, where a view shows what fits; 0: by the picture's height.
    double growth = 0;
};

// The frame that a state shows, at its place, with the buffers of its views; null when stopped. On any thread.
pipeline::FramePtr frameOf(const lessons::WindowState& state, std::shared_ptr<const pipeline::Scene> scene,
                           std::stop_token stop = {});

// The buffer that a view of a state shows, with palette, range and overlays. Nothing if the frame has no such buffer,
// or if stopped. On any thread; casting rays takes seconds.
std::optional<ShownBuffer> shownOf(const pipeline::Frame& frame, const lessons::WindowState& state,
                                   const lessons::BufferShown& view, const PictureLook& look,
                                   const std::stop_token& stop = {});

// The same as a picture, or what look.compared has: the part that the view shows, or what is worth looking at where it
// shows what fits. Null as above.
QImage pictureOf(const pipeline::Frame& frame, const lessons::WindowState& state, const lessons::BufferShown& view,
                 const PictureLook& look, const std::stop_token& stop = {});

}  // namespace app
