// What the clean view says: the equation, the algorithm, a question and the caption.
#include <QLabel>
#include <QVBoxLayout>

#include "app/core/number_format.h"
#include "app/core/pixel_inspection.h"
#include "app/core/text.h"
#include "app/desktop/ask_panel.h"
#include "app/desktop/caption_line.h"
#include "app/desktop/clean_view.h"
#include "app/desktop/pinned_settings.h"
#include "app/panels/algorithm_panel.h"
#include "app/panels/algorithm_view.h"
#include "app/panels/math_view.h"
#include "lessons/talk_words.h"

namespace app {
namespace {

constexpr double kAlgorithmWidth = 0.63;                  // of the view's
constexpr double kAskWidth = 0.52, kAnswerWidth = 0.275;  // likewise, of the choices

}  // namespace

// The lines, and below them why some are left out.
QWidget* CleanView::makeAlgorithm() {
    m_algorithmColumn = new QWidget(this);
    m_algorithm = new AlgorithmView(m_algorithmColumn);
    m_algorithm->setLetters(20.8, 17.6);  // 38 and 32 px in 1080 lines
    m_algorithm->setMostLines(int(lessons::kMostAlgorithmRows));
    m_algorithm->setShowsLoop(true);
    m_algorithm->setFocusPolicy(Qt::NoFocus);
    auto* lines = new QVBoxLayout(m_algorithmColumn);
    lines->setContentsMargins(0, 0, 0, 0);
    m_leftOut = new QLabel(m_algorithmColumn);
    m_leftOut->setObjectName("algorithmLeftOut");
    m_leftOut->setWordWrap(true);
    m_leftOut->setProperty("tone", 2);
    lines->addWidget(m_algorithm);
    lines->addWidget(m_leftOut);
    lines->addStretch(1);
    return m_algorithmColumn;
}

void CleanView::showEquation() {
    const auto& inspected = m_document.inspection().newest();
    const bool shows = inspected && inspected->report.covered && inspected->frame->buffer({pipeline::BufferId::Color});
    // A question has no numbers beside it.
    const bool asks = m_ask->asks() && !m_ask->isAnswer();
    m_equationRow->setVisible(shows && m_algorithmColumn->isHidden() && !asks);
    if (!shows) return;
    const pipeline::PixelReport& report = inspected->report;
    const pipeline::Scene& scene = inspected->frame->scene();
    m_math->setLines(lessons::shortEquation(equation(scene, report, m_document.pointing().channel(), chosenNumbers())),
                     true);
    const auto& c = report.color;
    // A font set while the row is hidden does not outlive a style sheet that comes meanwhile.
    m_value->setFont(Theme::current().mono(13));
    m_value->setText(tr("frame buffer\n%1 %2 %3").arg(int(c.r)).arg(int(c.g)).arg(int(c.b)));
    m_value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    QPixmap swatch(m_swatch->size());
    swatch.fill(QColor(c.r, c.g, c.b));
    m_swatch->setPixmap(swatch);
}

void CleanView::showAlgorithm() {
    auto state =
        m_document.stepper().showsAlgorithm() ? algorithmState(m_document.stepper(), m_document.stage()) : std::nullopt;
    m_algorithmColumn->setVisible(state.has_value() && !m_ask->asks());
    QStringList why;
    if (state)
        for (const std::string& sentence : state->leftOut()) why += toQString(sentence);
    m_leftOut->setText(why.join('\n'));
    m_leftOut->setVisible(!why.isEmpty());
    m_algorithm->setState(std::move(state));
    m_algorithmColumn->setFixedWidth(int(kAlgorithmWidth * width()));
}

// The choices stand at the right: in place of the algorithm for a question, narrow beside the answer.
void CleanView::showQuestion() {
    m_title->setVisible(m_ask->asks());
    m_title->setText(m_ask->title());
    auto* sliders = findChild<PinnedSettings*>();
    sliders->setVisible(sliders->count() > 0 && (!m_ask->asks() || m_ask->isAnswer()));
    m_ask->setFixedWidth(int((m_ask->isAnswer() ? kAnswerWidth : kAskWidth) * width()));
    showAlgorithm();
    showEquation();
}

QString CleanView::caption() const { return m_caption->sentence(); }
QString CleanView::shownKey() const { return m_caption->key(); }

void CleanView::showCaption() {
    const auto& stage = stageInfo(m_document.stage());
    const lessons::Cue* cue = m_cues.currentCue();
    QString sentence = cue ? toQString(cue->caption.empty() ? cue->name : cue->caption) : toQString(stage.summary);
    if (m_ask->asks()) sentence = m_ask->remark();
    const Stepper& stepper = m_document.stepper();
    const bool moved = cue && stepper.place() != cue->state.place;
    if (stepper.isInside() && (!cue || moved)) sentence = stepper.words();
    // A cue that was never named is called after its stage.
    const QString label = toQString(stage.label);
    m_caption->setText(sentence.startsWith(label) ? QString() : label, sentence);
    m_caption->setCues(m_cues.size(), m_cues.current());
}

}  // namespace app
