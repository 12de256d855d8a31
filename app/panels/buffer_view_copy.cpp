// What a BufferView copies.
#include <QApplication>
#include <QClipboard>
#include <QLabel>

#include "app/core/copied_value.h"
#include "app/core/text.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_header.h"
#include "app/panels/buffer_view.h"

namespace app {

void BufferView::observeCopies() {
    connect(m_header, &BufferHeader::moreMenuOpens, this, [this] { m_header->setValueToCopy(whyNoValue()); });
    connect(m_header, &BufferHeader::copyValueChosen, this, &BufferView::copyValue);
    connect(m_header, &BufferHeader::copyPictureChosen, this, &BufferView::copyPicture);
    connect(m_header, &BufferHeader::copyPinsChosen, this,
            [this] { QApplication::clipboard()->setText(m_pins->text()); });
    connect(m_canvas, &BufferCanvas::menuAsked, m_header, &BufferHeader::openMoreMenu);
}

QString BufferView::whyNoValue() const {
    if (!m_shown) return tr("There is no picture.");
    if (const QString why = app::whyNoValue(*m_shown->buffer.info); !why.isEmpty()) return why;
    const auto pixel = m_document.pixel();
    if (!pixel) return tr("Pick a pixel first.");
    // It lies in the scene's picture, which may be larger than the one of the frame on show.
    const bool isShown = QRect(QPoint(0, 0), m_shown->content.size).contains(pixel->x, pixel->y);
    return isShown ? QString() : tr("The picture on show does not have this pixel yet.");
}

void BufferView::copyValue() {
    if (const QString why = whyNoValue(); !why.isEmpty()) {
        emit m_document.said(why);
        return;
    }
    const glm::ivec2 pixel = *m_document.pixel();
    const QString text = copiedValue(m_shown->buffer, pixel, m_shown->hasValue({pixel.x, pixel.y}));
    QApplication::clipboard()->setText(text);
    emit m_document.said(tr("Copied: %1").arg(text));
}

void BufferView::copyPicture() {
    if (!m_shown || m_shown->content.image.isNull()) {
        emit m_document.said(tr("This buffer is no picture of pixels."));
        return;
    }
    QApplication::clipboard()->setImage(m_shown->content.image);
    emit m_document.said(tr("Copied the picture of %1.").arg(toQString(m_name.text())));
}

}  // namespace app
