#pragma once
#include <QObject>

namespace app {

class Actions;
class BugPanel;
class CheckPanel;
class Document;
class KeySheet;
class ManualWindow;
class SceneFiles;
class StudyPanel;
class WindowLayout;
class WindowLessons;

// Windows and overlays of their own beside the main window's panels; each is made when it is first asked for.
class ToolWindows : public QObject {
    Q_OBJECT
public:
    ToolWindows(QWidget& window, Actions& actions, Document& document, const WindowLayout& layout, SceneFiles& files,
                WindowLessons& lessons);

private:
    void addActions(Actions& actions);
    void showStudy();
    void showChecks();
    void showWrongPicture();
    void showPreferences();
    void showKeys();
    void showManual();

    QWidget& m_window;
    Actions& m_actions;
    Document& m_document;
    const WindowLayout& m_layout;
    SceneFiles& m_files;
    WindowLessons& m_lessons;
    StudyPanel* m_study = nullptr;
    CheckPanel* m_checks = nullptr;
    BugPanel* m_bugs = nullptr;
    KeySheet* m_keys = nullptr;
    ManualWindow* m_manual = nullptr;
};

}  // namespace app
