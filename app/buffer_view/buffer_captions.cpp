#include "app/buffer_view/buffer_captions.h"

#include <QLabel>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/compare/buffer_compare.h"
#include "app/look/theme.h"

namespace app {

BufferCaptions::BufferCaptions(BufferView& view, const BufferCompare& compare)
    : BufferFeature(view), m_compare(compare), m_notice(labelOver(view.canvas())), m_title(labelOver(view.canvas())) {
    m_notice->setTextFormat(Qt::RichText);
}

void BufferCaptions::setTitle(const QString& name) { m_title->setText(name); }

void BufferCaptions::show() {
    const ShownBuffer& shown = *view().shown();
    const bool isEarly = isStillDrawing(view().document().stepper());
    m_notice->setText(shown.empty.isEmpty() ? shown.notice : isEarly ? tr("Nothing is drawn yet.") : shown.empty);
    m_notice->setVisible(!m_notice->text().isEmpty());
    m_notice->setAttribute(Qt::WA_TransparentForMouseEvents, !m_notice->text().contains("href"));
}

void BufferCaptions::place(CanvasRoom& room) {
    // Fonts that are set while a label is hidden do not outlive a view that moves in the window.
    m_notice->setFont(Theme::current().text(12));
    m_title->setFont(Theme::current().text(13, 600));
    m_title->setVisible(m_bare && !m_compare.isOn());
    m_title->adjustSize();
    m_title->move(CanvasRoom::kMargin, CanvasRoom::kMargin);
    m_notice->adjustSize();
    m_notice->move(room.size.width() - m_notice->width() - CanvasRoom::kMargin - room.right, CanvasRoom::kMargin);
}

}  // namespace app
