#pragma once
#include <QObject>

class QLabel;

namespace app {

class Document;
class SceneFiles;
class WindowLayout;
class WindowLessons;

// The name of the scene or the lesson, in the window's title and in the middle of its top.
class WindowTitle : public QObject {
    Q_OBJECT
public:
    WindowTitle(QWidget& window, QLabel& label, Document& document, const WindowLayout& layout, const SceneFiles& files,
                const WindowLessons& lessons);

private:
    void show();

    QWidget& m_window;
    QLabel& m_label;
    Document& m_document;
    const WindowLayout& m_layout;
    const SceneFiles& m_files;
    const WindowLessons& m_lessons;
};

}  // namespace app
