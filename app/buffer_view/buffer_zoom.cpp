#include "app/buffer_view/buffer_zoom.h"

#include <QKeyEvent>

#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"

namespace app {

PictureZoom::PictureZoom(BufferView& view) : BufferFeature(view) {
    BufferCanvas* canvas = view.canvas();
    connect(&view.header(), &BufferHeader::fitChosen, &canvas->placing(), &CanvasPlacing::toggleFit);
    connect(&view.header(), &BufferHeader::originalChosen, canvas, [canvas] { canvas->placing().setZoom(1); });
    connect(&canvas->placing(), &CanvasPlacing::zoomChanged, &view.header(), &BufferHeader::setZoom);
}

bool PictureZoom::press(const QKeyEvent& key) {
    if (key.key() != Qt::Key_F) return false;
    view().canvas()->placing().toggleFit();
    return true;
}

// A state is looked at before its scene's frame is there: what fits is known with that frame.
void PictureZoom::show() {
    BufferCanvas& canvas = *view().canvas();
    if (m_fitsNext && canvas.placing().look().fits) canvas.placing().fit();
    if (showsScene()) m_fitsNext = false;
    view().header().setZoom(canvas.placing().zoom());
}

void PictureZoom::showPart(const std::optional<lessons::BufferShown::Zoom>& part) {
    m_fitsNext = !part;
    view().refresh();
    view().canvas()->placing().showPart(part);
}

void PictureZoom::write(lessons::BufferShown& state) const { state.zoom = view().canvas()->placing().part(); }

}  // namespace app
