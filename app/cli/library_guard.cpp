#include "app/cli/library_guard.h"

#include <unistd.h>

#include "app/cli/out_of_memory.h"
#include "pipeline/export/folder/hidden_folders.h"

namespace app {
namespace {

// Calls what signal-safety(7) allows alone.
void endOfLibrary(int) {
    pipeline::removeHiddenFolders();
    ::_exit(sayLibraryFailed());
}

}  // namespace

LibraryGuard::LibraryGuard(int cpuSeconds) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which have handlers of their own
    struct sigaction ours {};
    ours.sa_handler = endOfLibrary;
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &ours, &m_before[i]);
    if (cpuSeconds == kNoLimit) return;
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGXCPU;
    const itimerspec after{{}, {cpuSeconds, 0}};
    m_isTimed = timer_create(CLOCK_THREAD_CPUTIME_ID, &event, &m_timer) == 0;
    if (m_isTimed) timer_settime(m_timer, 0, &after, nullptr);
#else
    (void)cpuSeconds;
#endif
}

LibraryGuard::~LibraryGuard() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    if (m_isTimed) timer_delete(m_timer);
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &m_before[i], nullptr);
#endif
}

}  // namespace app
