#pragma once
#include <QFrame>
#include <QScrollArea>
#include <QVBoxLayout>

namespace app {

// The frame that a part of a window of its own stands on.
inline QFrame* surface(QWidget* content, QWidget* parent) {
    auto* frame = new QFrame(parent);
    frame->setProperty("kind", "panel");
    auto* column = new QVBoxLayout(frame);
    column->setContentsMargins(1, 1, 1, 1);
    column->addWidget(content);
    return frame;
}

// A part that scrolls up and down where there is no height for it.
inline QScrollArea* scrolling(QWidget* content, QWidget* parent) {
    auto* area = new QScrollArea(parent);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(content);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return area;
}

}  // namespace app
