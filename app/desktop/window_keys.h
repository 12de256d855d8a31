#pragma once
#include <QObject>

class QKeyEvent;

namespace app {

class Actions;
class Document;
class SceneFiles;
class SceneOpener;
class WindowLayout;

// Keys that work wherever the focus is, and keys that nothing has taken.
class WindowKeys : public QObject {
    Q_OBJECT
public:
    WindowKeys(QWidget& window, Document& document, const Actions& actions, const WindowLayout& layout,
               const SceneOpener& opener, SceneFiles& files);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool takeKey(QObject* watched, QKeyEvent& key);
    void takeLeftKey(const QKeyEvent& key);

    QWidget& m_window;
    Document& m_document;
    const Actions& m_actions;
    const WindowLayout& m_layout;
    const SceneOpener& m_opener;
    SceneFiles& m_files;
};

}  // namespace app
