#pragma once
#include <array>
#include <csignal>
#include <ctime>

namespace app {

// While one lives, a library that draws letters, plots or 3D views ends the program with a sentence and status 4 where it
// crashes, aborts or goes round for ever: where memory has run out some do so (fontconfig, Mesa). Hidden folders are
// removed. A fault of our own is named the same then, so the guard goes round the calls of the library alone.
class LibraryGuard {
public:
    static constexpr int kNoLimit = 0;
    // cpuSeconds: of this thread, after which it counts as going round for ever; far more than any drawing takes.
    explicit LibraryGuard(int cpuSeconds = 60);
    ~LibraryGuard();
    LibraryGuard(const LibraryGuard&) = delete;
    LibraryGuard& operator=(const LibraryGuard&) = delete;

private:
    static constexpr std::array kSignals{SIGSEGV, SIGBUS, SIGABRT, SIGTRAP, SIGXCPU};  // the last is the timer's

    std::array<struct sigaction, kSignals.size()> m_before{};
    timer_t m_timer{};
    bool m_isTimed = false;
};

// The same function, guarded while it runs.
template <class Function>
auto guarded(Function function) {
    return [function](auto&&... arguments) {
        const LibraryGuard guard;
        return function(arguments...);
    };
}

}  // namespace app
