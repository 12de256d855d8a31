#pragma once
#include <QByteArray>
#include <QObject>
#include <functional>
#include <optional>

#include "lessons/state/window_state.h"

class QMainWindow;

namespace app {

class Actions;
class CueModel;
class CuePanel;
class Document;
class ErrorList;
class LessonPanel;
class PanelDock;
class PanelDocks;
class Presentation;
class SceneFiles;
class ShownState;
class ViewArea;
class WindowLayout;

// The cues of a talk in the window: keeps, opens, saves and shows them, and presents.
class WindowCues : public QObject {
    Q_OBJECT
public:
    using Then = std::function<void()>;

    WindowCues(QMainWindow& window, Actions& actions, Document& document, const PanelDocks& docks, ViewArea& views,
               WindowLayout& layout, ShownState& shown, SceneFiles& files, Presentation& presentation,
               ErrorList& errors);

    CueModel& model() const;
    // Opens a list and shows the cue, the first where none is named. False where there is no such list or cue.
    bool open(const QString& file, const QString& name = {}, const Then& then = {});
    bool saveAs();    // false: not saved
    bool mayLeave();  // asks about changes that the list's own file cannot take
    void present();   // begins, or ends

    static QString fileFilter();

private:
    void addActions(Actions& actions);
    QString whyNotStep(int by) const;
    void connectModel();
    void reportUnread();
    void endTalk();
    std::optional<lessons::WindowState> state() const;
    void raisePanel();
    void goTo(int cue, const Then& then = {});
    void keep();
    void replaceCurrent();
    void step(int by);
    bool turnsLesson() const;  // what a clicker sends
    void beginTalk();

    QMainWindow& m_window;
    const Actions& m_actions;
    Document& m_document;
    PanelDock& m_dock;
    CuePanel& m_panel;
    LessonPanel& m_lessons;
    ViewArea& m_views;
    WindowLayout& m_layout;
    ShownState& m_shown;
    SceneFiles& m_files;
    Presentation& m_presentation;
    ErrorList& m_errors;
    std::optional<int> m_asked;  // whose scene is being read
    QByteArray m_beforeTalk;     // where the panels stood
    bool m_withNotes = true;     // on a second screen
};

}  // namespace app
