#include "app/views/view_links.h"

#include <QTimer>
#include <utility>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/views/active_view.h"
#include "app/views/view_grid.h"

namespace app {

ViewLinks::ViewLinks(const ViewGrid& grid, const ActiveView& active) : m_grid(grid), m_active(active) {
    connect(&grid, &ViewGrid::treeChanged, this, [this](const lessons::ViewTree& before) {
        if (isOn() && !areLinked(before, m_chosen)) leadSoon();
    });
}

void ViewLinks::add(BufferView& view) {
    connect(&view, &BufferView::bufferChanged, this, [this, &view] { join(view); });
    connect(&view.canvas()->placing(), &CanvasPlacing::moved, this, [this, &view] { lead(view); });
    connect(&view.canvas()->placing(), &CanvasPlacing::zoomChanged, this, &ViewLinks::agreeSoon);
    connect(&view.canvas()->placing(), &CanvasPlacing::resized, this, [this, &view] { join(view); });
}

bool ViewLinks::isOn() const { return areLinked(m_grid.tree(), m_chosen); }

void ViewLinks::set(bool on) {
    m_chosen = on;
    if (on) lead(m_active.buffer());
    emit changed();
}

lessons::LinkedPicture ViewLinks::pictureIn(BufferView& view) const {
    const QSize size = view.canvas()->content().size;
    if (view.parentWidget()->isHidden()) return {};
    return {size.width(), size.height(), bufferInfo(view.buffer().id).domain == pipeline::Domain::Texel};
}

void ViewLinks::lead(BufferView& view) {
    if (!isOn()) return;
    for (const auto& [number, other] : m_grid.views().buffers())
        if (other != &view && moveTogether(pictureIn(*other), pictureIn(view)))
            other->canvas()->placing().follow(view.canvas()->placing().look());
}

void ViewLinks::join(BufferView& view) {
    if (!isOn()) return;
    for (const auto& [number, other] : m_grid.views().buffers())
        if (other != &view && moveTogether(pictureIn(*other), pictureIn(view)))
            return view.canvas()->placing().follow(other->canvas()->placing().look());
}

// Once the views have their new sizes.
void ViewLinks::leadSoon() {
    m_leadsSoon = true;
    QTimer::singleShot(0, this, [this] {
        if (std::exchange(m_leadsSoon, false)) lead(m_active.buffer());
    });
}

// Whole zooms: one pixel of a view's width more, and it shows the same part a step larger.
void ViewLinks::agreeSoon() {
    if (!isOn() || std::exchange(m_agreesSoon, true)) return;
    QTimer::singleShot(0, this, [this] {
        m_agreesSoon = false;
        const BufferCanvas& leading = *m_active.buffer().canvas();
        const auto asked = leading.placing().part();
        if (!isOn() || !asked) return;
        for (const auto& [number, other] : m_grid.views().buffers()) {
            const auto its = other->canvas()->placing().part();
            const bool isSame = its && its->factor == asked->factor && its->center == asked->center;
            if (isSame && other->canvas()->placing().zoom() != leading.placing().zoom() &&
                moveTogether(pictureIn(*other), pictureIn(m_active.buffer())))
                other->canvas()->placing().follow(leading.placing().look());
        }
    });
}

}  // namespace app
