#pragma once
#include <QMainWindow>
#include <functional>

#include "app/document/document.h"

namespace app {

class Actions;
class FileOpening;
class PanelDocks;
class Presentation;
class SceneFiles;
class SceneOpener;
class Session;
class ShownState;
class ViewArea;
class WindowCentre;
class WindowCues;
class WindowLayout;
class WindowLessons;

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
    // Keeps the session in a folder from now on; restores the last one first, unless it is switched off.
    void startSession(const QString& folder, bool restore);

protected:
    bool focusNextPrevChild(bool next) override;
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void makeFeatures();
    void addActions();
    void connectDocument();
    void askAgain();  // whether actions can run

    Document m_document;
    SceneOpener* m_opener;
    Actions* m_actions;
    WindowCentre* m_centre;
    PanelDocks* m_docks;
    Presentation* m_presentation;
    WindowLayout* m_layout = nullptr;
    ShownState* m_shown;
    SceneFiles* m_files;
    WindowLessons* m_lessons;
    WindowCues* m_cues;
    FileOpening* m_opening;
    Session* m_session = nullptr;
};

}  // namespace app
