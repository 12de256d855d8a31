#include "app/lesson/lesson_keys.h"

#include <QApplication>
#include <QKeyEvent>
#include <algorithm>
#include <utility>

#include "app/holds/hold_grip.h"
#include "app/lesson/lesson_head.h"
#include "app/lesson/lesson_run.h"
#include "app/lesson/question_card.h"

namespace app {

LessonKeys::LessonKeys(QWidget& panel, LessonRun& run, QuestionCard& card, LessonFoot& foot)
    : QObject(&panel), m_panel(panel), m_run(run), m_card(card), m_foot(foot) {
    qApp->installEventFilter(this);
}

void LessonKeys::pageShown() { m_pageWaits = true, m_gripWaits = false; }

void LessonKeys::waitForNone() { m_pageWaits = m_gripWaits = false; }

// The first grip of an open page gets the focus, where it has one, else its question. The grips of the first page that is
// opened come after its texts, with the first frame.
void LessonKeys::pageFilled() {
    if (!std::exchange(m_pageWaits, false)) return;
    const bool isOpen = m_card.isOpen();
    isOpen ? m_card.takeFocus() : m_foot.takeFocus();
    const auto grips = m_views && isOpen ? m_views->findChildren<HoldGrip*>() : QList<HoldGrip*>();
    const auto grip = std::ranges::find_if(grips, &QWidget::isVisible);
    m_gripWaits = isOpen && grip == grips.end();
    if (grip != grips.end()) (*grip)->setFocus();
}

bool LessonKeys::takes(const QKeyEvent& event) const {
    if (!m_run.lesson() || m_run.isAtEnd()) return false;
    const int key = event.key(), modifiers = event.modifiers() & ~Qt::KeypadModifier;
    if (modifiers == Qt::AltModifier)
        return key == Qt::Key_H || key == Qt::Key_S || key == Qt::Key_Left || key == Qt::Key_Right;
    return modifiers == Qt::NoModifier && m_card.isOpen() &&
           ((key >= Qt::Key_0 && key <= Qt::Key_9) || key == Qt::Key_Minus || key == Qt::Key_Return ||
            key == Qt::Key_Enter);
}

// Takes the lesson's keys before other widgets. Alt keys: anywhere in the panel and in the views. Digits and Enter: on a
// grip, which does not use them, and in the panel and the view area once the widget in it has ignored them.
bool LessonKeys::eventFilter(QObject* to, QEvent* event) {
    if (m_gripWaits && event->type() == QEvent::Show)
        if (auto* const grip = qobject_cast<HoldGrip*>(to)) m_gripWaits = false, grip->setFocus();
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::MouseButtonPress) m_gripWaits = false;
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride) return false;
    auto* const widget = qobject_cast<QWidget*>(to);
    const auto isIn = [widget](const QWidget* room) { return room && (room == widget || room->isAncestorOf(widget)); };
    auto* const key = static_cast<QKeyEvent*>(event);
    const bool isHere = key->modifiers() == Qt::AltModifier ? isIn(&m_panel) || isIn(m_views)
                                                            : widget == &m_panel || widget == m_views ||
                                                                  (isIn(m_views) && qobject_cast<HoldGrip*>(widget));
    if (!widget || !isHere || !takes(*key)) return false;
    event->accept();
    if (event->type() == QEvent::KeyPress) press(*key);
    return true;
}

void LessonKeys::press(const QKeyEvent& event) {
    switch (event.key()) {
        case Qt::Key_H: return m_card.giveHint();
        case Qt::Key_S: return m_card.askToShow();
        case Qt::Key_Left: return m_run.goTo(m_run.page() - 1);
        case Qt::Key_Right: return m_run.isSettled() ? m_run.goTo(m_run.page() + 1) : void();
        case Qt::Key_Return:
        case Qt::Key_Enter: return m_card.check();
        default: return m_card.choose(QChar(event.key()));
    }
}

}  // namespace app
