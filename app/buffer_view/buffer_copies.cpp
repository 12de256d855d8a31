#include "app/buffer_view/buffer_copies.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>

#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_view.h"
#include "app/frames/copied_value.h"
#include "app/look/text.h"

namespace app {

BufferCopies::BufferCopies(BufferView& view) : BufferFeature(view) {
    QMenu& more = *view.header().menu();
    QAction* value = more.addAction(tr("Copy value\tAlt+C"), this, &BufferCopies::copyValue);
    more.addAction(tr("Copy picture"), this, &BufferCopies::copyPicture);
    connect(&more, &QMenu::aboutToShow, this, [this, value] {
        const QString whyNot = whyNoValue();
        value->setEnabled(whyNot.isEmpty());
        value->setToolTip(whyNot.isEmpty() ? tr("The picked pixel's value, with its name and place") : whyNot);
    });
}

QString BufferCopies::whyNoValue() const {
    const auto& shown = view().shown();
    if (!shown) return tr("There is no picture.");
    if (const QString why = app::whyNoValue(*shown->buffer.info); !why.isEmpty()) return why;
    const auto pixel = view().document().pointing().pixel();
    if (!pixel) return tr("Pick a pixel first.");
    // It lies in the scene's picture, which may be larger than the one of the frame on show.
    const bool isShown = QRect(QPoint(0, 0), shown->content.size).contains(pixel->x, pixel->y);
    return isShown ? QString() : tr("The picture on show does not have this pixel yet.");
}

void BufferCopies::copyValue() {
    Document& document = view().document();
    if (const QString why = whyNoValue(); !why.isEmpty()) {
        emit document.said(why);
        return;
    }
    const glm::ivec2 pixel = *document.pointing().pixel();
    const ShownBuffer& shown = *view().shown();
    const QString text = copiedValue(shown.buffer, pixel, shown.hasValue({pixel.x, pixel.y}));
    QApplication::clipboard()->setText(text);
    emit document.said(tr("Copied: %1").arg(text));
}

void BufferCopies::copyPicture() {
    Document& document = view().document();
    const auto& shown = view().shown();
    if (!shown || shown->content.image.isNull()) {
        emit document.said(tr("This buffer is no picture of pixels."));
        return;
    }
    QApplication::clipboard()->setImage(shown->content.image);
    emit document.said(tr("Copied the picture of %1.").arg(toQString(view().buffer().text())));
}

}  // namespace app
