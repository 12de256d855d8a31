#pragma once
class QWidget;

namespace app {

// Whether a view is removed from its window for now: it wants nothing and costs nothing. False in a window that is not
// open yet.
bool isHiddenInWindow(const QWidget& view);

}  // namespace app
