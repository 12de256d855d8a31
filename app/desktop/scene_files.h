#pragma once
#include <QObject>
#include <filesystem>
#include <functional>

#include "app/document/document.h"
#include "app/document/document_state.h"
#include "app/document/scene_opener.h"

namespace app {

class Actions;
class ErrorList;
class FileWatch;
class LessonPanel;
class Presentation;
class ShownState;
class WindowLayout;

// The scene's file: opens, reloads, saves and closes it, and asks before changes are lost. Scenes are read off the GUI
// thread; the scene before stays until then, and if reading fails or is cancelled.
class SceneFiles : public QObject {
    Q_OBJECT
public:
    using Then = std::function<void()>;  // runs once the scene is on show

    SceneFiles(QWidget& window, Actions& actions, Document& document, SceneOpener& opener, ShownState& shown,
               WindowLayout& layout, LessonPanel& lessons, const Presentation& presentation, ErrorList& errors);

    // Asks before changes to the scene on show are lost; false if it stays.
    bool open(const QString& file, const Then& then = {});
    bool openRecent(const QString& file);  // with the state that the window had when it was left
    // Asks nothing.
    void showState(const lessons::WindowState& state, const std::filesystem::path& folder, SceneChanges changes,
                   const Then& then = {});
    void reload();
    bool isReading() const { return m_opener.busy(); }
    void cancel();  // the reading
    bool save();    // false: not saved
    bool saveAs();  // likewise
    void close();
    bool mayLeave();
    bool wouldLoseChanges() const;
    bool hasChangedOutside() const;  // another program has written to the file

signals:
    void asked();           // another scene, which is read next
    void notShown();        // what was asked for
    void closed();          // the scene, by the user
    void changedOutside();  // the file

private:
    void addActions(Actions& actions);
    QString whyNotSave() const;
    void read(const QString& name, SceneOpener::Read read, std::function<void(const OpenedScene&)> take);
    void showPoint();
    void showCarriedState(const OpenedScene& picture);
    void rememberPlace();
    void takeFileChange();

    QWidget& m_window;
    Document& m_document;
    SceneOpener& m_opener;
    ShownState& m_shown;
    WindowLayout& m_layout;
    LessonPanel& m_lessons;
    const Presentation& m_presentation;
    ErrorList& m_errors;
    FileWatch* m_watch;
};

}  // namespace app
