#include "app/bug_game/bug_panel.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QShortcut>
#include <QSplitter>
#include <chrono>

#include "app/bug_game/bug_box.h"
#include "app/bug_game/bug_card.h"
#include "app/bug_game/bug_own.h"
#include "app/bug_game/bug_parts.h"
#include "app/bug_game/bug_pictures.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/surface.h"

namespace app {

using Phase = BugRound::Phase;

namespace {

// Four digits, to be told in a class.
std::uint64_t seedOfNow() {
    const auto now = std::uint64_t(std::chrono::system_clock::now().time_since_epoch().count());
    return 1000 + now / 1000 % 9000;
}

}  // namespace

BugPanel::BugPanel(QWidget* parent) : QWidget(parent) {
    setObjectName("bugPanel");
    setWindowTitle(tr("Find the error"));
    setAttribute(Qt::WA_StyledBackground);
    auto* middle = new QSplitter(Qt::Horizontal, this);
    QWidget* boxes = makeBoxes();
    m_pictures = new BugPictures(m_round, this);
    m_card = new BugCard(m_round, this);
    middle->addWidget(m_pictures);
    middle->addWidget(surface(m_card, this));
    middle->setChildrenCollapsible(false);
    middle->setStretchFactor(0, 1);
    auto* column = spaced(new QVBoxLayout(this), {8, 8, 8, 8}, 8);
    column->addWidget(boxes);
    column->addWidget(middle, 1);
    addShortcuts();
    connect(m_pictures, &BugPictures::cursorMoved, m_card, &BugCard::showCursor);
    connect(m_card, &BugCard::lessonAsked, this, &BugPanel::lessonAsked);
    connect(m_card, &BugCard::ownAsked, this, &BugPanel::setPicture);
    connect(&m_round, &BugRound::changed, this, &BugPanel::showBoxes);
    followTheme(this, [this, middle] {
        const Theme& theme = Theme::current();
        middle->setHandleWidth(theme.px(8));
        middle->setSizes({theme.px(1000), theme.px(340)});
        setStyleSheet(QStringLiteral("#bugPanel { background: %1; }").arg(theme.colors().bg.name()));
    });
    showBoxes();
}

QWidget* BugPanel::makeBoxes() {
    auto* all = new QWidget(this);
    all->setAccessibleName(tr("What may be wrong"));
    auto* row = spaced(new QHBoxLayout(all), {});
    for (int box = 0; box < lessons::kBoxes; ++box) {
        BugBox*& made = m_boxes[std::size_t(box)];
        made = new BugBox(box, all);
        row->addWidget(made);
        connect(made, &QAbstractButton::clicked, &m_round, [this, box] { m_round.mark(box); });
    }
    followTheme(all, [row] { row->setSpacing(Theme::current().px(8)); });
    return all;
}

// Digits mark a box or choose a cause; Alt with a digit shows a stage, as everywhere.
void BugPanel::addShortcuts() {
    const auto on = [this](const QKeySequence& keys, auto run) {
        connect(new QShortcut(keys, this, nullptr, nullptr, Qt::WidgetWithChildrenShortcut), &QShortcut::activated,
                this, run);
    };
    for (int digit = 0; digit < lessons::kBoxes; ++digit) {
        on(QKeySequence(Qt::Key_0 + digit),
           [this, digit] { m_round.isIn(Phase::Cause) ? m_card->causes().choose(digit - 1) : m_round.mark(digit); });
        if (digit > 0)
            on(QKeySequence(Qt::ALT | Qt::Key(Qt::Key_0 + digit)), [this, digit] { m_round.lookAtStage(digit - 1); });
    }
    on(QKeySequence(Qt::Key_H), [this] { m_round.giveHint(); });
}

void BugPanel::showBoxes() {
    const lessons::WrongPicture* game = m_round.game();
    if (!game) {
        for (BugBox* box : m_boxes) box->show(BugBox::State::Open, 0, false), box->setEnabled(false);
        return;
    }
    // A look at a pixel is a look at the output of shading.
    std::array<int, lessons::kBoxes> looks{};
    for (const std::string& look : game->looks()) {
        const auto name = pipeline::findBuffer(look);
        ++looks[name ? 1 + index(pipeline::bufferInfo(name->id).stage) : std::size_t(lessons::kBoxes - 1)];
    }
    const int blamed = lessons::boxOf(game->row());
    for (int box = 0; box < lessons::kBoxes; ++box) {
        const bool isWrong = !m_round.isIn(Phase::Stage) && box == blamed;
        const bool isCleared = game->isCleared(box) || (m_round.isIn(Phase::Over) && box < blamed);
        BugBox& shown = *m_boxes[std::size_t(box)];
        shown.show(isWrong     ? BugBox::State::Wrong
                   : isCleared ? BugBox::State::Cleared
                               : BugBox::State::Open,
                   looks[std::size_t(box)], box == m_round.turn().marked);
        shown.setEnabled(!m_round.busy() && m_round.isIn(Phase::Stage) && !game->isCleared(box));
    }
}

void BugPanel::setPicture() {
    auto* dialog = new BugOwnDialog(m_open(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &BugOwnDialog::chosen, &m_round,
            qOverload<std::shared_ptr<const pipeline::Scene>, pipeline::Defect>(&BugRound::begin));
    dialog->open();
}

void BugPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (!m_round.game() && !m_round.busy()) m_round.begin(seedOfNow());
}

void BugPanel::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter: return m_round.proceed();
        case Qt::Key_Escape: close(); return;
        default: break;
    }
    QWidget::keyPressEvent(event);
}

}  // namespace app
