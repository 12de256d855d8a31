#include "app/buffer_view/buffer_compare_choice.h"

#include <QKeyEvent>

#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_overlays.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/compare/buffer_compare.h"
#include "app/compare/compare_bar.h"
#include "app/compare/compare_menu.h"
#include "app/compare/stage_differences.h"
#include "app/document/renderer_check.h"

namespace app {

CompareChoice::CompareChoice(BufferView& view)
    : BufferFeature(view),
      m_compare(new BufferCompare(view.document(), view.canvas(), &view)),
      m_stages(new StageDifferences(view.document(), *m_compare, &view)) {
    connect(&view.header(), &BufferHeader::compareMenuOpens, this, [this](QMenu* menu) {
        fillCompareMenu(*menu, *m_compare, this->view().document(), this->view().buffer());
    });
    connect(m_compare, &BufferCompare::changed, &view, &BufferView::refresh);
    connect(m_compare, &BufferCompare::chosen, &view, &BufferView::takeKeys);
    connect(m_compare, &BufferCompare::busyChanged, this, &CompareChoice::busyChanged);
    connect(m_compare, &BufferCompare::stagesChosen, this, [this] {
        const CompareBar& bar = *m_compare->bar();
        m_stages->open(bar.mapToGlobal(bar.rect().bottomRight()));
    });
    connect(m_stages, &StageDifferences::chosen, this, [this](const pipeline::StageDifference& difference) {
        this->view().setBuffer(difference.buffer);
        m_compare->goToWorst();
    });
}

void CompareChoice::letGo() {
    m_compare->holdOther(false);
    m_compare->holdPrevious(false);
}

void CompareChoice::compareBy(CompareMode mode) {
    m_compare->source() ? m_compare->setMode(mode) : view().header().openCompareMenu();
}

bool CompareChoice::press(const QKeyEvent& key) {
    switch (key.key()) {
        case Qt::Key_Shift: return m_compare->holdOther(true), true;
        case Qt::Key_QuoteLeft:
            // The stage before may have what a page asks for.
            if (!key.isAutoRepeat() && view().document().hidden().count() == 0) m_compare->holdPrevious(true);
            return true;
        case Qt::Key_T: return compareBy(CompareMode::Blink), true;
        case Qt::Key_W: return compareBy(CompareMode::Wipe), true;
        case Qt::Key_D: return compareBy(CompareMode::Difference), true;
        default: return false;
    }
}

void CompareChoice::release(const QKeyEvent& key) {
    if (key.key() == Qt::Key_Shift) m_compare->holdOther(false);
    if (key.key() == Qt::Key_QuoteLeft) m_compare->holdPrevious(false);
}

// After the mix, which stands in the buffer's place.
void CompareChoice::addTo(ShowRequest& request) {
    if (m_compare->isMine() && takesOverlays(*request.buffer.info))
        request.mine = view().document().renderer().report();
    m_compare->addOther(request);
}

void CompareChoice::write(lessons::BufferShown& state) const { state.compared = m_compare->state(); }
pipeline::Errors CompareChoice::read(const lessons::BufferShown& state) { return m_compare->lookAt(state.compared); }

bool CompareChoice::busy() const { return m_compare->difference().showing().busy(); }
void CompareChoice::cancel() { m_compare->difference().showing().cancel(); }
void CompareChoice::retry() { m_compare->difference().showing().retry(); }

}  // namespace app
