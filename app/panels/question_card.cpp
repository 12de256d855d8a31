#include "app/panels/question_card.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>

#include "app/panels/follow_theme.h"
#include "app/panels/prose_view.h"

namespace app {

QuestionCard::QuestionCard(QWidget* parent)
    : QFrame(parent),
      m_question(new ProseView(this)),
      m_field(new QLineEdit(this)),
      m_check(new QPushButton(tr("Check"), this)),
      m_hint(new QPushButton(tr("Hint"), this)),
      m_comment(new ProseView(this)) {
    auto* row = new QHBoxLayout;
    row->addWidget(m_field);
    row->addWidget(m_check);
    row->addWidget(m_hint);
    row->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_question);
    column->addLayout(row);
    column->addWidget(m_comment);

    m_question->setAccessibleName(tr("Question"));
    m_field->setAccessibleName(tr("Answer"));
    m_field->setObjectName("answer");
    m_check->setObjectName("check");
    m_hint->setObjectName("hint");
    m_hint->setProperty("kind", "link");
    m_comment->setAccessibleName(tr("Comment"));
    m_comment->setObjectName("comment");
    connect(m_check, &QPushButton::clicked, this, [this] { emit answered(m_field->text()); });
    connect(m_field, &QLineEdit::returnPressed, m_check, &QPushButton::click);
    connect(m_hint, &QPushButton::clicked, this, &QuestionCard::hintAsked);
    followTheme(this, [this, row, column] {
        const Theme& theme = Theme::current();
        m_field->setFont(theme.mono());
        m_field->setFixedWidth(theme.px(84));
        row->setSpacing(theme.px(8));
        column->setSpacing(theme.px(8));
        column->setContentsMargins(theme.px(12), theme.px(2), 0, theme.px(2));
    });
}

void QuestionCard::ask(const QString& question, bool hasHint) {
    setQuestion(question);
    m_field->clear();
    m_hint->setVisible(hasHint);
    m_comment->hide();
}

void QuestionCard::setQuestion(const QString& question) { m_question->setProse(question, ProseView::Tone::Question); }

void QuestionCard::setReady(bool ready) {
    for (QPushButton* button : {m_check, m_hint}) {
        button->setEnabled(ready);
        button->setToolTip(ready ? QString() : tr("Waits for the page's own numbers: set the window to this page."));
    }
}

void QuestionCard::say(const QString& markdown, Comment kind) {
    using Tone = ProseView::Tone;
    switch (kind) {
        case Comment::Hint: m_comment->setProse(markdown, Tone::Plain); break;
        case Comment::Right: m_comment->setProse(QStringLiteral("● ") + markdown, Tone::Right); break;
        case Comment::NotYet: m_comment->setProse(QStringLiteral("○ ") + markdown, Tone::NotYet); break;
    }
    m_comment->show();
}

void QuestionCard::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter(this).fillRect(0, 0, theme.px(2), height(), theme.colors().accent);
}

}  // namespace app
