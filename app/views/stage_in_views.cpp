#include "app/views/stage_in_views.h"

#include <algorithm>
#include <utility>

#include "app/buffer_view/buffer_view.h"
#include "app/document/document.h"
#include "app/frames/stage_buffer.h"
#include "app/views/view_grid.h"

namespace app {

using pipeline::BufferName;

std::vector<BufferName> StageInViews::useful(bool inside) const {
    return usefulBuffers(m_document.stage(), m_document.scene(), inside);
}

void StageInViews::showStage() {
    if (!m_document.hasScene()) return;
    m_inside = m_document.stepper().isInside();
    const auto buffers = useful(m_inside);
    const bool isFree = arrangementName(m_grid.tree()).empty();
    std::size_t next = 0;
    for (BufferView* view : m_grid.views().buffersFrom(m_grid.tree())) {
        if (next == 0 || !isFree || view->parentWidget()->isHidden()) view->setBuffer(buffers[next % buffers.size()]);
        ++next;
    }
}

void StageInViews::followStepper() {
    const bool isInside = m_document.stepper().isInside();
    if (std::exchange(m_inside, isInside) != isInside) showInside();
}

void StageInViews::showInside() {
    if (!m_document.hasScene() || !m_inside) return;
    const auto buffers = useful(true);
    std::size_t next = 0;
    for (BufferView* view : m_grid.views().buffersFrom(m_grid.tree())) {
        if (bufferInfo(view->buffer().id).stage > m_document.stage()) view->setBuffer(buffers[next % buffers.size()]);
        ++next;
    }
}

void StageInViews::begin(BufferView& view) const {
    if (!m_document.hasScene()) return;
    const auto buffers = useful(m_document.stepper().isInside());
    view.setBuffer(buffers[std::min(m_grid.views().buffers().size(), buffers.size()) - 1]);
}

void StageInViews::showAnother(BufferView& view) const {
    if (!m_document.hasScene()) return;
    std::vector<BufferName> taken;
    for (const lessons::ViewLeaf leaf : leavesOf(m_grid.tree()))
        if (leaf.kind == lessons::ViewLeaf::Kind::Buffer)
            taken.push_back(m_grid.views().buffers().at(leaf.number)->buffer());
    for (const BufferName& name : useful(m_document.stepper().isInside()))
        if (std::ranges::count(taken, name) == 0) return view.setBuffer(name);
}

}  // namespace app
