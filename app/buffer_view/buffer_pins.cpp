#include "app/buffer_view/buffer_pins.h"

#include <QApplication>
#include <QClipboard>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <algorithm>

#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_readout.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/frames/pinned_pixels.h"
#include "app/look/theme.h"

namespace app {

PinMarks::PinMarks(BufferView& view, const PixelReadout& readout)
    : BufferFeature(view),
      m_pins(view.document().pointing().pins()),
      m_readout(readout),
      m_label(labelOver(view.canvas())) {
    QMenu& more = *view.header().menu();
    more.addAction(tr("Copy the pinned values"), this, &PinMarks::copy);
    more.addSeparator();
    more.addAction(tr("Pin the picked pixel\tP"), this, &PinMarks::toggle);
    more.addAction(tr("Remove all pins\tShift+P"), &m_pins, &PinnedPixels::clear);
    m_label->setAccessibleName(tr("Pinned pixels"));
    connect(&m_pins, &PinnedPixels::changed, this, [this] {
        show();
        this->view().place();
    });
}

bool PinMarks::press(const QKeyEvent& key) {
    if (key.key() >= Qt::Key_1 && key.key() <= Qt::Key_9) return goTo(key.key() - Qt::Key_0), true;
    if (key.key() != Qt::Key_P) return false;
    key.modifiers() & Qt::ShiftModifier ? m_pins.clear() : toggle();
    return true;
}

void PinMarks::toggle() {
    Document& document = view().document();
    const auto pixel = document.pointing().pixel();
    if (!view().isOfPixels()) return;
    if (!pixel) {
        emit document.said(tr("Pick a pixel first."));
        return;
    }
    if (!m_pins.toggle(*pixel))
        emit document.said(tr("All nine pins are in use. P on a pinned pixel removes its pin."));
}

void PinMarks::goTo(int number) {
    if (const auto pixel = m_pins.pin(number)) view().document().pointing().pick(*pixel);
}

void PinMarks::copy() const { QApplication::clipboard()->setText(m_label->text()); }

void PinMarks::show() {
    std::vector<std::pair<int, QPoint>> marks;
    QStringList lines;
    if (view().shown() && view().isOfPixels())
        for (int number = 1; number <= PinnedPixels::kMost; ++number)
            if (const auto pixel = m_pins.pin(number)) {
                marks.emplace_back(number, QPoint(pixel->x, pixel->y));
                lines << QString("%1  %2").arg(number).arg(m_readout.at(marks.back().second));
            }
    view().canvas()->setPinned(std::move(marks));
    m_label->setText(lines.join('\n'));
    m_label->setVisible(!lines.isEmpty());
}

void PinMarks::place(CanvasRoom& room) {
    m_label->setFont(Theme::current().mono(12));
    m_label->adjustSize();
    m_label->move(CanvasRoom::kMargin, room.bottom - m_label->height() - CanvasRoom::kMargin);
    if (m_label->isVisibleTo(view().canvas())) room.left = std::max(room.left.value_or(0), m_label->geometry().right());
}

}  // namespace app
