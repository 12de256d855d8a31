#include "app/bug_game/bug_card.h"

#include <QAbstractTextDocumentLayout>
#include <QAccessible>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTextBlock>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/bug_game/bug_parts.h"
#include "app/bug_game/bug_round.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/kept_in_sight.h"
#include "app/widgets/surface.h"

namespace app {

using Phase = BugRound::Phase;

BugCard::BugCard(BugRound& round, QWidget* parent) : QWidget(parent), m_round(round) {
    m_heading = bugLabel("bugHeading", 15, 600, this);
    m_what = bugLabel("bugWhat", 13, 400, this);
    m_count = bugLabel("bugCount", 13, 600, this);
    makeFields();
    m_stage = new BugStagePart(round, this);
    m_hint = bugButton(tr("Hint  H"), "bugHint", this);
    m_hint->setToolTip(tr("Costs 10 points"));
    connect(m_hint, &QPushButton::clicked, &round, &BugRound::giveHint);
    m_causes = new BugCausePart(round, this);
    m_end = new BugEndPart(round, this);
    connect(m_end, &BugEndPart::lessonAsked, this, &BugCard::lessonAsked);
    m_foot = bugLabel("bugFoot", 12, 400, this);
    layOut();
    connect(&round, &BugRound::said, this, &BugCard::say);
    connect(&round, &BugRound::changed, this, &BugCard::showState);
    showState();
}

void BugCard::makeFields() {
    m_looks = new QListWidget(this);
    m_looks->setObjectName("bugLooks");
    m_looks->setAccessibleName(tr("Looks"));
    m_text = new QPlainTextEdit(this);
    m_text->setObjectName("bugText");
    m_text->setReadOnly(true);
    m_text->setTabChangesFocus(true);
    m_text->setAccessibleName(tr("What was seen and said last"));
    m_pixel = new QLineEdit(this);
    m_pixel->setObjectName("bugPixel");
    m_pixel->setPlaceholderText(tr("Look at a pixel: column, row"));
    m_pixel->setAccessibleName(m_pixel->placeholderText());
    connect(m_pixel, &QLineEdit::returnPressed, this, [this] {
        if (m_round.lookAt(m_pixel->text())) m_pixel->clear();
    });
    m_seed = new QLineEdit(this);
    m_seed->setObjectName("bugSeed");
    m_seed->setPlaceholderText(tr("Seed, as 2026"));
    m_seed->setAccessibleName(tr("Seed: the same number gives the same pictures"));
    m_seed->setToolTip(m_seed->accessibleName());
    connect(m_seed, &QLineEdit::returnPressed, this, &BugCard::begin);
    m_own = bugButton(tr("Set a picture…"), "bugOwn", this);
    m_own->setToolTip(tr("Choose the scene and the error that others are to find."));
    connect(m_own, &QPushButton::clicked, this, &BugCard::ownAsked);
}

void BugCard::layOut() {
    auto* scrolled = new QWidget(this);
    scrolled->setProperty("kind", "page");
    auto* column = spaced(new QVBoxLayout(scrolled), {}, 7);
    for (QWidget* part : std::initializer_list<QWidget*>{m_heading, m_what, m_stage, m_causes, m_end, m_hint, m_count,
                                                         m_looks, m_pixel, m_text})
        column->addWidget(part);
    m_scroll = scrolling(scrolled, this);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_sight = new KeptInSight(*m_scroll);
    // The card alone scrolls: its text is as high as its lines.
    m_text->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_looks->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(m_text->document()->documentLayout(), &QAbstractTextDocumentLayout::documentSizeChanged, this,
            &BugCard::fitText);
    auto* rows = spaced(new QVBoxLayout(this), {12, 10, 12, 10}, 6);
    rows->addWidget(m_scroll, 1);
    rows->addWidget(m_foot);
    auto* next = new QHBoxLayout;
    next->addWidget(m_seed, 1);
    next->addWidget(m_own);
    rows->addLayout(next);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        setMinimumWidth(theme.px(280));
        for (QLabel* heading : {m_count, m_foot}) heading->setContentsMargins(0, theme.px(10), 0, 0);
        setFonts();
    });
}

