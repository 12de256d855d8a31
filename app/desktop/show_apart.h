#pragma once
#include <QShortcut>
#include <QWidget>

#include "app/widgets/on_screen.h"

namespace app {

// In a window of its own.
inline void showApart(QWidget& panel) {
    if (!panel.isWindow()) {
        panel.setWindowFlag(Qt::Window);
        QObject::connect(new QShortcut(QKeySequence::Close, &panel), &QShortcut::activated, &panel, &QWidget::close);
        panel.resize(onScreen(panel, 1680, 1000));
    }
    panel.show();
    panel.raise();
    panel.activateWindow();
}

}  // namespace app
