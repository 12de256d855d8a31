#pragma once
#include "app/desktop/popover.h"

namespace app {

class Actions;

// The keys, by region: those of the menus from the table of actions, then those of the views.
class KeySheet : public Popover {
    Q_OBJECT
public:
    KeySheet(const Actions& actions, QWidget* window);

    void open() { Popover::open(this); }
};

}  // namespace app
