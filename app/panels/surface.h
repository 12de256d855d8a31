#pragma once
#include <QFrame>
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

}  // namespace app
