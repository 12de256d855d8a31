#pragma once
#include <QImage>
#include <map>
#include <string>

#include "app/canvas/wipe.h"
#include "app/document/document.h"
#include "app/jobs/background_job.h"
#include "app/vtk/offscreen.h"
#include "lessons/derived_buffer.h"
#include "lessons/state/window_state.h"

namespace app {

class ViewArea;

// A picture of what the window shows, for a slide.
struct SlideRequest {
    enum class What : unsigned char { Buffer, Space, Beside };  // a buffer view, the 3D view, the two of them
    What what = What::Buffer;
    QSize size{1920, 1080};
    bool transparent = true;
    bool caption = false;  // stage and a sentence below
    bool marks = true;     // the picked pixel, pins, the selection and the region
    std::size_t view = 0;  // which of the buffer views on show, in their order
};

// What a slide shows: values alone, so that it can be drawn away from the window.
struct SlideContent {
    SlideRequest request;
    pipeline::FramePtr frame;
    lessons::WindowState state;
    std::map<std::string, lessons::DerivedBuffer> derived;  // those that are there, by name
    std::optional<CanvasPictures> compared;                 // what the buffer view shows of a comparison
    std::optional<SpacePicture> space;
    QString stage, words;  // of the caption
};
// Errors: nothing to show yet.
pipeline::Result<SlideContent> slideContent(const Document& document, const ViewArea& views,
                                            const SlideRequest& request);
// Errors: a buffer that is left out, no OpenGL for the 3D view, or it was told to stop.
pipeline::Result<QImage> drawSlide(const SlideContent& content, const BackgroundJob::Control& control);
// Both at once.
pipeline::Result<QImage> slidePicture(const Document& document, const ViewArea& views, const SlideRequest& request);

// A PNG file that carries the scene and what the window shows, so that it opens them again.
std::string slidePng(const QImage& image, const pipeline::Scene& scene, const lessons::WindowState& state);

}  // namespace app
