#pragma once
#include <QScreen>
#include <QWidget>

namespace app {

// A dialog's size, within its screen, with room for a title and a margin.
inline QSize onScreen(const QWidget& dialog, int width, int height) {
    return QSize(width, height).boundedTo(dialog.screen()->availableSize() - QSize(32, 64));
}

}  // namespace app
