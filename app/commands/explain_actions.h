#pragma once
#include "app/commands/actions.h"

namespace app {

class Document;
class InspectorPanel;
class ViewArea;

// Adds the actions that copy and explain the picked pixel's colour.
void addExplainActions(Actions& actions, Document& document, InspectorPanel& inspector, ViewArea& views);

}  // namespace app
