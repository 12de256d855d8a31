#include "app/widgets/work_bar.h"

#include <QProgressBar>
#include <QPushButton>

#include "app/jobs/work_list.h"

namespace app {

WorkBar::WorkBar(WorkList& work, QWidget* parent) : ProgressLine(parent), m_work(work) {
    setObjectName("workBar");
    bar()->setAccessibleName(tr("Being computed"));
    setShare({});
    link()->setObjectName("workLink");
    connect(link(), &QPushButton::clicked, this,
            [this] { m_work.running().isEmpty() ? m_work.resume() : m_work.cancel(); });
    connect(&work, &WorkList::changed, this, &WorkBar::showWork);
    showWork();
}

void WorkBar::showWork() {
    const QStringList running = m_work.running(), stopped = m_work.stopped();
    const bool runs = !running.isEmpty();
    setVisible(runs || !stopped.isEmpty());
    setBar(runs);
    tell(runs ? tr("Computing %1").arg(running.join(", "))
              : tr("Stopped: %1. What you see does not have it yet.").arg(stopped.join(", ")));
    link()->setText(runs ? tr("Cancel   Esc") : tr("Go on"));
    link()->setAccessibleName(runs ? tr("Cancel what is being computed") : tr("Go on with what was stopped"));
}

}  // namespace app
