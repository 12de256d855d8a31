#include "app/desktop/tool_windows.h"

#include <QApplication>

#include "app/bug_game/bug_panel.h"
#include "app/check/check_panel.h"
#include "app/commands/actions.h"
#include "app/desktop/key_sheet.h"
#include "app/desktop/manual_window.h"
#include "app/desktop/preferences_dialog.h"
#include "app/desktop/scene_files.h"
#include "app/desktop/show_apart.h"
#include "app/desktop/window_lessons.h"
#include "app/docks/window_layout.h"
#include "app/document/document.h"
#include "app/study/study_panel.h"

namespace app {

ToolWindows::ToolWindows(QWidget& window, Actions& actions, Document& document, const WindowLayout& layout,
                         SceneFiles& files, WindowLessons& lessons)
    : QObject(&window),
      m_window(window),
      m_actions(actions),
      m_document(document),
      m_layout(layout),
      m_files(files),
      m_lessons(lessons) {
    addActions(actions);
}

void ToolWindows::addActions(Actions& actions) {
    using A = ActionId;
    actions.add({.id = A::Preferences,
                 .menu = "Edit",
                 .text = "Preferences…",
                 .keys = "Ctrl+,",
                 .tip = "Theme, text size, how numbers are written, and where the program keeps its files.",
                 .run = [this] { showPreferences(); },
                 .needsScene = false,
                 .startsGroup = true});
    actions.add({.id = A::Study,
                 .menu = "Study",
                 .text = "Error against run time…",
                 .keys = "Ctrl+Alt+S",
                 .tip = "Vary settings and show how wrong the picture is, and how long it takes.",
                 .run = [this] { showStudy(); }});
    actions.add({.id = A::Check,
                 .menu = "Study",
                 .text = "Stiff and extreme cases…",
                 .keys = "Ctrl+Alt+C",
                 .tip = "Run the inputs on which a formula that looks right fails.",
                 .run = [this] { showChecks(); },
                 .needsScene = false});
    actions.add({.id = A::WrongPicture,
                 .menu = "Learn",
                 .text = "Find the error…",
                 .keys = "Ctrl+Alt+G",
                 .tip = "A game with a wrong picture: look at buffers and pixels, mark the first wrong stage, name "
                        "the cause.",
                 .run = [this] { showWrongPicture(); },
                 .needsScene = false});
    actions.add({.id = A::Keys,
                 .menu = "Help",
                 .text = "Keys",
                 .keys = "H; ?",
                 .tip = "List the keys.",
                 .run = [this] { showKeys(); },
                 .needsScene = false});
    actions.add({.id = A::Manual,
                 .menu = "Help",
                 .text = "Manual",
                 .keys = "F1",
                 .tip = "Open the manual at the page about the focused part.",
                 .run = [this] { showManual(); },
                 .needsScene = false});
}

void ToolWindows::showStudy() {
    if (!m_study) m_study = new StudyPanel(m_document, &m_window);
    showApart(*m_study);
}

void ToolWindows::showChecks() {
    if (!m_checks) {
        m_checks = new CheckPanel(m_document, &m_window);
        m_checks->setMayLeave([this] { return m_files.mayLeave(); });
    }
    showApart(*m_checks);
}

void ToolWindows::showWrongPicture() {
    if (!m_bugs) {
        m_bugs = new BugPanel(&m_window);
        m_bugs->setOpenScene([this] { return m_document.hasScene() ? m_document.sharedScene() : nullptr; });
        connect(m_bugs, &BugPanel::lessonAsked, this, [this](const QString& lesson, const QString& heading) {
            m_lessons.openPage(lesson, heading);
            m_window.activateWindow();
        });
    }
    showApart(*m_bugs);
}

void ToolWindows::showPreferences() {
    auto* dialog = new PreferencesDialog(&m_window);
    connect(dialog, &PreferencesDialog::keysAsked, this, &ToolWindows::showKeys);
    connect(dialog, &QDialog::finished, &m_actions, &Actions::refresh);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void ToolWindows::showKeys() {
    if (!m_keys) m_keys = new KeySheet(m_actions, &m_window);
    m_keys->open();
}

void ToolWindows::showManual() {
    const QString page =
        m_layout.showsViews() ? manualPageOf(QApplication::focusWidget()) : QStringLiteral("README.md");
    if (!m_manual) m_manual = new ManualWindow(&m_window);
    m_manual->open(page);
}

}  // namespace app
