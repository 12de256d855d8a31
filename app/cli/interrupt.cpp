#include "app/cli/interrupt.h"

#include <unistd.h>

#include <chrono>
#include <ctime>

#include "app/cli/cli.h"
#include "app/cli/message.h"
#include "pipeline/export/folder/hidden_folders.h"

namespace app {

Interrupt::Interrupt() {
    sigset_t ours;
    sigemptyset(&ours);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        // What is ignored stays so: nohup does it, and a shell for what runs in the background.
        struct sigaction now {};
        if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) sigaddset(&ours, signal);
    }
    pthread_sigmask(SIG_BLOCK, &ours, &m_before);
    m_waiting = std::jthread([this, ours](const std::stop_token& over) {
        using Clock = std::chrono::steady_clock;
        // A signal handler may do next to nothing; a thread that waits for the signal may do all.
        for (Clock::time_point first; !over.stop_requested();) {
            constexpr timespec kLook{0, 20'000'000};         // how long the end of the program may wait for this thread
            constexpr std::chrono::milliseconds kOnce{500};  // one request may come as two signals
            if (sigtimedwait(&ours, nullptr, &kLook) <= 0) continue;
            if (m_asked.request_stop()) {
                first = Clock::now();
            } else if (Clock::now() - first > kOnce) {  // a library that looks at no stop may take long
                pipeline::removeHiddenFolders();
                ::_exit(kInterrupted);
            }
        }
    });
}

Interrupt::~Interrupt() {
    m_waiting.request_stop();
    m_waiting.join();
    pthread_sigmask(SIG_SETMASK, &m_before, nullptr);
}

int tellCancelled() {
    tell("Cancelled. Nothing was written.\n");
    return kInterrupted;
}

}  // namespace app
