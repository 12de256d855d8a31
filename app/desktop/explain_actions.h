#pragma once
#include "app/desktop/actions.h"

namespace app {

class Document;
class InspectorPanel;
class ViewArea;

// What the actions do that explain the picked pixel's colour, and when they can.
void connectExplainActions(Actions& actions, Document& document, InspectorPanel& inspector, ViewArea& views);
void enableExplainActions(Actions& actions, const Document& document, InspectorPanel& inspector, bool hasScene);

}  // namespace app
