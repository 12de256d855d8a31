#pragma once
#include <QObject>
#include <QStringList>

#include "pipeline/buffers/buffer_table.h"

namespace app {

class Actions;
class Document;
class PanelDocks;
class RendererPanel;
class SceneFiles;
class ViewArea;
class WindowLayout;
class WindowLessons;

// Somebody's own renderer in the window: its files, its panel, and the views that show mine, reference and classes.
class WindowRenderer : public QObject {
    Q_OBJECT
public:
    WindowRenderer(QWidget& window, Actions& actions, Document& document, const PanelDocks& docks, ViewArea& views,
                   WindowLayout& layout, SceneFiles& files, WindowLessons& lessons);

    // Compares the scene on show with what somebody's renderer has written: a folder, or files. Without a scene the one
    // that is in the folder is opened first.
    void check(const QStringList& paths);
    // A folder that is no lesson, or several files that are all named as buffers are.
    bool accepts(const QStringList& paths) const;

signals:
    void viewsChanged();

private:
    void addActions(Actions& actions);
    void chooseFolder();
    void chooseFiles();
    void checkChosen(QStringList paths);
    QString startFolder() const;
    void showPanel();
    void setViews();
    void showInViews(const pipeline::BufferName& buffer);
    void leave();
    void remember();

    QWidget& m_window;
    Document& m_document;
    const PanelDocks& m_docks;
    ViewArea& m_views;
    WindowLayout& m_layout;
    SceneFiles& m_files;
    WindowLessons& m_lessons;
    RendererPanel& m_panel;
    QString m_viewsBefore;  // their arrangement; empty while they are not set to the renderer
};

}  // namespace app
