#pragma once
#include <QImage>
#include <string>

#include "app/core/document.h"
#include "app/state/window_state.h"

namespace app {

class ViewArea;

// A picture of what the window shows, for a slide.
struct SlideRequest {
    enum class What : unsigned char { First, Second, Space, Beside };  // a buffer view, the other, the 3D view, two
    What what = What::First;
    QSize size{1920, 1080};
    bool transparent = true;
    bool caption = false;  // stage and a sentence below
    bool marks = true;     // the picked pixel
};

// Errors: nothing to show yet, a buffer that is left out, no OpenGL for the 3D view.
pipeline::Result<QImage> slidePicture(const Document& document, ViewArea& views, const SlideRequest& request);

// A PNG file that carries the scene and what the window shows, so that it opens them again.
std::string slidePng(const QImage& image, const Document& document, const WindowState& state);

}  // namespace app
