#pragma once
#include <QMainWindow>
#include <QTimer>
#include <functional>

#include "app/core/document.h"
#include "app/core/document_state.h"
#include "app/core/scene_aside.h"

class QLabel;
class QMenu;
class QKeyEvent;
class QStackedWidget;
class QToolBar;

namespace app {

class Actions;
class CheckPanel;
class CuePanel;
class CommandPalette;
class EdgeTab;
class ErrorList;
class FileWatch;
class KeySheet;
class LessonPanel;
class ManualWindow;
class PanelDock;
class PixelField;
class RendererPanel;
class Presentation;
class SceneOpener;
class Session;
class StageStrip;
class StartPage;
class StatusLine;
class StudyPanel;
class Timeline;
class ViewArea;
struct PaletteEntry;

// The window: the stages on top, panels left and right, views in the middle. It puts the panels
// together and turns actions into intents; what is shown, the Document knows.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    MainWindow();
    ~MainWindow() override;

    Document& document() { return m_document; }
    ViewArea& views() { return *m_views; }
    const Actions& actions() const { return *m_actions; }

    // Scenes are read away from the window; the one before stays until then, and where reading fails or is cancelled. What
    // goes wrong stands in the error list. `then` follows once the scene is on show.
    using Then = std::function<void()>;
    // Asks before changes to the scene on show are lost; false where it is to stay.
    bool openFile(const QString& file, const Then& then = {});
    bool openRecent(const QString& file);  // where the window stood when it was left
    SceneOpener& opener() { return *m_opener; }
    // What the window shows, its scene named from `folder`; nothing on the start page, or where the scene is too large.
    std::optional<lessons::WindowState> state(const std::filesystem::path& folder) const;
    // Asks nothing.
    void showState(const lessons::WindowState& state, const std::filesystem::path& folder, SceneChanges changes,
                   const Then& then = {});
    // Opens a list and shows the cue, the first where none is named. False where there is no such list or cue.
    bool openCues(const QString& file, const QString& name = {}, const Then& then = {});
    void present();  // begins, or ends
    Presentation& presentation() { return *m_presentation; }
    CuePanel& cues() { return *m_cues; }
    // Keeps the session in a folder from now on; restores the last one first, unless it is switched off.
    void startSession(const QString& folder, bool restore);
    void openLesson(const QString& name);
    // One that stands anywhere, by its folder. False when it cannot be read, or the scene on show is to stay.
    bool openLessonAt(const std::filesystem::path& folder);
    // Compares the scene on show with what somebody's renderer has written: a folder, or files. Without a scene the one
    // that is in the folder is opened first.
    void checkRenderer(const QStringList& paths);
    void growText(double by);
    void showStartPage();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    // main_window.cpp: the parts and how they hang together
    void makeTop();
    void makeCentre();
    void makeDocks();
    void makeTimeline();
    void connectDocument();
    void showTitle();
    void showSetting(const QString& key);
    void takeFileChange();
    void takeLeftKey(const QKeyEvent& key);
    void showScene();
    bool dropsHere(QObject* watched, QEvent& event);
    // main_window_actions.cpp: what the actions do, and when they can
    void connectActions();
    void enableActions();
    void chooseFile();
    bool saveScene();    // false: not saved
    bool saveSceneAs();  // likewise
    void exportBuffers(bool onlyActive);
    void showStudy();
    void showManual();
    void showPreferences();
    void showChecks();
    // main_window_commands.cpp: what the palette finds
    static constexpr std::size_t kMostSideBySide = 8;
    std::vector<PaletteEntry> commands();
    void addActionCommands(std::vector<PaletteEntry>& all);
    void addViewCommands(std::vector<PaletteEntry>& all);
    void addSettingCommands(std::vector<PaletteEntry>& all);
    void showSideBySide(const pipeline::SettingRef& setting);
    // main_window_state.cpp: what is on show, and leaving it
    bool showsScene() const;
    bool mayLeaveScene();
    bool wouldLoseChanges() const;
    void showPoint();
    void closeScene();
    void readAgain();
    void rememberWhere();
    void openScene(const QString& name,
                   std::function<pipeline::Result<OpenedScene>(const pipeline::ReadProgress&)> read,
                   std::function<void(const OpenedScene&)> take);
    void cancelOpening();
    void showCarriedState(const OpenedScene& picture);
    void lookAt(const lessons::WindowState& state);
    Document::Looks looksTo(const lessons::WindowState& next);
    void copyState();
    void pasteState();
    void exportSlide();
    void exportFilm();
    // main_window_lesson.cpp: a lesson, with the user's scene put aside
    void connectLessons();
    void showLessons();
    void showLesson();
    void beginLesson();
    void endLesson();
    void showLessonParts();
    QString lessonTitle() const;
    QString whyHidden(const QString& panel) const;  // until a question is answered; empty where it is not
    // main_window_renderer.cpp: somebody else's renderer, contracts and wrong pictures
    void connectRenderer();
    void chooseRenderer(bool folder);
    bool isRendererDrop(const QStringList& paths) const;
    void showRenderer();
    void setViewsToRenderer();
    void showInViews(const pipeline::BufferName& buffer);
    void leaveRenderer();
    void showWrongPicture();
    void showContracts();
    void goToLessonPage(const QString& lesson, const QString& heading);
    // main_window_cues.cpp: cues, and presenting
    void connectCues();
    void enableCueActions();
    std::optional<lessons::WindowState> cueState() const;
    void keepCue();
    bool saveCuesAs();  // false: not saved
    bool mayLeaveCues();
    void raiseCues();
    void goToCue(int cue, const Then& then = {});
    void stepCue(int by);
    bool turnsLesson() const;  // what a clicker sends
    void beginPresenting();
    // main_window_layout.cpp: what stands where in which width
    enum class Width { Narrow, Medium, Wide };  // below 1100, below 1440, from there on
    Width widthClass() const;
    void fitWidth(bool always);
    void fitLetters();
    void keepPanels() const;
    void resetLayout();
    void connectLayouts();
    void enableViewActions();
    void applyLayout(const char* arrangement, bool thumbnails);
    void applyKeptLayout(const QString& name);
    void keepThisLayout();
    void tabDocks();
    void followAlgorithm();
    void showOneLeftDock(PanelDock* shown);

