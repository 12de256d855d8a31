#pragma once
class QWidget;

namespace app {

// Whether a view is left out of its window for now: it wants nothing, and costs nothing. A window that is not open yet
// is no such case.
bool isPutAway(const QWidget& view);

}  // namespace app
