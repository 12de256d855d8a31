// The keys of a BufferView that has the focus.
#include <QKeyEvent>

#include "app/core/pinned_pixels.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_compare.h"
#include "app/panels/buffer_header.h"
#include "app/panels/buffer_view.h"
#include "app/panels/condition_bar.h"
#include "app/panels/loupe.h"

namespace app {

void BufferView::takeKeys() {
    m_keysWait = !message().isEmpty();
    if (m_keysWait)
        m_header->chooser()->setFocus(Qt::ShortcutFocusReason);
    else
        m_canvas->setFocus(Qt::ShortcutFocusReason);
}

void BufferView::keyPressEvent(QKeyEvent* event) {
    if (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier)) return QWidget::keyPressEvent(event);
    const bool shift = event->modifiers() & Qt::ShiftModifier;
    if (event->key() >= Qt::Key_1 && event->key() <= Qt::Key_9) return goToPin(event->key() - Qt::Key_0);
    switch (event->key()) {
        case Qt::Key_N: return autofit(event->modifiers() & Qt::ShiftModifier);
        case Qt::Key_R: return setChannel(lessons::ShownChannel::First);
        case Qt::Key_G: return setChannel(lessons::ShownChannel::Second);
        case Qt::Key_B: return setChannel(lessons::ShownChannel::Third);
        case Qt::Key_C: return setChannel(lessons::ShownChannel::All);
        case Qt::Key_L: return shift ? setLogCounts(!kept().logCounts) : setChannel(lessons::ShownChannel::Luminance);
        case Qt::Key_F: return m_canvas->toggleFit();
        case Qt::Key_Z: return setShowLoupe(!m_loupe->isVisibleTo(m_canvas));
        case Qt::Key_Shift: return m_compare->holdOther(true);
        case Qt::Key_QuoteLeft: return event->isAutoRepeat() ? void() : m_compare->holdPrevious(true);
        case Qt::Key_Slash: return m_condition->open();
        case Qt::Key_P: return shift ? PinnedPixels::of(m_document).clear() : togglePin();
        case Qt::Key_M: return measure();
        case Qt::Key_Y: return setFlipped(!m_canvas->isFlipped());
        case Qt::Key_Escape: return m_regionShown ? setRegion({}) : QWidget::keyPressEvent(event);
        case Qt::Key_T: return compareBy(CompareMode::Blink);
        case Qt::Key_W: return compareBy(CompareMode::Wipe);
        case Qt::Key_D: return compareBy(CompareMode::Difference);
        default: QWidget::keyPressEvent(event);
    }
}

void BufferView::keyReleaseEvent(QKeyEvent* event) {
    if (event->isAutoRepeat()) return;
    if (event->key() == Qt::Key_Shift) m_compare->holdOther(false);
    if (event->key() == Qt::Key_QuoteLeft) m_compare->holdPrevious(false);
    QWidget::keyReleaseEvent(event);
}

// Without a B there is one to be picked first.
void BufferView::compareBy(CompareMode mode) {
    m_compare->source() ? m_compare->setMode(mode) : m_header->openCompareMenu();
}

}  // namespace app
