#include "app/desktop/window_title.h"

#include <QLabel>
#include <QUndoStack>

#include "app/desktop/scene_files.h"
#include "app/desktop/window_lessons.h"
#include "app/docks/window_layout.h"
#include "app/document/document.h"
#include "app/look/shown_name.h"

namespace app {

WindowTitle::WindowTitle(QWidget& window, QLabel& label, Document& document, const WindowLayout& layout,
                         const SceneFiles& files, const WindowLessons& lessons)
    : QObject(&window),
      m_window(window),
      m_label(label),
      m_document(document),
      m_layout(layout),
      m_files(files),
      m_lessons(lessons) {
    connect(&document, &Document::sceneOpened, this, &WindowTitle::show);
    connect(document.history().stack(), &QUndoStack::indexChanged, this, &WindowTitle::show);
    connect(document.history().stack(), &QUndoStack::cleanChanged, this, &WindowTitle::show);
    connect(&layout, &WindowLayout::changed, this, &WindowTitle::show);
    connect(&files, &SceneFiles::changedOutside, this, &WindowTitle::show);
    connect(&lessons, &WindowLessons::changed, this, &WindowTitle::show);
}

void WindowTitle::show() {
    const bool shown = m_layout.showsScene();
    const QString name = shown ? onOneLine(m_document.scene().name) : QString();
    const QString edited = shown && m_document.history().isEdited() ? tr(" · edited") : QString();
    const QString written = shown && m_files.hasChangedOutside() ? tr(" · its file has changed (F5)") : QString();
    const QString lesson = m_lessons.name();
    m_label.setText(lesson.isEmpty() ? name + edited + written : m_lessons.title());
    const QString what = lesson.isEmpty() ? name : lesson;
    QString title = (what.isEmpty() ? QString() : what + QStringLiteral(" – ")) + QStringLiteral("Shadescope");
    m_window.setWindowTitle(title.replace("[*]", "[*][*]"));  // Qt's own mark for what is not saved
}

}  // namespace app
