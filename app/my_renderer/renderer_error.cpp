#include "app/my_renderer/renderer_error.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

namespace foreign = pipeline::foreign;
using foreign::Candidate;

RendererError::RendererError(QWidget* parent)
    : QWidget(parent),
      m_title(new QLabel(this)),
      m_beside(styled(new QLabel(this), {.tone = 2, .size = 12})),
      m_box(new QFrame(this)) {
    setObjectName("rendererError");
    m_box->setProperty("kind", "overlay");
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_beside);
    m_column = new QVBoxLayout(m_box);
    auto* column = spaced(new QVBoxLayout(this), {12, 6, 12, 6}, 6);
    column->addLayout(head);
    column->addWidget(m_box);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_title->setFont(theme.text(13, 600));
        m_column->setContentsMargins(theme.px(10), theme.px(8), theme.px(10), theme.px(8));
        m_column->setSpacing(theme.px(4));
    });
}

void RendererError::clear() {
    while (QLayoutItem* item = m_column->takeAt(0)) {
        delete item->widget();
        delete item;
    }
}

QLabel* RendererError::add(const QString& text, double size, int weight, bool isMono) {
    auto* label = new QLabel(m_box);
    label->setTextFormat(Qt::PlainText);
    label->setText(text);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_column->addWidget(label);
    followTheme(label, [label, size, weight, isMono] {
        label->setFont(isMono ? Theme::current().mono(size) : Theme::current().text(size, weight));
    });
    return label;
}

void RendererError::addShare(const QString& name, double share) {
    auto* line = new QWidget(m_box);
    auto* row = spaced(new QHBoxLayout(line), {});
    auto* label = new QLabel(name, line);
    auto* bar = new QProgressBar(line);
    auto* number = new QLabel(line);
    // 100 % only where nothing is left over.
    const double percent = std::clamp(100 * share, 0.0, share < 0.9995 ? 99.9 : 100.0);
    number->setText(QStringLiteral("%1 %").arg(percent, 0, 'f', percent > 99 && percent < 100 ? 1 : 0));
    bar->setRange(0, 1000);
    bar->setValue(int(10 * percent));
    bar->setTextVisible(false);
    bar->setAccessibleName(QStringLiteral("%1 %2").arg(name, number->text()));
    row->addWidget(label);
    row->addWidget(bar, 1);
    row->addWidget(number);
    label->setProperty("tone", 2);
    m_column->addWidget(line);
    followTheme(line, [label, bar, number] {
        const Theme& theme = Theme::current();
        label->setFont(theme.text(12));
        label->setMinimumWidth(QFontMetrics(label->font()).horizontalAdvance(tr("next best")) + theme.px(6));
        number->setFont(theme.mono(12));
        number->setMinimumWidth(QFontMetrics(number->font()).horizontalAdvance(QStringLiteral("99.9 %")));
        bar->setFixedHeight(theme.px(7));
    });
}

void RendererError::addCandidate(const Candidate& candidate, int number) {
    const QString which = number > 0 ? QStringLiteral("%1  ").arg(number) : QString();
    add(which + toQString(candidate.error.name), 13, 600);
    add(tr("yours  %1").arg(toQString(candidate.error.wrong)), 12, 400, true)->setObjectName("wrongLine");
    add(tr("right  %1").arg(toQString(candidate.error.right)), 12, 400, true)->setObjectName("rightLine");
    if (number > 0 && candidate.error.stage)
        add(tr("in %1").arg(toQString(stageInfo(*candidate.error.stage).label)), 12, 400)->setProperty("tone", 2);
    addShare(tr("explains"), candidate.explained);
    if (candidate.error.lesson.empty()) return;
    auto* lesson = new QPushButton(tr("Lesson: %1").arg(toQString(candidate.error.heading)), m_box);
    lesson->setProperty("kind", "link");
    lesson->setAutoDefault(true);
    connect(lesson, &QPushButton::clicked, this,
            [this, name = toQString(candidate.error.lesson), heading = toQString(candidate.error.heading)] {
                emit lessonAsked(name, heading);
            });
    m_column->addWidget(lesson);
}

void RendererError::addExperiment(const foreign::Suspects& suspects) {
    const auto isOther = [](const Candidate& one) { return one.otherRows; };
    const auto others = std::ranges::count_if(suspects.candidates, isOther);
    if (others > 0 && others < std::ptrdiff_t(suspects.candidates.size())) {
        add(tr("What tells them apart: how your rows run."), 12, 600);
        auto* line = new QWidget(m_box);
        auto* row = spaced(new QHBoxLayout(line), {});
        for (const bool other : {false, true}) {
            auto* button = new QPushButton(other ? tr("The other way") : tr("As read"), line);
            button->setAutoDefault(true);
            connect(button, &QPushButton::clicked, this, [this, other] { emit rowsStated(other); });
            row->addWidget(button);
        }
        row->addStretch(1);
        m_column->addWidget(line);
    }
    if (!suspects.experiment) {
        if (others == 0 && suspects.kind.empty() && !suspects.areTogether)
            add(tr("They leave the same numbers in every buffer of this scene."), 12, 400);
        return;
    }
    const foreign::Experiment& experiment = *suspects.experiment;
    add(tr("What tells them apart: print %1 of %2.").arg(toQString(experiment.place), toQString(experiment.buffer)), 12,
        600);
    for (std::size_t i = 0; i < experiment.values.size(); ++i)
        add(tr("%1  means %2").arg(toQString(experiment.values[i])).arg(i + 1), 12, 400, true);
}

void RendererError::show(const foreign::Report& report) {
    const bool shows = report.suspects.has_value() && !report.agrees();
    setVisible(shows);
    clear();
    if (!shows) return;
    const foreign::Suspects& suspects = *report.suspects;
    const auto count = suspects.candidates.size();
    m_title->setText(count > 1 ? tr("Likely errors") : tr("Likely error"));
    m_beside->setText(suspects.areTogether ? tr("two at once")
                      : count == 1         ? tr("clearly best of %1").arg(suspects.tried)
                      : count > 1          ? tr("%1 are as good as each other").arg(count)
                                           : QString());
    add(toQString(namesText(report)), count == 0 ? 13 : 12, count == 0 ? 600 : 400);
    if (count == 0) return;
    int number = 0;
    for (const Candidate& one : suspects.candidates) addCandidate(one, count > 1 ? ++number : 0);
    if (count == 1 && suspects.next) addShare(tr("next best"), suspects.next->explained);
    if (count > 1) addExperiment(suspects);
}

}  // namespace app
