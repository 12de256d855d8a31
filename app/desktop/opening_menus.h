#pragma once
#include <QObject>

#include "app/jobs/background_job.h"

class QMenu;

namespace app {

class Actions;
class Document;
class FileOpening;
class LessonShelf;
class SceneFiles;
class StartPage;
class WindowLessons;

// What can be opened, in menus and among the tools of the start page: recent files, the program's scenes, a new scene of
// one shape, the cameras of a glTF file, talks, lessons, and pages of drill.
class OpeningMenus : public QObject {
    Q_OBJECT
public:
    OpeningMenus(QWidget& window, Actions& actions, Document& document, StartPage& start, FileOpening& opening,
                 SceneFiles& files, WindowLessons& lessons, const LessonShelf& shelf);

private:
    void fillMenus(const Actions& actions);
    void addTools(StartPage& start, const Actions& actions);
    void fillRecent(QMenu& menu);
    void fillTalks(QMenu& menu);
    void fillShapes(QMenu& menu);
    void fillCameras(QMenu& menu);
    void fillLessons(QMenu& menu, std::size_t lecture);
    void makeDrill();

    QWidget& m_window;
    Document& m_document;
    FileOpening& m_opening;
    SceneFiles& m_files;
    WindowLessons& m_lessons;
    const LessonShelf& m_shelf;
    QMenu* m_talks;
    BackgroundJob m_drill, m_cameras;
};

}  // namespace app
