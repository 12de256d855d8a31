#pragma once
#include <functional>

#include "lessons/state/view_tree.h"

class QMenu;

namespace app {

class ActiveView;
class ViewEdits;

// What of the active view is saved: its buffer as files, or as a figure.
enum class SavedAs : unsigned char { Files, Figure };

// What can be done with one view, at the end of the menu of its header. `save` finds it active.
void addViewMenu(QMenu& menu, lessons::ViewLeaf leaf, ActiveView& active, ViewEdits& edits,
                 const std::function<void(SavedAs)>& save);

}  // namespace app
