// What a QuestionCard does with an answer.
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/core/text.h"
#include "app/panels/answer_body.h"
#include "app/panels/follow_theme.h"
#include "app/panels/note_box.h"
#include "app/panels/prose_view.h"
#include "app/panels/question_card.h"
#include "lessons/misconceptions.h"

namespace app {

using lessons::Mark;

void QuestionCard::check() {
    if (!isOpen()) return;
    const auto given = m_body->given();
    if (!given) return m_body->takeFocus();
    const auto verdict = m_run.check(*given);
    if (!verdict) return emit failed(tr("This question has no answer here."), verdict.errors());
    const QString text = toQString(verdict->said);
    if (m_run.isSettled()) {
        showSettled();
        if (verdict->mark == Mark::Right)
            m_note->say(NoteBox::Kind::Right,
                        tr("Right: %1 of %2 points")
                            .arg(pointsText(m_run.attempt()->points()), pointsText(m_run.attempt()->full())),
                        text == QStringLiteral("Right.") ? QString() : text);
        else
            m_note->say(NoteBox::Kind::Unknown, tr("Not this time; the answer is below"), text);
        emit said(verdict->mark == Mark::Right ? tr("Right. The second half of the page is open.")
                                               : tr("That was the last try. The page gives no points."));
        return emit settled();
    }
    m_body->takeAttempt(*m_run.attempt());
    switch (verdict->mark) {
        case Mark::Known:
            m_note->say(NoteBox::Kind::Known, tr("Known mistake: %1").arg(toQString(verdict->name)), text);
            break;
        case Mark::NotYet: m_note->say(NoteBox::Kind::Unknown, QString(), text); break;
        default: m_note->say(NoteBox::Kind::Again, QString(), text); break;
    }
    m_note->show();
    arrange();
    emit said(tr("Not yet. %1").arg(m_body->advice()));
    // A screen reader reads the note out; a field keeps the keys, with the note as its description.
    if (std::holds_alternative<lessons::NumberQuestion>(m_run.current().question->kind))
        m_body->takeFocus();
    else
        m_note->setFocus();
}

void QuestionCard::giveHint() {
    if (!isOpen() || !m_hint->isEnabled()) return;
    const auto text = m_run.hint();
    if (!text) return emit failed(tr("This hint cannot be filled in."), text.errors());
    showHints();
    arrange();
}

void QuestionCard::showHints() {
    qDeleteAll(m_hints->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
    const lessons::Attempt& attempt = *m_run.attempt();
    for (std::size_t i = 0; i < attempt.hintsSeen(); ++i) {
        const auto text = attempt.hint(i, m_run.context());
        if (!text) continue;
        auto* hint = new ProseView(m_hints);
        hint->setObjectName(QStringLiteral("hint%1").arg(i + 1));
        hint->setAccessibleName(tr("Hint %1").arg(i + 1));
        hint->setPictureFolder(m_run.lesson()->folder);
        hint->setProse(tr("**Hint %1 (−25 %):** ").arg(i + 1) + toQString(*text));
        m_hints->layout()->addWidget(hint);
        if (i + 1 == attempt.hintsSeen() && isVisible()) hint->setFocus();
    }
    m_hints->setVisible(attempt.hintsSeen() > 0);
}

void QuestionCard::askToShow() {
    if (!isOpen()) return;
    askWhetherSure(true);
    m_sure->findChild<QPushButton*>("showSure")->setFocus();
}

void QuestionCard::choose(int key) {
    if (isOpen()) m_body->choose(key);
}

void QuestionCard::takeFocus() {
    if (m_body) m_body->takeFocus();
}

// The answer, what was tried before, and, where it was shown, how it is worked out.
void QuestionCard::showSettled() {
    const lessons::Attempt& attempt = *m_run.attempt();
    dropBody();
    for (QWidget* part : {m_hints, m_buttons, m_sure, m_elsewhere}) part->hide();
    const auto solution = attempt.solution(m_run.context());
    if (!solution) return emit failed(tr("This answer cannot be filled in."), solution.errors());
    QString text = QStringLiteral("● **%1**").arg(toQString(solution->answer));
    for (const lessons::Try& one : attempt.progress().tries) {
        if (one.right) continue;
        const lessons::Misconception* known = lessons::findMisconception(one.mistake);
        text += tr("\n\n%1 Tried: %2")
                    .arg(known ? QStringLiteral("△") : QStringLiteral("○"), toQString(one.given).toHtmlEscaped());
        if (known) text += QStringLiteral(" (%1)").arg(toQString(known->name));
    }
    if (attempt.state() == lessons::Attempt::State::Shown)
        for (const std::string& step : solution->steps) text += QStringLiteral("\n\n") + toQString(step);
    m_solution->setProse(text);
    m_solution->show();
    const bool right = attempt.state() == lessons::Attempt::State::Right;
    m_note->say(right ? NoteBox::Kind::Right : NoteBox::Kind::Again,
                right ? tr("Right: %1 of %2 points").arg(pointsText(attempt.points()), pointsText(attempt.full()))
                      : tr("Shown: the page gives no points"),
                {});
    m_note->show();
    arrange();
    emit adviceChanged();
}

}  // namespace app
