#include "app/check/check_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>

#include "app/look/theme.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/fitting_choice.h"
#include "app/widgets/follow_theme.h"

namespace app {

using pipeline::check::Group;

CheckBar::CheckBar(QWidget* parent) : QWidget(parent) {
    m_head = new ElidedLabel(this);
    m_head->setObjectName("checkHead");
    m_progress = new QProgressBar(this);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Cases that have run"));
    const QStringList groups{tr("All"),   tr("Geometry"), tr("Camera"), tr("Raster"),
                             tr("Depth"), tr("Shading"),  tr("Shadow"), tr("Limits")};
    m_groups = new FittingChoice(groups, tr("Group of cases"), "checkGroupList", this);
    m_copy = new QPushButton(tr("Copy"), this);
    m_copy->setObjectName("checkCopy");
    m_runAll = new QPushButton(tr("Run all again"), this);
    m_runAll->setObjectName("checkRunAll");
    m_runAll->setProperty("kind", "primary");
    auto* bar = spaced(new QHBoxLayout(this), {4, 0, 0, 0}, 8);
    bar->addWidget(m_head, 3);
    bar->addWidget(m_progress, 2);
    for (QWidget* part :
         {static_cast<QWidget*>(m_groups), static_cast<QWidget*>(m_copy), static_cast<QWidget*>(m_runAll)})
        bar->addWidget(part);
    connect(m_groups, &FittingChoice::chosen, this,
            [this](int choice) { emit groupChosen(choice == 0 ? std::nullopt : std::optional(Group(choice - 1))); });
    connect(m_runAll, &QPushButton::clicked, this, &CheckBar::runAsked);
    connect(m_copy, &QPushButton::clicked, this, &CheckBar::copyAsked);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_head->setFont(theme.text(15, 600));
        m_progress->setFixedHeight(theme.px(8));
    });
}

void CheckBar::showState(const State& state) {
    const QString time = state.seconds > 0 ? tr(", in %1 s").arg(state.seconds, 0, 'f', 1) : QString();
    m_head->setText(state.isRunning    ? tr("%1 of %2 have run").arg(state.arrived).arg(state.asked)
                    : state.known == 0 ? tr("No case has run")
                                       : tr("%1 of %2 hold%3").arg(state.hold).arg(state.known).arg(time));
    m_progress->setVisible(state.isRunning);
    m_progress->setRange(0, int(std::max<std::size_t>(state.asked, 1)));
    m_progress->setValue(state.isRunning ? int(state.arrived) : 0);
    const QString busy = tr("The cases are running.");
    m_runAll->setEnabled(!state.isRunning);
    m_runAll->setToolTip(state.isRunning ? busy : tr("Runs all cases of the catalogue."));
    m_copy->setEnabled(!state.isRunning && state.known > 0);
    m_copy->setToolTip(state.isRunning   ? busy
                       : state.known > 0 ? tr("Copies what every case gave, as JSON: what check --json prints.")
                                         : tr("No case has run."));
}

void CheckBar::setGroup(std::optional<Group> group) { m_groups->setCurrent(group ? int(*group) + 1 : 0); }

void CheckBar::setNarrow(bool narrow) { m_groups->setNarrow(narrow); }

}  // namespace app
