#include "app/core/put_away.h"

#include <QWidget>

namespace app {

bool isPutAway(const QWidget& view) {
    for (const QWidget* part = &view; !part->isWindow(); part = part->parentWidget())
        if (part->isHidden()) return true;
    return false;
}

}  // namespace app
