#include "app/talk/clean_view.h"

#include <QCloseEvent>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/look/text.h"
#include "app/talk/ask_panel.h"
#include "app/talk/pen_layer.h"
#include "app/talk/pinned_settings.h"
#include "app/talk/talk_algorithm.h"
#include "app/talk/talk_caption.h"
#include "app/talk/talk_equation.h"
#include "app/talk/talk_hint.h"
#include "app/talk/talk_keys.h"
#include "app/talk/talk_pointer.h"
#include "app/talk/talk_work.h"
#include "app/views/view_area.h"
#include "app/widgets/follow_theme.h"
#include "lessons/pages/talk_html.h"

namespace app {
namespace {

constexpr double kTitle = 31;                             // 57 px in 1080 lines
constexpr double kAlgorithmWidth = 0.63;                  // of the view's
constexpr double kAskWidth = 0.52, kAnswerWidth = 0.275;  // likewise, of the choices

}  // namespace

double CleanView::scaleFor(int height) {
    const double scale = 22.0 / 12 * height / 1080;
    return std::min(std::ceil(scale * 20) / 20, Theme::kMostScale);  // in the theme's steps
}

CleanView::CleanView(Document& document, CueModel& cues, const SceneOpener& opener)
    : m_views(new ViewArea(document, this, ViewDress::Bare)),
      m_algorithm(new TalkAlgorithm(document, this)),
      m_ask(new AskPanel(cues, this)),
      m_title(styled(new QLabel(this), {.name = "cueTitle", .wraps = true})),
      m_sliders(new PinnedSettings(document, this)),
      m_equation(new TalkEquation(document, this)),
      m_caption(new TalkCaption(document, cues, *m_ask, this)),
      m_hint(new TalkHint(cues.size() > 0, this)),
      m_work(new TalkWork(document.work(), opener, this)),
      m_pen(new PenLayer(this)),
      m_keys(std::make_unique<TalkKeys>(
          TalkParts{*this, document.stepper(), *m_views, *m_ask, *m_caption, *m_hint, *m_work, *m_pen})),
      m_pointer(std::make_unique<TalkPointer>(*this, *m_pen)) {
    setObjectName("cleanView");
    setWindowTitle(tr("Shadescope, presentation"));
    setAutoFillBackground(true);
    m_title->setTextFormat(Qt::RichText);
    arrange();
    connect(&document.stepper(), &Stepper::changed, this, &CleanView::showStep);
    connect(&cues, &CueModel::changed, m_pen, &PenLayer::clearLines);
    connect(m_ask, &AskPanel::changed, this, &CleanView::showQuestion);
    connect(m_work, &TalkWork::changed, this, &CleanView::placeOverlays);
    connect(m_work, &TalkWork::cancelAsked, this, &CleanView::cancelAsked);
    connect(m_keys.get(), &TalkKeys::left, this, &CleanView::left);
    connect(m_keys.get(), &TalkKeys::swapAsked, this, &CleanView::swapAsked);
    connect(m_hint, &TalkHint::changed, this, &CleanView::placeOverlays);
    showQuestion();
}

CleanView::~CleanView() {
    m_keys.reset(), m_pointer.reset();
    // The views go while the document that they observe is still there.
    qDeleteAll(findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
}

void CleanView::arrange() {
    auto* column = spaced(new QVBoxLayout(this), {19, 15, 19, 10}, 12);
    column->setSizeConstraint(QLayout::SetNoConstraint);  // it fills the screen, and the views give way
    auto* beside = new QHBoxLayout;
    beside->addWidget(m_views, 1);
    beside->addWidget(m_algorithm);
    beside->addWidget(m_ask);
    column->addWidget(m_title);
    column->addLayout(beside, 1);
    column->addWidget(m_sliders);
    column->addWidget(m_equation);
    column->addWidget(m_caption);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_title->setFont(theme.text(kTitle, 600));
    });
}

// The choices are at the right: in place of the algorithm for a question, narrow beside the answer.
void CleanView::showQuestion() {
    m_title->setVisible(m_ask->asks());
    m_title->setText(toQString(lessons::sentenceHtml(m_ask->title().toStdString())));
    m_sliders->setVisible(m_sliders->count() > 0 && (!m_ask->asks() || m_ask->isAnswer()));
    m_ask->setFixedWidth(int((m_ask->isAnswer() ? kAnswerWidth : kAskWidth) * width()));
    showStep();
}

// The equation has no room beside the algorithm, and a question has no numbers beside it.
void CleanView::showStep() {
    m_algorithm->showStep(!m_ask->asks());
    m_algorithm->setFixedWidth(int(kAlgorithmWidth * width()));
    m_equation->setWanted(m_algorithm->isHidden() && (!m_ask->asks() || m_ask->isAnswer()));
}

// At the right, above the caption: the views stay as they are. The hint is where the keys will be.
void CleanView::placeOverlays() {
    const int margin = Theme::current().px(19);
    m_work->adjustSize();
    m_work->move(width() - m_work->width() - margin, m_caption->y() - m_work->height() - margin / 2);
    m_hint->adjustSize();
    const int beside = m_caption->geometry().center().y() - m_hint->height() / 2;
    m_hint->move(width() - m_hint->width() - margin, std::min(beside, height() - m_hint->height() - margin / 2));
}

pipeline::Errors CleanView::lookAt(const lessons::WindowState& state) {
    m_sliders->show(state.sliders);
    return m_views->lookAt(state);
}

QString CleanView::caption() const { return m_caption->sentence(); }
QString CleanView::shownKey() const { return m_caption->key(); }

void CleanView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    showQuestion();
    placeOverlays();
    m_pen->setGeometry(rect());
    m_pen->raise();
}

void CleanView::closeEvent(QCloseEvent* event) {
    event->ignore();
    emit left();
}

}  // namespace app
