#pragma once
#include <QLayout>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QWidget>
#include <algorithm>

namespace app {

// A dialog's size, within its screen, with room for a title and a margin.
inline QSize onScreen(const QWidget& dialog, int width, int height) {
    return QSize(width, height).boundedTo(dialog.screen()->availableSize() - QSize(32, 64));
}

// A dialog's fields: it asks for the room to show them whole. Where the screen has less they scroll, and the dialog's
// buttons stay in reach.
class FieldsArea : public QScrollArea {
public:
    FieldsArea(QWidget* fields, QWidget* dialog) : QScrollArea(dialog) {
        setProperty("kind", "fields");
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus);
        setWidgetResizable(true);
        setWidget(fields);
    }
    QSize sizeHint() const override { return widget()->sizeHint() + QSize(verticalScrollBar()->sizeHint().width(), 0); }
};

// Of a dialog with such an area: all of it, and at least so wide, where its screen has the room.
inline QSize wholeOnScreen(QWidget& dialog, int width) {
    for (QWidget* part : dialog.findChildren<QWidget*>()) part->ensurePolished();  // fonts and margins of the style
    dialog.layout()->invalidate();
    const QSize all = dialog.layout()->sizeHint();
    return onScreen(dialog, std::max(width, all.width()), all.height());
}

}  // namespace app
