#include "app/tables/algorithm_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QToolButton>
#include <algorithm>

#include "app/look/accessible.h"
#include "app/look/icons.h"
#include "app/look/text.h"
#include "app/tables/algorithm_view.h"
#include "app/tables/step_tables.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"

namespace app {

using pipeline::AlgorithmRow;
using pipeline::AlgorithmValue;
using pipeline::Moment;

std::optional<pipeline::AlgorithmState> algorithmState(const Stepper& stepper, pipeline::StageId stage) {
    if (!stepper.steps()) return {};
    return stepper.steps()->algorithmAt(stepper.isInside() ? *stepper.moment() : Moment{stage, 0});
}

AlgorithmPanel::AlgorithmPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_list(new QComboBox(this)),
      m_copy(new QToolButton(this)),
      m_scroll(new QScrollArea(this)),
      m_view(new AlgorithmView),
      m_loop(new QWidget(this)),
      m_loopName(new QLabel(m_loop)),
      m_first(new QLabel(m_loop)),
      m_last(new QLabel(m_loop)),
      m_note(new QLabel(this)),
      m_hint(new ElidedLabel(tr("Ctrl+click a line: run to it"), this)),
      m_tables(new StepTables(document, this)),
      m_slider(new QSlider(Qt::Horizontal, m_loop)),
      m_back(new QPushButton(tr("Back"), this)),
      m_next(new QPushButton(tr("Next line"), this)) {
    setObjectName("algorithmPanel");
    auto* head = new QHBoxLayout;
    head->addWidget(m_list, 1);
    head->addWidget(m_copy);
    nameComboBox(*m_list, tr("Algorithm"));
    m_list->setToolTip(tr("The algorithms that this scene runs. Choose one to go to its first step."));
    m_list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_list->setMinimumContentsLength(12);
    m_copy->setIcon(icon("copy"));
    m_copy->setAccessibleName(tr("Copy"));
    m_copy->setToolTip(tr("Copy the algorithm with its values"));
    m_copy->setPopupMode(QToolButton::InstantPopup);
    auto* formats = new QMenu(m_copy);
    formats->addAction(tr("Copy as text"), this, [this] { copy(pipeline::AlgorithmFormat::Text); });
    formats->addAction(tr("Copy as LaTeX"), this, [this] { copy(pipeline::AlgorithmFormat::Latex); });
    m_copy->setMenu(formats);
    m_scroll->setWidget(m_view);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->viewport()->installEventFilter(this);
    auto* loop = new QHBoxLayout(m_loop);
    loop->addWidget(m_loopName);
    loop->addWidget(m_first);
    loop->addWidget(m_slider, 1);
    loop->addWidget(m_last);
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_back);
    foot->addWidget(m_next);
    foot->addWidget(m_hint, 1);
    m_next->setProperty("kind", "primary");
    m_next->setToolTip(tr("Step to the next line (F10 when stepping by line)"));
    m_back->setToolTip(tr("Step back to the line before, exactly (Shift+F10)"));
    m_note->setTextFormat(Qt::PlainText), m_note->setWordWrap(true);
    for (QLabel* label : {m_loopName, m_note, m_hint}) label->setProperty("tone", "2");
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_hint->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* column = spaced(new QVBoxLayout(this), {0, 4, 0, 6}, 6);
    column->addLayout(head);
    column->addWidget(m_scroll, 1000);  // up to its height; the tables have the rest
    column->addWidget(m_loop);
    column->addWidget(m_tables, 1);
    column->addWidget(m_note);
    column->addLayout(foot);
    followTheme(this, [this, head, loop, foot] {
        const Theme& theme = Theme::current();
        m_list->setFont(theme.text(12));
        for (QLabel* label : {m_loopName, m_note, m_hint}) label->setFont(theme.text(12));
        for (QLabel* label : {m_first, m_last}) label->setFont(theme.mono(12));
        for (QPushButton* button : {m_back, m_next}) button->setFont(theme.text(12, 600));
        m_copy->setIconSize(QSize(1, 1) * theme.px(16));
        const int edge = theme.px(8);
        for (QHBoxLayout* row : {head, loop, foot})
            row->setContentsMargins(edge, 0, edge, 0), row->setSpacing(theme.px(6));
        m_note->setContentsMargins(edge, 0, edge, 0);
    });

    connect(m_list, &QComboBox::activated, this, [this](int i) {
        const StepsPtr& steps = m_document.stepper().steps();
        const auto texts = steps ? steps->algorithms() : std::vector<pipeline::Algorithm>();
        if (i < 0 || std::size_t(i) >= texts.size()) return;
        m_document.setStage(texts[std::size_t(i)].row->stage);
        if (const auto begin = steps->beginOf(texts[std::size_t(i)]))
            m_document.stepper().goTo(steps->next(*begin, pipeline::StepLevel::Line).value_or(*begin));
    });
    connect(m_back, &QPushButton::clicked, this, [this] { stepLine(-1); });
    connect(m_next, &QPushButton::clicked, this, [this] { stepLine(1); });
    connect(m_view, &AlgorithmView::stepAsked, this, &AlgorithmPanel::stepLine);
    connect(m_view, &AlgorithmView::lineAsked, this, &AlgorithmPanel::runToLine);
    connect(m_view, &AlgorithmView::copyAsked, this, &AlgorithmPanel::copy);
    connect(m_scroll->verticalScrollBar(), &QScrollBar::rangeChanged, this, &AlgorithmPanel::showLit);
    connect(m_slider, &QSlider::valueChanged, this, &AlgorithmPanel::slideTo);
    connect(&document.stepper(), &Stepper::changed, this, &AlgorithmPanel::showStep);
    connect(&document, &Document::stageChanged, this, &AlgorithmPanel::showStep);
    showStep();
}

