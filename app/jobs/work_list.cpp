#include "app/jobs/work_list.h"

#include <algorithm>
#include <utility>

namespace app {

WorkList::WorkList(QObject* parent) : QObject(parent) {
    constexpr int kLongMilliseconds = 400;
    m_slow.setSingleShot(true);
    m_slow.setInterval(kLongMilliseconds);
    connect(&m_slow, &QTimer::timeout, this, &WorkList::changed);
}

void WorkList::add(const QObject* who, const QString& name, std::function<void()> cancel,
                   std::function<void()> resume) {
    m_works.push_back({who, name, std::move(cancel), std::move(resume)});
    connect(who, &QObject::destroyed, this, [this, who] {
        std::erase_if(m_works, [who](const Work& work) { return work.who == who; });
        emit changed();
    });
}

void WorkList::setBusy(const QObject* who, bool busy) {
    const auto isBusy = [this] { return std::ranges::any_of(m_works, &Work::busy); };
    const auto work = std::ranges::find(m_works, who, &Work::who);
    if (work == m_works.end() || work->busy == busy) return;
    const bool wasBusy = isBusy();
    work->busy = busy;
    if (busy) work->stopped = false;
    if (!wasBusy) m_slow.start();
    if (!isBusy()) m_slow.stop();
    emit changed();
}

QStringList WorkList::names(bool Work::*state) const {
    QStringList all;
    for (const Work& work : m_works)
        if (work.*state && !all.contains(work.name)) all << work.name;
    return all;
}

QStringList WorkList::running() const { return m_slow.isActive() ? QStringList() : names(&Work::busy); }

QStringList WorkList::stopped() const { return names(&Work::stopped); }

bool WorkList::isStopped(const QObject* who) const {
    return std::ranges::any_of(m_works, [who](const Work& work) { return work.who == who && work.stopped; });
}

// Giving one up may end another.
void WorkList::cancel() {
    for (Work& work : m_works) work.stopped = work.stopped || work.busy;
    for (std::size_t i = 0; i < m_works.size(); ++i)
        if (m_works[i].busy) m_works[i].cancel();
    emit changed();
}

void WorkList::resume() {
    std::vector<std::function<void()>> all;
    for (Work& work : m_works)
        if (std::exchange(work.stopped, false)) all.push_back(work.resume);
    for (const auto& resume : all) resume();
    emit changed();
}

void WorkList::forgetStopped() {
    for (Work& work : m_works) work.stopped = false;
    emit changed();
}

}  // namespace app
