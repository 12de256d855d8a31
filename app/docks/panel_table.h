#pragma once
#include <optional>
#include <span>

#include <Qt>

#include "lessons/lesson.h"

class QWidget;

namespace app {

class CuePanel;
class Document;
class InspectorPanel;
class LessonPanel;
class PanelDocks;
class RendererPanel;
class SceneTree;
class SettingsPanel;
class ViewArea;

enum class PanelId : unsigned char { Scene, Settings, Lesson, Cues, Renderer, Inspector, Algorithm, Tables, Section };

// The panels that other parts of the window use, each by its name.
struct Panels {
    SceneTree* scene = nullptr;
    SettingsPanel* settings = nullptr;
    LessonPanel* lesson = nullptr;
    CuePanel* cues = nullptr;
    RendererPanel* renderer = nullptr;
    InspectorPanel* inspector = nullptr;
};

// What panels are made from. `panels` has the panels of the rows before.
struct PanelNeeds {
    Document& document;
    ViewArea& views;
    PanelDocks& docks;
    Panels& panels;
};

// One dock: a panel with its place. A new panel is its pair of files in the room of its feature, its id and its row here.
struct PanelRow {
    PanelId id;
    const char* name;  // of the dock, in saved layouts
    const char* title;
    const char* icon;                   // of resources/icons
    const char* keys;                   // shows or hides it
    const char* manual;                 // its page: "tables.md"
    std::optional<lessons::Part> part;  // its name in lessons, which show it or hide it
    bool showsValues;                   // of buffers: a question that hides one hides the panel
    Qt::DockWidgetArea area;
    QWidget* (*make)(const PanelNeeds& needs, QWidget* parent);
};

// In the order of the ids: left docks from top to bottom, then right ones; those at the bottom are shown when asked for.
std::span<const PanelRow> panelTable();

}  // namespace app
