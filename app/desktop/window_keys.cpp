#include "app/desktop/window_keys.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>

#include "app/commands/actions.h"
#include "app/desktop/scene_files.h"
#include "app/docks/window_layout.h"
#include "app/document/document.h"
#include "app/document/scene_opener.h"
#include "app/look/accessible.h"

namespace app {
namespace {

// What has the focus and a use of its own for the space bar, Home or End gets them; the timeline has them elsewhere.
bool keepsKey(QObject* watched, const QKeyEvent& key) {
    if (key.modifiers() != Qt::NoModifier) return false;
    const bool edge = key.key() == Qt::Key_Home || key.key() == Qt::Key_End || key.key() == Qt::Key_PageUp ||
                      key.key() == Qt::Key_PageDown;
    const bool list = qobject_cast<QAbstractItemView*>(watched) || qobject_cast<QComboBox*>(watched);
    if (edge) return list || qobject_cast<QAbstractSlider*>(watched) || dynamic_cast<AccessibleSlider*>(watched);
    return key.key() == Qt::Key_Space && (list || qobject_cast<QAbstractButton*>(watched));
}

}  // namespace

WindowKeys::WindowKeys(QWidget& window, Document& document, const Actions& actions, const WindowLayout& layout,
                       const SceneOpener& opener, SceneFiles& files)
    : QObject(&window),
      m_window(window),
      m_document(document),
      m_actions(actions),
      m_layout(layout),
      m_opener(opener),
      m_files(files) {
    qApp->installEventFilter(this);
}

bool WindowKeys::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
    auto& key = static_cast<QKeyEvent&>(*event);
    if (m_window.isActiveWindow() && (m_layout.showsViews() || m_opener.busy()) && takeKey(watched, key)) return true;
    if (event->type() == QEvent::KeyPress && watched == &m_window) takeLeftKey(key);
    return false;
}

// "Ctrl+←" and "Ctrl+→" go to a stage from anywhere, also from a text field that would take them.
// At the first and the last stage they say so, and do nothing else instead.
bool WindowKeys::takeKey(QObject* watched, QKeyEvent& key) {
    const bool isPress = key.type() == QEvent::KeyPress;
    if (key.key() == Qt::Key_Escape && m_opener.busy()) {
        key.accept();
        if (isPress) m_files.cancel();
        return true;
    }
    const bool isArrow = key.key() == Qt::Key_Left || key.key() == Qt::Key_Right;
    if (isArrow && key.modifiers() == Qt::ControlModifier) {
        key.setAccepted(isPress);
        const ActionId stage = key.key() == Qt::Key_Left ? ActionId::PreviousStage : ActionId::NextStage;
        if (isPress) emit m_document.said(m_actions.whyNot(stage));
        return true;
    }
    if (isPress || !keepsKey(watched, key)) return false;
    key.accept();
    return true;
}

// A key that nothing has taken: Esc cancels what takes long, another may be that of an action which cannot be done now.
void WindowKeys::takeLeftKey(const QKeyEvent& key) {
    if (key.key() == Qt::Key_Escape && !m_document.work().running().isEmpty()) return m_document.work().cancel();
    for (const auto& [id, row] : m_actions.rows())
        if (const QString why = m_actions.whyNot(id);
            !why.isEmpty() && m_actions[id]->shortcuts().contains(QKeySequence(key.keyCombination())))
            emit m_document.said(why);
}

}  // namespace app
