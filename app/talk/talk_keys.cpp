#include "app/talk/talk_keys.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

#include "app/frames/stepper.h"
#include "app/talk/ask_panel.h"
#include "app/talk/pen_layer.h"
#include "app/talk/talk_caption.h"
#include "app/talk/talk_hint.h"
#include "app/talk/talk_work.h"
#include "app/views/view_area.h"

namespace app {
namespace {

using Cover = PenLayer::Cover;

bool isTextField(const QWidget* widget) {
    return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
           qobject_cast<const QTextEdit*>(widget) || qobject_cast<const QPlainTextEdit*>(widget);
}

bool isModifier(int key) {
    switch (key) {
        case Qt::Key_Shift:
        case Qt::Key_Control:
        case Qt::Key_Alt:
        case Qt::Key_AltGr:
        case Qt::Key_Meta: return true;
        default: return false;
    }
}

}  // namespace

TalkKeys::TalkKeys(const TalkParts& parts) : m_parts(parts) {
    PenLayer& pen = parts.pen;
    const auto cover = [&pen](Cover with) {
        return [&pen, with] { pen.setCover(pen.cover() == with ? Cover::None : with); };
    };
    m_runs[Qt::Key_B] = m_runs[Qt::Key_Period] = cover(Cover::Black);
    m_runs[Qt::Key_W] = cover(Cover::White);
    m_runs[Qt::Key_P] = [&pen] { pen.setPen(!pen.hasPen()); };
    m_runs[Qt::Key_O] = [&pen, &talk = parts.talk] {
        pen.pointAt(talk.mapFromGlobal(QCursor::pos()));
        pen.setSpotlight(!pen.hasSpotlight());
    };
    m_runs[Qt::Key_A] = [&stepper = parts.stepper] { stepper.setShowsAlgorithm(!stepper.showsAlgorithm()); };
    m_runs[Qt::Key_1] = [&views = parts.views] { views.setAlone(true); };
    m_runs[Qt::Key_2] = [&views = parts.views] { views.setAlone(false); };
    m_runs[Qt::Key_F4] = [this] { emit swapAsked(); };
    m_runs[Qt::Key_H] = [this] {
        m_parts.caption.setKey({});
        m_parts.hint.showKeys();
    };
    m_runs[Qt::Key_Escape] = [this] { escape(); };
    qApp->installEventFilter(this);
}

bool TalkKeys::wants(int key) const { return m_parts.ask.wantsKey(key) || m_runs.contains(key); }

bool TalkKeys::take(int key) {
    if (m_parts.ask.takeKey(key)) return true;
    const auto found = m_runs.find(key);
    if (found == m_runs.end()) return false;
    found->second();
    return true;
}

// Stops what takes long, takes back what covers the views, then leaves.
void TalkKeys::escape() {
    TalkWork& work = m_parts.work;
    const bool isCovered = m_parts.pen.cover() != Cover::None;
    if (work.stopReading() || (!isCovered && work.stopRunning()) || m_parts.ask.leaveField() || clearPen()) return;
    if (!work.hasJustEnded()) emit left();
}

bool TalkKeys::clearPen() {
    PenLayer& pen = m_parts.pen;
    if (pen.cover() == Cover::None && !pen.hasPen() && !pen.hasSpotlight() && !pen.hasLines()) return false;
    pen.setCover(Cover::None);
    pen.setPen(false);
    pen.setSpotlight(false);
    pen.clearLines();
    return true;
}

void TalkKeys::showKey(const QKeyEvent& key) {
    if (key.isAutoRepeat() || isModifier(key.key()) || key.key() == Qt::Key_unknown) return;
    m_parts.hint.hide();
    m_parts.caption.showKey(QKeySequence(key.keyCombination()).toString(QKeySequence::NativeText));
}

// Keys here mean the same wherever the focus is: a buffer view would take B for its blue channel. But what is typed into
// a field, as a condition is, belongs there.
bool TalkKeys::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    auto* widget = isKey ? qobject_cast<QWidget*>(watched) : nullptr;
    if (!widget || widget->window() != &m_parts.talk) return QObject::eventFilter(watched, event);
    const auto& key = *static_cast<QKeyEvent*>(event);
    if (isTextField(QApplication::focusWidget()) && key.key() != Qt::Key_F4)
        return QObject::eventFilter(watched, event);
    const bool isPlain = (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    const bool isOwn = isPlain && wants(key.key());
    if (event->type() == QEvent::ShortcutOverride) {
        showKey(key);
        if (isOwn) event->accept();
        return isOwn;
    }
    return isOwn && !key.isAutoRepeat() ? take(key.key()) : QObject::eventFilter(watched, event);
}

}  // namespace app
