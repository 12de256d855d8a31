#pragma once
#include <QMainWindow>
#include <QTimer>
#include <functional>

#include "app/core/document.h"

class QMenu;

namespace app {

class Actions;
class BugPanel;
class CheckPanel;
class CommandPalette;
class ContractList;
class FileOpening;
class KeySheet;
class Layouts;
class ManualWindow;
class PaletteCommands;
class PanelDocks;
class PixelField;
class Presentation;
class SceneFiles;
class SceneOpener;
class Session;
class ShownState;
class StateClipboard;
class StudyPanel;
class TopBar;
class ViewArea;
class WindowCentre;
class WindowCues;
class WindowLayout;
class WindowLessons;
class WindowRenderer;

// The window: the stages on top, panels left and right, views in the middle. It makes the parts and hands them to the
// features, each of which is a class of its own.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    MainWindow();
    ~MainWindow() override;

    Document& document() { return m_document; }
    const Actions& actions() const { return *m_actions; }
    SceneOpener& opener() { return *m_opener; }
    ViewArea& views();
    PanelDocks& docks() { return *m_docks; }
    WindowLayout& windowLayout() { return *m_layout; }
    ShownState& shown() { return *m_shown; }
    SceneFiles& files() { return *m_files; }
    WindowLessons& lessons() { return *m_lessons; }
    WindowCues& cues() { return *m_cues; }
    Presentation& presentation() { return *m_presentation; }

    // Opens a file of any kind; false if the scene on show stays. `then` runs once its scene is on show.
    bool openFile(const QString& file, const std::function<void()>& then = {});
    void present();  // begins, or ends
    // Keeps the session in a folder from now on; restores the last one first, unless it is switched off.
    void startSession(const QString& folder, bool restore);

protected:
    bool focusNextPrevChild(bool next) override;
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void makeFeatures(TopBar& top);
    void connectDocument();
    // main_window_actions.cpp: what the actions do, and when they can
    void growText(double by);
    void connectActions();
    void enableActions();
    void enableCueActions();
    void enableViewActions();
    void exportBuffers(bool onlyActive);
    void exportSlide();
    void exportFilm();
    void showStudy();
    void showManual();
    void showPreferences();
    void showChecks();
    void showWrongPicture();
    void showContracts();

    Document m_document;
    SceneOpener* m_opener;
    Actions* m_actions;
    WindowCentre* m_centre;
    PanelDocks* m_docks;
    Presentation* m_presentation;
    WindowLayout* m_layout;
    Layouts* m_layouts;
    ShownState* m_shown;
    SceneFiles* m_files;
    StateClipboard* m_clipboard;
    WindowLessons* m_lessons;
    WindowRenderer* m_renderer;
    WindowCues* m_cues;
    FileOpening* m_opening;
    PaletteCommands* m_commands;
    CommandPalette* m_palette;
    KeySheet* m_keys;
    PixelField* m_pixelField;
    Session* m_session = nullptr;
    TopBar* m_top;
    QTimer m_grows;       // while it runs, steps of the text size are added up
    double m_growth = 0;  // that is still to come
    QMenu* m_recent;
    StudyPanel* m_study = nullptr;     // a window of its own; made when first asked for
    ManualWindow* m_manual = nullptr;  // likewise
    CheckPanel* m_checks = nullptr;    // likewise
    BugPanel* m_bugs = nullptr;        // likewise
    ContractList* m_contracts = nullptr;
};

}  // namespace app
