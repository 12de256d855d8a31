#pragma once
#include <QObject>

namespace app {

class Document;
class ErrorList;
class SceneFiles;
class ShownState;

// What the window shows, copied as text and shown again from text.
class StateClipboard : public QObject {
    Q_OBJECT
public:
    StateClipboard(Document& document, ShownState& shown, SceneFiles& files, ErrorList& errors, QObject* parent);

    void copy();
    void paste();

private:
    Document& m_document;
    ShownState& m_shown;
    SceneFiles& m_files;
    ErrorList& m_errors;
};

}  // namespace app
