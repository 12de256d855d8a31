#pragma once
#include <QByteArray>
#include <QObject>
#include <functional>
#include <optional>

#include "lessons/state/window_state.h"

class QAction;
class QMainWindow;

namespace app {

class CueModel;
class CuePanel;
class Document;
class ErrorList;
class LessonPanel;
class PanelDock;
class PanelDocks;
class Presentation;
class SceneFiles;
class SceneOpener;
class ShownState;
class ViewArea;
class WindowLayout;

// The cues of a talk in the window: keeps, opens, saves and shows them, and presents.
class WindowCues : public QObject {
    Q_OBJECT
public:
    using Then = std::function<void()>;

    WindowCues(QMainWindow& window, Document& document, const SceneOpener& opener, const PanelDocks& docks,
               ViewArea& views, WindowLayout& layout, ShownState& shown, SceneFiles& files, Presentation& presentation,
               ErrorList& errors);

    CueModel& model() const;
    // Opens a list and shows the cue, the first where none is named. False where there is no such list or cue.
    bool open(const QString& file, const QString& name = {}, const Then& then = {});
    bool saveAs();    // false: not saved
    bool mayLeave();  // asks about changes that the list's own file cannot take
    void keep();
    void replaceCurrent();
    void step(int by);
    bool turnsLesson() const;  // what a clicker sends
    // Begins, or ends. keys: actions whose keys work in a talk too.
    void present(const QList<QAction*>& keys, bool withNotes);

    static QString fileFilter();

private:
    void connectModel();
    void reportUnread();
    void endTalk();
    std::optional<lessons::WindowState> state() const;
    void raisePanel();
    void goTo(int cue, const Then& then = {});
    void beginTalk(const QList<QAction*>& keys, bool withNotes);

    QMainWindow& m_window;
    Document& m_document;
    const SceneOpener& m_opener;
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
};

}  // namespace app
