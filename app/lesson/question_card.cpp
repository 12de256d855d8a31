#include "app/lesson/question_card.h"

#include <QApplication>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

#include "app/holds/hold_grip.h"
#include "app/lesson/answer_body.h"
#include "app/lesson/note_box.h"
#include "app/lesson/prose_view.h"
#include "app/look/numbers.h"
#include "app/look/text.h"
#include "app/widgets/fitting_stack.h"
#include "app/widgets/follow_theme.h"
#include "lessons/questions/results.h"

namespace app {

using lessons::Mark;

QString pointsText(double points) {
    QString text = number(points, 2);
    while (text.endsWith('0') && text.contains('.')) text.chop(1);
    if (text.endsWith('.')) text.chop(1);
    return text;
}

QuestionCard::QuestionCard(LessonRun& run, Document& document, QWidget* parent)
    : QFrame(parent),
      m_run(run),
      m_document(document),
      m_column(new QVBoxLayout),
      m_worth(styled(new QLabel(this), {.name = "worth", .size = 12, .weight = 600})),
      m_tries(styled(new QLabel(this), {.name = "tries", .tone = 2, .size = 12})),
      m_question(new ProseView(this)),
      m_note(new NoteBox(this)),
      m_hints(new QWidget(this)),
      m_elsewhere(new QWidget(this)),
      m_acts(new FittingStack(this)),
      m_solution(new ProseView(this)) {
    setObjectName("question");
    auto* title = spaced(new QHBoxLayout, {12, 7, 12, 7});
    title->addWidget(m_worth, 1);
    title->addWidget(m_tries);
    m_question->setAccessibleName(tr("Question"));
    m_question->setObjectName("questionText");
    m_question->setFocusPolicy(Qt::NoFocus);
    m_solution->setAccessibleName(tr("How it is worked out"));
    m_solution->setObjectName("solution");
    auto* all = new QVBoxLayout(this);
    all->addLayout(title);
    all->addLayout(m_column);
    makeButtons();
    spaced(new QVBoxLayout(m_hints), {});
    for (QWidget* part : std::initializer_list<QWidget*>{m_question, m_note, m_hints, m_solution, m_elsewhere, m_acts})
        m_column->addWidget(part);
    followTheme(this, [this, all] {
        const Theme& theme = Theme::current();
        all->setContentsMargins(1, 1, 1, theme.px(10));
        all->setSpacing(theme.px(6));
        m_column->setContentsMargins(theme.px(12), 0, theme.px(12), 0);
        m_column->setSpacing(theme.px(6));
    });
}

void QuestionCard::makeButtons() {
    const auto row = [](QWidget* parent) {
        auto* line = spaced(new QHBoxLayout(parent), {});
        return line;
    };
    const auto button = [](const QString& text, const char* name, QWidget* parent) {
        auto* made = new QPushButton(text, parent);
        made->setObjectName(name);
        return made;
    };
    auto *asks = new QWidget(m_acts), *isSure = new QWidget(m_acts);
    m_acts->addWidget(asks);
    m_acts->addWidget(isSure);
    auto* buttons = row(asks);
    m_check = button(tr("Check"), "check", asks);
    m_hint = button(tr("Hint"), "hint", asks);
    m_show = button(tr("Show me"), "showMe", asks);
    m_check->setToolTip(tr("Enter"));
    m_hint->setToolTip(tr("Alt+H, a quarter of the points"));
    m_show->setToolTip(tr("Alt+S, no points"));
    m_show->setProperty("kind", "link");
    buttons->addWidget(m_check);
    buttons->addWidget(m_hint);
    buttons->addStretch(1);
    buttons->addWidget(m_show);
    connect(m_check, &QPushButton::clicked, this, &QuestionCard::check);
    connect(m_hint, &QPushButton::clicked, this, &QuestionCard::giveHint);
    connect(m_show, &QPushButton::clicked, this, &QuestionCard::askToShow);

    auto* sure = row(isSure);
    auto* words = new QLabel(tr("Show the answer for 0 points?"), isSure);
    words->setWordWrap(true);
    auto* yes = button(tr("Show"), "showSure", isSure);
    auto* no = button(tr("Go on trying"), "showNot", isSure);
    sure->addWidget(words, 1);
    sure->addWidget(yes);
    sure->addWidget(no);
    connect(yes, &QPushButton::clicked, this, [this] {
        m_acts->setCurrentIndex(0);
        m_run.showMe();
        showSettled();
        emit said(tr("Shown. The page gives no points."));
        emit settled();
    });
    connect(no, &QPushButton::clicked, this, [this] { m_acts->setCurrentIndex(0), takeFocus(); });

    auto* elsewhere = row(m_elsewhere);
    auto* differs = new QLabel(tr("Your view is not the page's."), m_elsewhere);
    differs->setWordWrap(true);
    auto* back = button(tr("Back to the page's view"), "setWindow", m_elsewhere);
    back->setProperty("kind", "link");
    elsewhere->addWidget(differs, 1);
    elsewhere->addWidget(back);
    connect(back, &QPushButton::clicked, this, [this] { m_run.setWindow(), takeFocus(); });
    followTheme(m_acts, [words, differs] {
        for (QLabel* label : {words, differs}) label->setFont(Theme::current().text(12));
    });
}

void QuestionCard::standIn(QVBoxLayout* column) {
    const int side = column ? Theme::current().px(14) : 0;
    m_acts->setContentsMargins(side, 0, side, 0);
    if (column)
        column->insertWidget(column->count() - 1, m_acts);
    else
        m_column->addWidget(m_acts);
}

bool QuestionCard::isOpen() const { return m_body && !m_run.isSettled(); }

QString QuestionCard::advice() const {
    if (!m_run.attempt()) return {};
    if (m_run.isSettled()) return tr("Enter goes on.");
    return m_body ? m_body->advice() : QString();
}

QWidget& QuestionCard::note() const { return *m_note; }

QString QuestionCard::banner() const { return isOpen() ? m_body->banner() : QString(); }

// It may be what has just told of an answer.
void QuestionCard::dropBody() {
    if (!m_body) return;
    m_body->disconnect(this);
    m_body->hide();
    std::exchange(m_body, nullptr)->deleteLater();
}

void QuestionCard::ask() {
    dropBody();
    setVisible(m_run.attempt() != nullptr);
    if (!m_run.attempt()) return;
    m_question->setProse(toQString(withGaps(m_run.current().question->text)), ProseView::Tone::Question);
    for (QWidget* part : std::initializer_list<QWidget*>{m_note, m_hints, m_solution, m_elsewhere}) part->hide();
    m_acts->setCurrentIndex(0);
    m_acts->setVisible(!m_run.isSettled());
    for (QPushButton* one : {m_check, m_hint, m_show}) one->setEnabled(false);
    arrange();
}

void QuestionCard::fill() {
    if (!m_run.attempt()) return;
    m_question->setProse(toQString(m_run.texts()->question), ProseView::Tone::Question);
    if (m_run.isSettled()) return showSettled();
    m_body = makeAnswerBody(m_run, m_document, this);
    m_column->insertWidget(1, m_body);
    m_body->takeAttempt(*m_run.attempt());
    connect(m_body, &AnswerBody::changed, this, &QuestionCard::arrange);
    m_show->setEnabled(true);
    showHints();
    showWindow();
    arrange();
    emit adviceChanged();
}

void QuestionCard::showWindow() {
    const bool isUntil =
        m_run.attempt() && std::holds_alternative<lessons::UntilQuestion>(m_run.current().question->kind);
    m_elsewhere->setVisible(isOpen() && !isUntil && m_run.isElsewhere());
}

// The title bar, and which button is the one to press.
void QuestionCard::arrange() {
    const lessons::Attempt& attempt = *m_run.attempt();
    const QString full = pointsText(attempt.full());
    const QString points = attempt.full() == 1 ? tr("%1 point").arg(full) : tr("%1 points").arg(full);
    if (m_run.isSettled())
        m_worth->setText(tr("Question · %1 of %2").arg(pointsText(attempt.points()), points));
    else
        m_worth->setText(attempt.isFree() ? tr("Prediction · %1").arg(points)
                         : attempt.worth() == attempt.full()
                             ? tr("Question · %1").arg(points)
                             : tr("Question · now worth %1 of %2").arg(pointsText(attempt.worth()), points));
    const auto left = attempt.triesLeft();
    m_tries->setText(m_run.isSettled()  ? QString()
                     : attempt.isFree() ? tr("a wrong answer is free")
                     : !left            ? tr("no limit of tries")
                     : *left == 1       ? tr("1 try left")
                                        : tr("%1 tries left").arg(*left));
    setAccessibleName(m_worth->text());
    const bool ready = isOpen() && m_body->given().has_value();
    m_check->setEnabled(ready);
    m_check->setProperty("kind", ready ? "primary" : "");
    m_check->style()->polish(m_check);
    const bool more = isOpen() && attempt.hintsSeen() < attempt.hintCount();
    m_hint->setEnabled(more);
    m_hint->setVisible(attempt.hintCount() > 0);
    m_hint->setText(attempt.hintsSeen() == 0 ? tr("Hint")
                    : more                   ? tr("Hint %1 of %2").arg(attempt.hintsSeen() + 1).arg(attempt.hintCount())
                                             : tr("No more hints"));
    update();
}

void QuestionCard::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool isSettled = m_run.attempt() && m_run.isSettled();
    painter.setPen(QPen(isSettled ? c.run : c.accent, 1));
    painter.setBrush(c.raised);
    const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.drawRoundedRect(box, 6, 6);
    painter.setClipRect(QRectF(1, 1, width() - 2, m_worth->geometry().bottom() + theme.px(7)));
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.tint);
    painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, 20), 6, 6);
}

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
    // A screen reader reads the note out; a field keeps the keys, with the note as its description; a grip moves on.
    if (std::holds_alternative<lessons::NumberQuestion>(m_run.current().question->kind))
        m_body->takeFocus();
    else if (!qobject_cast<HoldGrip*>(QApplication::focusWidget()))
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
    m_acts->setCurrentIndex(1);
    m_acts->findChild<QPushButton*>("showSure")->setFocus();
}

void QuestionCard::choose(QChar key) {
    if (isOpen()) m_body->choose(key);
}

void QuestionCard::takeFocus() {
    if (m_body) m_body->takeFocus();
}

// The answer, what was tried before, and, where it was shown, how it is worked out.
void QuestionCard::showSettled() {
    const lessons::Attempt& attempt = *m_run.attempt();
    dropBody();
    for (QWidget* part : std::initializer_list<QWidget*>{m_hints, m_acts, m_elsewhere}) part->hide();
    const auto solution = attempt.solution(m_run.context());
    if (!solution) return emit failed(tr("This answer cannot be filled in."), solution.errors());
    const QString answer = toQString(solution->answer);  // a block of code stands by itself
    QString text = (answer.startsWith("```") ? QStringLiteral("%1\n") : QStringLiteral("● **%1**")).arg(answer);
    for (const lessons::Try& one : attempt.progress().tries) {
        if (one.right) continue;
        const bool known = !one.mistake.empty();
        text += tr("\n\n%1 Tried: %2")
                    .arg(known ? QStringLiteral("△") : QStringLiteral("○"), toQString(one.given).toHtmlEscaped());
        if (known) text += QStringLiteral(" (%1)").arg(toQString(lessons::mistakeName(one.mistake)));
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