void AlgorithmPanel::showEvent(QShowEvent*) { showStep(); }

// The lit line is whole in sight, and in the middle, where not all of them have room.
void AlgorithmPanel::showLit() {
    const QSize room = m_scroll->viewport()->size();
    m_view->setMinimumHeight(m_view->heightForWidth(room.width()));
    m_view->resize(room.width(), std::max(m_view->minimumHeight(), room.height()));  // the bar's range with it
    m_scroll->setMaximumHeight(m_view->minimumHeight() + 2 * m_scroll->frameWidth());
    const QRect lit = m_view->currentRect();
    QScrollBar* bar = m_scroll->verticalScrollBar();
    if (lit.isEmpty() || (lit.top() >= bar->value() && lit.bottom() < bar->value() + room.height())) return;
    bar->setValue(std::min(lit.top(), lit.center().y() - room.height() / 2));
}

bool AlgorithmPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) showLit();
    return QWidget::eventFilter(watched, event);
}

void AlgorithmPanel::showStep() {
    if (!isVisible()) return;
    const Stepper& stepper = m_document.stepper();
    m_view->setState(algorithmState(stepper, m_document.stage()));
    showList();
    showLoop();
    m_tables->showStep(m_view->rows());
    const auto& state = m_view->state();
    QStringList sentences;
    if (state)
        for (const std::string& why : state->leftOut()) sentences += toQString(why);
    if (state && !state->walk.algorithm.row->note.empty()) sentences += toQString(state->walk.algorithm.row->note);
    if (state && !state->visit && state->leftOut().empty())
        sentences.prepend(tr("Step into the stage to light its lines."));
    if (!state)
        sentences += stepper.steps() ? tr("This stage has no algorithm here.") : tr("The steps are being counted.");
    m_note->setText(sentences.join('\n'));
    m_note->setVisible(!sentences.isEmpty());
    showLit();
    m_back->setEnabled(stepper.steps() && stepper.canStep(-1));
    m_next->setEnabled(stepper.steps() && stepper.canStep(1));
}

void AlgorithmPanel::showList() {
    const StepsPtr& steps = m_document.stepper().steps();
    const auto texts = steps ? steps->algorithms() : std::vector<pipeline::Algorithm>();
    QStringList titles;
    for (const pipeline::Algorithm& text : texts) titles += toQString(text.row->title);
    QStringList shown;
    for (int i = 0; i < m_list->count(); ++i) shown += m_list->itemText(i);
    if (titles != shown) m_list->clear(), m_list->addItems(titles);
    const auto& state = m_view->state();
    m_list->setCurrentIndex(state ? int(titles.indexOf(toQString(state->walk.algorithm.row->title))) : -1);
    m_list->setEnabled(!titles.isEmpty());
    m_copy->setEnabled(state.has_value());
}

// The innermost loop that the lit line is in.
void AlgorithmPanel::showLoop() {
    const AlgorithmValue* const inner = innermostLoop(m_view->rows());
    m_loop->setVisible(inner != nullptr);
    if (!inner) return;
    const AlgorithmValue::Range& range = *inner->range;
    const QSignalBlocker quiet(m_slider);
    m_loopName->setText(toQString(range.name));
    m_first->setText(QString::number(range.first));
    m_last->setText(QString::number(range.last));
    m_slider->setRange(int(range.first), int(range.last));
    m_slider->setValue(int(range.at));
    m_slider->setAccessibleName(m_loopName->text());
    const auto& place = m_document.stepper().place();
    m_slider->setEnabled(range.last > range.first && place && place->x && inner->numbers.size() == 2);
    m_slider->setToolTip(m_slider->isEnabled() ? tr("Drag to another pixel of the row")
                                               : tr("Step to move on; only a row of pixels can be dragged along"));
}

void AlgorithmPanel::stepLine(int direction) {
    m_document.stepper().setLevel(pipeline::StepLevel::Line);
    m_document.stepper().step(direction);
}

// The next time that the line is passed, in this step or in one of the next; looked for in so many steps.
void AlgorithmPanel::runToLine(int number) {
    constexpr int kMostLines = 20000;
    Stepper& stepper = m_document.stepper();
    if (!stepper.steps()) return;
    stepper.setLevel(pipeline::StepLevel::Line);
    const pipeline::Steps& steps = *stepper.steps();
    std::optional<Moment> at = stepper.isInside() ? *stepper.moment() : Moment{m_document.stage(), 0};
    const auto* const text = m_view->state() ? m_view->state()->walk.algorithm.row : nullptr;
    for (int i = 0; i < kMostLines && (at = steps.next(*at, pipeline::StepLevel::Line)); ++i) {
        if (at->line == 0) continue;
        const auto state = steps.algorithmAt(*at);
        if (!state || state->walk.algorithm.row != text) break;
        if (int(state->walk.visits[*state->visit].line) + 1 == number) return stepper.goTo(*at);
    }
    emit m_document.said(tr("No step after this one comes to line %1.").arg(number));
}

void AlgorithmPanel::slideTo(int at) {
    auto place = m_document.stepper().place();
    if (!place || !place->x) return;
    place->x = at;
    m_document.stepper().goTo(*place);
}

void AlgorithmPanel::copy(pipeline::AlgorithmFormat format) {
    if (!m_view->state()) return;
    QApplication::clipboard()->setText(toQString(algorithmText(*m_view->state(), format)));
    emit m_document.said(format == pipeline::AlgorithmFormat::Latex ? tr("Copied the algorithm as LaTeX.")
                                                                    : tr("Copied the algorithm as text."));
}

}  // namespace app
