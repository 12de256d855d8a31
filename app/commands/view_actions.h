#pragma once

namespace app {

class Actions;
class ViewArea;

// Adds the actions of the views, and the menus that the active buffer view has above its picture.
void addViewActions(Actions& actions, ViewArea& views);

}  // namespace app
