#pragma once
#include <QObject>
#include <functional>

class QDropEvent;

namespace app {

class Actions;
class CuePanel;
class Document;
class SceneFiles;
class StartPage;
class WindowCues;
class WindowLessons;
class WindowRenderer;

// Opens a file of any kind: a scene, a lesson, a list of cues, the folder that somebody's renderer has written. The user
// names it on the command line, chooses it on the start page or in a dialog, or drops it anywhere on the window.
class FileOpening : public QObject {
    Q_OBJECT
public:
    FileOpening(QWidget& window, Actions& actions, Document& document, StartPage& start, SceneFiles& files,
                WindowLessons& lessons, WindowCues& cues, WindowRenderer& renderer, CuePanel& cuePanel);

    // `then` runs once its scene is on show. False if the scene on show stays.
    bool open(const QString& file, const std::function<void()>& then = {});
    void choose();
    // With the place in it where it was left.
    bool openRecent(const QString& file);
    // Opens a list of cues where it was left, and presents it.
    void giveTalk(const QString& file);
    void chooseTalk();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool openCues(const QString& file, const std::function<void()>& then);
    void choose(const QString& title, const QString& filters);
    bool takesDrop(QObject* watched, const QDropEvent& drop) const;
    void takeDrop(const QDropEvent& drop);

    QWidget& m_window;
    Document& m_document;
    StartPage& m_start;
    SceneFiles& m_files;
    WindowLessons& m_lessons;
    WindowCues& m_cues;
    WindowRenderer& m_renderer;
};

}  // namespace app
