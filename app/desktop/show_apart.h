#pragma once
#include <QScreen>
#include <QShortcut>
#include <QWidget>

namespace app {

// In a window of its own.
inline void showApart(QWidget& panel) {
    if (!panel.isWindow()) {
        panel.setWindowFlag(Qt::Window);
        QObject::connect(new QShortcut(QKeySequence::Close, &panel), &QShortcut::activated, &panel, &QWidget::close);
        panel.resize(QSize(1680, 1000).boundedTo(panel.screen()->availableSize()));
    }
    panel.show();
    panel.raise();
    panel.activateWindow();
}

}  // namespace app
