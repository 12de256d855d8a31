#pragma once
#include <span>

#include <Qt>

class QWidget;

namespace app {

class Document;

// One dock: a panel with its place. A new panel is its pair of files in app/panels and a row here.
struct PanelRow {
    const char* name;  // of the dock, in saved layouts
    const char* title;
    const char* icon;    // of resources/icons
    const char* keys;    // shows or hides it
    const char* manual;  // its page: "tables.md"
    bool showsValues;    // of buffers: a question that hides one hides the panel
    Qt::DockWidgetArea area;
    QWidget* (*make)(Document& document, QWidget* parent);
};

// Left docks from top to bottom, then right ones; those at the bottom are shown when asked for.
std::span<const PanelRow> panelTable();

}  // namespace app
