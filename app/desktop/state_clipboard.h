#pragma once
#include <QObject>

namespace app {

class Actions;
class Document;
class ErrorList;
class SceneFiles;
class ShownState;

// What the window shows, copied as text and shown again from text.
class StateClipboard : public QObject {
    Q_OBJECT
public:
    // The keys work in `pages` alone: tables and formulas copy themselves.
    StateClipboard(QWidget& pages, Actions& actions, Document& document, ShownState& shown, SceneFiles& files,
                   ErrorList& errors);

private:
    void copy();
    void paste();

    Document& m_document;
    ShownState& m_shown;
    SceneFiles& m_files;
    ErrorList& m_errors;
};

}  // namespace app
