#include "app/buffer_view/buffer_flip.h"

#include <QKeyEvent>
#include <QMenu>

#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"

namespace app {

FlipToggle::FlipToggle(BufferView& view) : BufferFeature(view) {
    QMenu& more = *view.header().menu();
    more.addSeparator();
    m_action = more.addAction(tr("Row 0 at the bottom\tY"));
    m_action->setCheckable(true);
    connect(m_action, &QAction::triggered, this, &FlipToggle::set);
}

void FlipToggle::set(bool flipped) {
    m_action->setChecked(flipped);
    view().canvas()->placing().setFlipped(flipped);
    view().header().setFlipped(flipped);
    view().place();
}

bool FlipToggle::press(const QKeyEvent& key) {
    if (key.key() != Qt::Key_Y) return false;
    set(!view().canvas()->placing().isFlipped());
    return true;
}

void FlipToggle::write(lessons::BufferShown& state) const { state.flipped = view().canvas()->placing().isFlipped(); }

pipeline::Errors FlipToggle::read(const lessons::BufferShown& state) {
    set(state.flipped);
    return {};
}

}  // namespace app
