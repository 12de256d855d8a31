#include "app/bug_game/bug_parts.h"

#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>
#include <cmath>

#include "app/bug_game/bug_round.h"
#include "app/inspector/math_view.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "pipeline/inspect/pixel_report.h"

namespace app {

using pipeline::BufferId;
using Phase = BugRound::Phase;

namespace {

QVBoxLayout* bareColumn(QWidget* parent) {
    auto* column = spaced(new QVBoxLayout(parent), {});
    return column;
}

// The channel of a pixel's colour that differs most.
int worstChannel(const pipeline::Frame& a, const pipeline::Frame& b, glm::ivec2 pixel) {
    const auto left = *a.buffer({BufferId::Color}), right = *b.buffer({BufferId::Color});
    const auto difference = [&](int c) {
        const auto x = std::size_t(pixel.x), y = std::size_t(pixel.y);
        return std::abs(left.value(x, y, c) - right.value(x, y, c));
    };
    int worst = 0;
    for (int c = 1; c < 3; ++c)
        if (difference(c) > difference(worst)) worst = c;
    return worst;
}

std::vector<pipeline::EquationLine> equationAt(const pipeline::Frame& frame, glm::ivec2 pixel, int channel) {
    const pipeline::PixelReport report = inspectPixel(frame, pixel);
    if (!report.covered || report.outline) return {};
    return equation(frame.scene(), report, channel);
}

}  // namespace

QLabel* bugLabel(const char* name, double size, int weight, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    followTheme(label, [label, size, weight] { label->setFont(Theme::current().text(size, weight)); });
    return label;
}

QPushButton* bugButton(const QString& text, const char* name, QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setObjectName(name);
    button->setAutoDefault(true);  // Enter presses the button that has the focus
    return button;
}

BugStagePart::BugStagePart(BugRound& round, QWidget* parent) : QWidget(parent), m_round(round) {
    QVBoxLayout* column = bareColumn(this);
    m_words = bugLabel("bugStageWords", 12, 400, this);
    m_accuse = bugButton(tr("This one is wrong  Enter"), "bugAccuse", this);
    m_accuse->setProperty("kind", "primary");
    column->addWidget(m_words);
    column->addWidget(m_accuse);
    connect(m_accuse, &QPushButton::clicked, &round, &BugRound::accuse);
    connect(&round, &BugRound::changed, this, &BugStagePart::showState);
    showState();
}

void BugStagePart::showState() {
    setVisible(m_round.isIn(Phase::Stage));
    const BugRound::Turn& turn = m_round.turn();
    m_words->setText(turn.verdict.isEmpty() ? tr("Click a box, or press 0 to 6. The right picture is shown at the end.")
                                            : turn.verdict);
    m_accuse->setEnabled(!m_round.busy() && turn.marked >= 0);
    m_accuse->setToolTip(turn.marked >= 0 ? QString() : tr("Mark a box first."));
}

BugCausePart::BugCausePart(BugRound& round, QWidget* parent) : QWidget(parent), m_round(round) {
    QVBoxLayout* column = bareColumn(this);
    m_words = bugLabel("bugCauseWords", 12, 400, this);
    for (std::size_t i = 0; i < m_causes.size(); ++i) {
        m_causes[i] = new QRadioButton(this);
        m_causes[i]->setObjectName(QStringLiteral("bugCause:%1").arg(i + 1));
        connect(m_causes[i], &QRadioButton::toggled, this, [this, i](bool on) {
            if (on) m_round.name(int(i));
        });
        column->addWidget(m_causes[i]);
    }
    m_name = bugButton(tr("That is the cause  Enter"), "bugNameCause", this);
    m_name->setProperty("kind", "primary");
    connect(m_name, &QPushButton::clicked, &round, &BugRound::nameCause);
    column->addWidget(m_words);
    column->addWidget(m_name);
    connect(&round, &BugRound::changed, this, &BugCausePart::showState);
    connect(&round, &BugRound::stageFound, m_causes[0], qOverload<>(&QWidget::setFocus), Qt::QueuedConnection);
    followTheme(this, [this] {
        for (QRadioButton* one : m_causes) one->setFont(Theme::current().text(13));
    });
    showState();
}

void BugCausePart::choose(int cause) {
    if (cause >= 0 && cause < int(m_causes.size())) m_causes[std::size_t(cause)]->setChecked(true);
}

void BugCausePart::showState() {
    setVisible(m_round.isIn(Phase::Cause));
    const lessons::WrongPicture* game = m_round.game();
    if (!game) return;
    const int chosen = m_round.turn().cause;
    for (std::size_t i = 0; i < m_causes.size(); ++i) {
        const pipeline::DefectRow& cause = defectInfo(game->riddle().causes[i]);
        const QSignalBlocker quiet(m_causes[i]);
        m_causes[i]->setText(QStringLiteral("%1  %2").arg(i + 1).arg(toQString(cause.name)));
        m_causes[i]->setToolTip(toQString(cause.symptom));
        m_causes[i]->setAutoExclusive(false);
        m_causes[i]->setChecked(int(i) == chosen);
        m_causes[i]->setAutoExclusive(true);
        m_causes[i]->setEnabled(!m_round.busy() && !game->isExcluded(i));
    }
    m_words->setText(chosen < 0 ? tr("Choose with ↑ and ↓, or press 1 to 5.")
                                : toQString(defectInfo(game->riddle().causes[std::size_t(chosen)]).symptom));
    m_name->setEnabled(!m_round.busy() && chosen >= 0);
}

BugEndPart::BugEndPart(BugRound& round, QWidget* parent) : QWidget(parent), m_round(round) {
    QVBoxLayout* column = bareColumn(this);
    m_wrongName = bugLabel("bugWrongName", 12, 600, this);
    m_rightName = bugLabel("bugRightName", 12, 600, this);
    m_wrong = new MathView(this);
    m_right = new MathView(this);
    m_fix = bugLabel("bugFix", 13, 400, this);
    m_next = bugButton(tr("Next picture  Enter"), "bugNext", this);
    m_next->setProperty("kind", "primary");
    m_lesson = bugButton({}, "bugLesson", this);
    m_lesson->setProperty("kind", "link");
    for (QWidget* part :
         std::initializer_list<QWidget*>{m_wrongName, m_wrong, m_rightName, m_right, m_fix, m_next, m_lesson})
        column->addWidget(part);
    connect(m_next, &QPushButton::clicked, &round, &BugRound::next);
    connect(m_lesson, &QPushButton::clicked, this, &BugEndPart::askLesson);
    connect(&round, &BugRound::revealed, this, &BugEndPart::showReveal);
    connect(&round, &BugRound::changed, this, &BugEndPart::showState);
    followTheme(this, [this] {
        for (MathView* one : {m_wrong, m_right}) one->setBaseSize(14);
        for (QLabel* one : {m_wrongName, m_rightName, m_fix}) one->setContentsMargins(0, Theme::current().px(8), 0, 0);
    });
    showState();
}

void BugEndPart::askLesson() {
    const pipeline::DefectRow& row = m_round.game()->row();
    emit lessonAsked(toQString(row.lesson), toQString(row.heading));
}

void BugEndPart::showReveal() {
    const pipeline::Frame &wrong = *m_round.game()->wrong(), &right = *m_round.game()->right();
    const auto& pixel = m_round.turn().worst;
    if (pixel) {
        const int channel = worstChannel(right, wrong, *pixel);
        m_wrong->setLines(equationAt(wrong, *pixel, channel));
        m_right->setLines(equationAt(right, *pixel, channel));
    }
    const QString place = pixel ? tr("pixel %1, %2").arg(pixel->x).arg(pixel->y) : QString();
    m_wrongName->setText(m_wrong->lines().empty() ? tr("Wrong at %1: nothing is drawn.").arg(place)
                                                  : tr("Wrong at %1").arg(place));
    m_rightName->setText(m_right->lines().empty() ? tr("Right: nothing is drawn.") : tr("Right"));
    m_wrong->setVisible(!m_wrong->lines().empty());
    m_right->setVisible(!m_right->lines().empty());
}

void BugEndPart::showState() {
    setVisible(m_round.isIn(Phase::Over));
    if (!m_round.game()) return;
    const pipeline::DefectRow& row = m_round.game()->row();
    m_fix->setText(tr("Wrong: %1\nRight: %2").arg(toQString(row.wrong), toQString(row.fix)));
    m_lesson->setText(tr("Lesson: %1").arg(toQString(row.heading)));
    m_lesson->setVisible(!row.lesson.empty());
}

}  // namespace app