// The rows of a table need letters of one width. Set while they are hidden, fonts do not outlive the first show.
void BugCard::setFonts() {
    for (QWidget* part : std::initializer_list<QWidget*>{m_looks, m_text}) part->setFont(Theme::current().mono(12));
    fitText();
}

// The editor lays out the lines that it paints. Here all of them are laid out: what is out of sight may be folded too.
void BugCard::fitText() {
    const QTextDocument& text = *m_text->document();
    // The editor counts a last line that ends at the edge as hidden: it has one more.
    double height = 2 * text.documentMargin() + m_text->fontMetrics().lineSpacing();
    for (QTextBlock block = text.begin(); block.isValid(); block = block.next())
        height += text.documentLayout()->blockBoundingRect(block).height();
    m_text->setFixedHeight(int(std::ceil(height)) + m_text->height() - m_text->viewport()->height());
}

void BugCard::begin() {
    bool isNumber = false;
    const qulonglong seed = m_seed->text().trimmed().toULongLong(&isNumber);
    if (!isNumber) return m_round.say(tr("A seed is a whole number, such as 2026."));
    m_seed->clear();
    m_round.begin(seed);
}

void BugCard::say(const QString& text) {
    setFonts();
    m_text->setPlainText(text);
    m_sight->keep(m_text);
    QAccessibleEvent alert(m_text, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void BugCard::showCursor(QPoint pixel) {
    m_what->setText(tr("At %1, %2. Space looks at this pixel.").arg(pixel.x()).arg(pixel.y()));
}

void BugCard::showState() {
    const lessons::WrongPicture* game = m_round.game();
    const BugRound::Turn& turn = m_round.turn();
    const BugRound::Score& score = m_round.score();
    for (QWidget* part : std::initializer_list<QWidget*>{m_count, m_text}) part->setVisible(game);
    m_looks->hide();
    for (QWidget* part : std::initializer_list<QWidget*>{m_hint, m_pixel})
        part->setVisible(game && !m_round.isIn(Phase::Over));
    if (!game) {
        m_heading->setText(turn.error.isEmpty() ? tr("A picture is being computed") : tr("There is no picture"));
        m_what->setText(turn.error);
        m_foot->setText(tr("Seed %1, level B").arg(score.seed));
        return;
    }
    const pipeline::DefectRow& row = game->row();
    m_heading->setText(m_round.isIn(Phase::Stage)   ? tr("Something is wrong")
                       : m_round.isIn(Phase::Cause) ? tr("What is the cause?")
                                                    : toQString(row.name));
    m_what->setText(m_round.isIn(Phase::Stage)
                        ? tr("This is %1. Which stage is the first that leaves something wrong?")
                              .arg(score.isOwn ? toQString(game->riddle().right->name) : toQString(row.scene))
                    : m_round.isIn(Phase::Cause) ? turn.verdict
                                                 : toQString(row.symptom));
    m_hint->setEnabled(!m_round.busy() && game->hints() < 3);
    showLooks();
    QString foot =
        score.isOwn
            ? tr("%1 points; a picture that was set").arg(game->points())
            : tr("%1 points; picture %2, seed %3, level B").arg(game->points()).arg(score.number + 1).arg(score.seed);
    if (score.solved > 0) foot += tr("\n%1 points in %2 pictures so far").arg(score.total).arg(score.solved);
    m_foot->setText(foot);
}

void BugCard::showLooks() {
    const std::vector<std::string>& looks = m_round.game()->looks();
    m_count->setText(tr("Looks: %1 of %2 free").arg(looks.size()).arg(m_round.game()->riddle().par));
    m_looks->clear();
    for (std::size_t i = 0; i < looks.size(); ++i)
        m_looks->addItem(QStringLiteral("%1  %2").arg(i + 1).arg(toQString(looks[i])));
    m_looks->setVisible(!looks.empty());
    m_looks->setFixedHeight(int(looks.size()) * std::max(1, m_looks->sizeHintForRow(0)) + 2 * m_looks->frameWidth());
}

}  // namespace app
