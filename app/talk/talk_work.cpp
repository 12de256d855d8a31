#include "app/talk/talk_work.h"

#include <QVBoxLayout>
#include <utility>

#include "app/document/scene_opener.h"
#include "app/jobs/work_list.h"
#include "app/widgets/opening_bar.h"
#include "app/widgets/work_bar.h"

namespace app {
namespace {

constexpr int kMomentMs = 1000;

}  // namespace

TalkWork::TalkWork(WorkList& work, const SceneOpener& opener, QWidget* parent)
    : QFrame(parent), m_work(work), m_opener(opener) {
    setProperty("kind", "overlay");
    auto* reading = new OpeningBar(opener, this);
    auto* lines = new QVBoxLayout(this);
    lines->addWidget(reading);
    lines->addWidget(new WorkBar(work, this));
    m_endTime.setSingleShot(true);
    m_endTime.setInterval(kMomentMs);
    connect(reading, &OpeningBar::cancelAsked, this, &TalkWork::cancelAsked);
    connect(&opener, &SceneOpener::changed, this, &TalkWork::showWork);
    connect(&work, &WorkList::changed, this, &TalkWork::showWork);
    showWork();
}

void TalkWork::showWork() {
    const bool runs = m_opener.busy() || !m_work.running().isEmpty();
    if (std::exchange(m_works, runs) && !runs) m_endTime.start();
    setVisible(runs || !m_work.stopped().isEmpty());
    emit changed();
}

bool TalkWork::stopReading() {
    if (!m_opener.busy()) return false;
    emit cancelAsked();
    return true;
}

bool TalkWork::stopRunning() {
    if (m_work.running().isEmpty()) return false;
    m_work.cancel();
    return true;
}

}  // namespace app
