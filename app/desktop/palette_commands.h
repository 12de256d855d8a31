#pragma once
#include <QObject>
#include <vector>

#include "app/commands/command_palette.h"

class QMenu;
class QWidget;

namespace pipeline {
struct SettingRef;
}

namespace app {

class Actions;
class Document;
class FileOpening;
class Layouts;
class PanelDocks;
class ShownState;
class ViewArea;
class WindowLayout;
class WindowLessons;

// What the command palette finds: actions, panels, buffers, settings, lessons and scenes.
class PaletteCommands : public QObject {
    Q_OBJECT
public:
    PaletteCommands(QWidget& window, Document& document, Actions& actions, PanelDocks& docks, ViewArea& views,
                    WindowLayout& layout, Layouts& layouts, ShownState& shown, WindowLessons& lessons,
                    FileOpening& opening);

private:
    std::vector<PaletteEntry> all();
    void addActionCommands(std::vector<PaletteEntry>& all);
    void addViewCommands(std::vector<PaletteEntry>& all);
    void addSettingCommands(std::vector<PaletteEntry>& all);
    void showSideBySide(const pipeline::SettingRef& setting);

    QWidget& m_window;
    Document& m_document;
    Actions& m_actions;
    PanelDocks& m_docks;
    ViewArea& m_views;
    WindowLayout& m_layout;
    Layouts& m_layouts;
    ShownState& m_shown;
    WindowLessons& m_lessons;
    FileOpening& m_opening;
    QMenu* m_compareMenu = nullptr;  // what there is to compare with
};

}  // namespace app
