#pragma once
#include <QObject>
#include <filesystem>
#include <optional>

#include "app/docks/window_layout.h"
#include "app/document/stashed_scene.h"
#include "lessons/lesson.h"

class QToolBar;

namespace app {

class Actions;
class EdgeTab;
class LessonPanel;
class SceneOpener;
class ShownState;
enum class PanelId : unsigned char;

// A lesson in the window: the user's scene is put aside, and panels that a page does not need are hidden.
class WindowLessons : public QObject {
    Q_OBJECT
public:
    WindowLessons(QMainWindow& window, Actions& actions, Document& document, SceneOpener& opener,
                  const WindowCentre& centre, const AroundViews& around, const PanelDocks& docks, WindowLayout& layout,
                  ShownState& shown, const Presentation& presentation);

    void open(const QString& name);
    // One that stands anywhere, by its folder. False when it cannot be read.
    bool openAt(const std::filesystem::path& folder);
    void openPage(const QString& lesson, const QString& heading);

    bool isOpen() const { return m_aside.has_value(); }
    QString name() const;   // of the open lesson, for the window's title
    QString title() const;  // of the open lesson, and what became of the user's scene
    // What the window showed before the lesson; nothing for the start page.
    const std::optional<lessons::WindowState>& stateBefore() const { return m_aside->state; }

signals:
    void begins();   // the user's scene is still on show
    void changed();  // which lesson is open, or its parts on show

private:
    void makeBanner();
    void makeEdge();
    void listOnStartPage();
    void show();
    void begin();
    void end();
    void showParts();
    void remember() const;
    void sizePanels();

    QMainWindow& m_window;
    Document& m_document;
    SceneOpener& m_opener;
    const WindowCentre& m_centre;
    AroundViews m_around;
    const PanelDocks& m_docks;
    LessonPanel& m_lessons;
    WindowLayout& m_layout;
    ShownState& m_shown;
    const Presentation& m_presentation;
    QToolBar* m_edge;  // where the inspector opens again
    EdgeTab* m_inspectorTab;
    // What the window was before the lesson that is open; nothing outside of a lesson.
    struct Before {
        std::optional<StashedScene> scene = {};  // nothing: the start page
        std::optional<lessons::WindowState> state = {};
        lessons::WindowState looks = {};  // stage, steps and views, also of a window without a scene
        QList<PanelId> panels = {};       // that were on show
        bool thumbnails = true;
    };
    std::optional<Before> m_aside;
};

}  // namespace app
