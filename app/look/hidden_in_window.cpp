#include "app/look/hidden_in_window.h"

#include <QWidget>

namespace app {

bool isHiddenInWindow(const QWidget& view) {
    for (const QWidget* part = &view; !part->isWindow(); part = part->parentWidget())
        if (part->isHidden()) return true;
    return false;
}

}  // namespace app
