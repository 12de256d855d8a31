#pragma once
#include <signal.h>

#include <stop_token>
#include <thread>

namespace app {

// While it lives, Ctrl+C (and a plain kill, and a terminal that is closed) asks to stop instead of ending the program,
// so that nothing half done stays behind. Asked again half a second later, the program ends at once and removes only its
// hidden folders. Made before any other thread, which then leaves the signals to it.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return m_asked.get_token(); }
    bool asked() const { return m_asked.stop_requested(); }

private:
    sigset_t m_before{};
    std::stop_source m_asked;
    std::jthread m_waiting;  // last: ends before what it uses
};

// What a command that has stopped before it wrote says, and its exit status.
int tellCancelled();

}  // namespace app
