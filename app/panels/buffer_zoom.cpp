#include "app/panels/buffer_zoom.h"

#include <QKeyEvent>

#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_header.h"
#include "app/panels/buffer_view.h"

namespace app {

PictureZoom::PictureZoom(BufferView& view) : BufferFeature(view) {
    BufferCanvas* canvas = view.canvas();
    connect(&view.header(), &BufferHeader::fitChosen, canvas, &BufferCanvas::toggleFit);
    connect(&view.header(), &BufferHeader::originalChosen, canvas, [canvas] { canvas->setZoom(1); });
    connect(canvas, &BufferCanvas::zoomChanged, &view.header(), &BufferHeader::setZoom);
}

bool PictureZoom::press(const QKeyEvent& key) {
    if (key.key() != Qt::Key_F) return false;
    view().canvas()->toggleFit();
    return true;
}

// A state is looked at before its scene's frame is there: what fits is known with that frame.
void PictureZoom::show() {
    BufferCanvas& canvas = *view().canvas();
    if (m_fitsNext && canvas.look().fits) canvas.fit();
    if (view().frame()->sharedScene() == view().document().sharedScene()) m_fitsNext = false;
    view().header().setZoom(canvas.zoom());
}

void PictureZoom::showPart(const std::optional<lessons::BufferShown::Zoom>& part) {
    m_fitsNext = !part;
    view().refresh();
    view().canvas()->showPart(part);
}

void PictureZoom::write(lessons::BufferShown& state) const { state.zoom = view().canvas()->part(); }

}  // namespace app
