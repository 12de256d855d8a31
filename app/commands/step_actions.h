#pragma once
#include "app/commands/actions.h"
#include "app/document/document.h"
#include "app/stages/timeline.h"

namespace app {

// Adds the actions that step inside a frame.
void addStepActions(Actions& actions, Document& document);
Timeline::Transport transportOf(const Actions& actions);

}  // namespace app
