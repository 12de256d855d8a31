#include "app/stages/stage_strip.h"

#include <QHBoxLayout>
#include <QPainter>

#include "app/document/renderer_check.h"
#include "app/look/text.h"
#include "app/stages/stage_card.h"
#include "app/widgets/follow_theme.h"

namespace app {

// A card that says its state and nothing that it counts.
static StageStatus quietStatus(pipeline::StageId stage, StageState state) {
    StageStatus status;
    status.state = state;
    status.reason = StageStrip::tr("after your answer");
    status.tooltip = QStringLiteral("%1, %2").arg(toQString(stageInfo(stage).label), word(state));
    return status;
}

StageStrip::StageStrip(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
    setObjectName("stageStrip");
    setAccessibleName(tr("Stages"));
    auto* row = new QHBoxLayout(this);
    for (const pipeline::StageId stage : pipeline::kStages) {
        auto* card = new StageCard(stage, this);
        m_cards[index(stage)] = card;
        row->addWidget(card, 1);
        connect(card, &StageCard::clicked, this, [this, stage] { m_document.setStage(stage); });
        connect(card, &StageCard::entered, this, [this, stage] { m_document.stepper().goTo(pipeline::Place{stage}); });
    }
    m_frame = new FrameCard(this);
    row->addWidget(m_frame);
    setCompact(false);

    m_slow.setSingleShot(true);
    m_slow.setInterval(100);
    connect(&m_slow, &QTimer::timeout, this, [this] {
        m_frame->setBusy(true);
        if (!m_document.frames().shown()) showFrame();
    });
    connect(&document.frames(), &FrameFeed::busyChanged, this, [this](bool busy) {
        if (busy) return m_slow.start();
        m_slow.stop();
        m_frame->setBusy(false);
        if (!m_document.frames().shown()) showFrame();  // stopped before the first
    });
    // Nobody reads thirty times in a second.
    constexpr int kReadableMilliseconds = 150;
    m_next.setSingleShot(true);
    m_next.setInterval(kReadableMilliseconds);
    connect(&m_next, &QTimer::timeout, this, &StageStrip::showFrame);
    connect(&document, &Document::sceneOpened, this, &StageStrip::showFrame);
    connect(&document.frames(), &FrameFeed::frameReady, this, [this] {
        if (!m_document.frames().isMoving()) return showFrame();
        if (!m_next.isActive()) m_next.start();
    });
    connect(&document.frames(), &FrameFeed::errorsReady, this, &StageStrip::showFrame);
    connect(&document.stepper(), &Stepper::changed, this, &StageStrip::showFrame);
    connect(&document, &Document::stageChanged, this, &StageStrip::showStage);
    connect(&document, &Document::hiddenChanged, this, &StageStrip::showFrame);
    connect(&document.renderer(), &RendererCheck::changed, this, &StageStrip::showStandings);
    for (const auto signal : {&FrameFeed::frameReady, &FrameFeed::errorsReady})  // whose tooltips are of this program
        connect(&document.frames(), signal, this, &StageStrip::showStandings);
    showFrame();
    showStage();
}

void StageStrip::setCompact(bool compact) {
    const Theme& theme = Theme::current();
    layout()->setContentsMargins(0, theme.px(2), 0, theme.px(compact ? 6 : 8));
    layout()->setSpacing(theme.px(compact ? 6 : 8));
    for (StageCard* card : m_cards) card->setCompact(compact);
    m_frame->setCompact(compact);
}

void StageStrip::showStage() {
    for (StageCard* card : m_cards) card->setOnShow(card->stage() == m_document.stage());
}

// While another renderer is looked at, the cards say how its stages stand.
void StageStrip::showStandings() {
    const RendererCheck::ReportPtr report = m_document.renderer().shownStages();
    for (StageCard* card : m_cards) {
        if (!report) {
            card->setStanding(std::nullopt);
            continue;
        }
        const auto& verdict = report->stages[index(card->stage())];
        // The first that differs, else the first.
        const pipeline::foreign::Finding* shown = nullptr;
        for (const std::size_t i : verdict.findings)
            if (!shown || (shown->agrees && !report->findings[i].agrees)) shown = &report->findings[i];
        const QString finding = shown ? toQString(shown->name.text() + ": " + findingText(*shown)) : QString();
        card->setStanding(verdict.standing, finding);
    }
}

void StageStrip::showFrame() {
    m_next.stop();
    const Stepper& stepper = m_document.stepper();
    const pipeline::Frame* whole = m_document.frames().whole().get();
    // Counts and reasons may be what a question asks for; then a card says its state alone.
    const bool isQuiet = m_document.hidden().count() > 0;
    if (stepper.isInside() && stepper.steps() && !isQuiet) {
        const auto status =
            stageStatus(*stepper.steps(), *stepper.moment(), stepper.level(), m_document.frames().errors());
        for (StageCard* card : m_cards) card->setStatus(status[index(card->stage())]);
        return m_frame->setStatus(frameStatus(*stepper.steps(), *stepper.moment(), stepper.level()));
    }
    auto status = stageStatus(whole, m_document.frames().errors(), m_document.frames().busy());
    if (isQuiet)
        for (std::size_t i = 0; i < status.size(); ++i) status[i] = quietStatus(pipeline::kStages[i], status[i].state);
    for (StageCard* card : m_cards) card->setStatus(status[index(card->stage())]);
    m_frame->setStatus(whole && !isQuiet ? std::optional(frameStatus(*whole)) : std::nullopt);
}

FrameCard::FrameCard(QWidget* parent) : QWidget(parent) {
    setObjectName("frameCard");
    followTheme(this, [this] { fit(); });
}

void FrameCard::setStatus(const std::optional<FrameStatus>& status) {
    m_status = status;
    QString line =
        m_status
            ? QStringLiteral("%1, %2. %3. %4").arg(m_status->title, m_status->time, m_status->actions, m_status->format)
            : QString();
    if (m_status && !m_status->defect.isEmpty()) line = m_status->defect + QStringLiteral(". ") + line;
    setToolTip(line);
    setAccessibleName(line);
    update();
}

void FrameCard::setCompact(bool compact) {
    m_compact = compact;
    fit();
}

void FrameCard::setBusy(bool busy) {
    m_busy = busy;
    update();
}

void FrameCard::fit() {
    const Theme& theme = Theme::current();
    // The three counts in a line decide the width.
    const int line =
        QFontMetrics(theme.text(12)).horizontalAdvance(QStringLiteral("6 ran, 6 reused, 6 left out")) + theme.px(16);
    setFixedWidth(m_compact ? theme.px(108) : line);
    update();
}

void FrameCard::paintEvent(QPaintEvent*) {
    if (!m_status) return;
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QPainter painter(this);
    int y = theme.px(m_compact ? 4 : 7);
    const auto line = [&](const QString& text, const QFont& font, const QColor& color, int height) {
        painter.setFont(font);
        painter.setPen(color);
        painter.drawText(QRect(theme.px(8), y, width() - theme.px(8), height), Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(text, Qt::ElideRight, width() - theme.px(8)));
        y += height;
    };
    QFont big = theme.mono(m_compact ? 13 : 17);
    big.setWeight(QFont::DemiBold);
    // A planted defect is more than the frame's number.
    const bool isPlanted = !m_status->defect.isEmpty();
    const QString title = isPlanted ? m_status->defect : m_status->title;
    const QColor tone = isPlanted ? c.failed : c.text2;
    if (m_compact) {
        line(m_status->time, big, c.text, theme.px(19));
        line(title, theme.text(12), tone, theme.px(18));
    } else {
        line(title, theme.text(12), tone, theme.px(16));
        line(m_status->time, big, c.text, theme.px(21));
        line(m_status->actions, theme.text(12), c.text2, theme.px(16));
        line(m_status->format, theme.text(12), c.text2, theme.px(16));
    }
    if (m_busy) painter.fillRect(theme.px(8), height() - theme.px(3), width() - theme.px(8), theme.px(3), c.accent);
}

}  // namespace app
