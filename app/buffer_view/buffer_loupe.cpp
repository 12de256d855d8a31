#include "app/buffer_view/buffer_loupe.h"

#include <QKeyEvent>

#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/canvas/loupe.h"

namespace app {

LoupeToggle::LoupeToggle(BufferView& view) : BufferFeature(view), m_loupe(new Loupe(view.canvas())) {
    connect(&view.header(), &BufferHeader::loupeToggled, this, &LoupeToggle::set);
}

bool LoupeToggle::isShown() const { return m_loupe->isVisibleTo(view().canvas()); }

void LoupeToggle::set(bool shown) {
    m_loupe->setVisible(shown);
    view().header().setLoupe(shown);
    view().place();
}

bool LoupeToggle::press(const QKeyEvent& key) {
    if (key.key() != Qt::Key_Z) return false;
    set(!isShown());
    return true;
}

void LoupeToggle::place(CanvasRoom& room) {
    if (isShown()) room.right = m_loupe->width() + CanvasRoom::kMargin;
    m_loupe->follow();
}

}  // namespace app
