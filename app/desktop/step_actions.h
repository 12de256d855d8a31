#pragma once
#include "app/core/document.h"
#include "app/desktop/actions.h"
#include "app/panels/timeline.h"

namespace app {

// What the actions that step inside a frame do, and when they can.
void connectStepActions(const Actions& actions, Document& document);
// hasScene: a scene is on show.
void enableStepActions(Actions& actions, const Document& document, bool hasScene);
Timeline::Transport transportOf(const Actions& actions);

}  // namespace app
