#pragma once
#include <QMainWindow>

namespace app {

class ViewArea;

// Panels give way, first those at the left, while views have no room. Their menu entries bring them back.
void giveViewsRoom(QMainWindow& window, const ViewArea& views);

}  // namespace app
