#pragma once
#include "lessons/state/view_tree.h"

class QMenu;

namespace app {

class ViewArea;

// What can be done with one view of the area, at the end of the menu of its header.
void addViewMenu(QMenu* menu, ViewArea& area, lessons::ViewLeaf leaf);

}  // namespace app