    Document m_document;
    SceneOpener* m_opener;
    std::optional<int> m_cueAsked;  // whose scene is being read
    Actions* m_actions;
    FileWatch* m_file = nullptr;  // what other programs do to the scene's
    QLabel* m_title;
    StageStrip* m_strip;
    ErrorList* m_errors;
    QStackedWidget* m_pages;
    StartPage* m_start;
    ViewArea* m_views;
    StatusLine* m_status;
    LessonPanel* m_lessons = nullptr;
    // What the window was before the lesson that is open; nothing outside of a lesson.
    struct BeforeLesson {
        std::optional<SceneAside> scene = {};  // nothing: the start page
        std::optional<lessons::WindowState> state = {};
        QStringList panels = {};  // that were on show
        bool thumbnails = true;
    };
    std::optional<BeforeLesson> m_aside;
    QLabel* m_banner;  // over the views: what to click
    QToolBar* m_edge;
    EdgeTab* m_inspectorTab;
    QTimer m_grows;       // while it runs, steps of the letters' size are added up
    double m_growth = 0;  // that is still to come
    QToolBar* m_rail;
    QToolBar* m_timelineBar;
    Timeline* m_timeline;
    QMenu* m_recent;
    QList<PanelDock*> m_leftDocks, m_sideDocks, m_docks;  // each a part of the next
    CommandPalette* m_palette;
    QMenu* m_compareMenu = nullptr;  // what the palette finds to compare with
    KeySheet* m_keys;
    PixelField* m_pixelField;
    CuePanel* m_cues;
    RendererPanel* m_renderer;
    QString m_viewsBeforeRenderer;  // their arrangement; empty while they are not set to it
    Presentation* m_presentation;
    bool m_presents = false;  // from before it begins to after it has ended
    QByteArray m_beforeTalk;  // where the panels stood
    Session* m_session = nullptr;
    StudyPanel* m_study = nullptr;     // a window of its own; made when first asked for
    ManualWindow* m_manual = nullptr;  // likewise
    CheckPanel* m_checks = nullptr;    // likewise
    std::optional<Width> m_width;      // as last laid out; nothing on the start page
    double m_dockScale = 1;            // of the letters' size that the panels' widths are for
};

}  // namespace app
