#pragma once
#include <chrono>
#include <string>
#include <string_view>

namespace app {

// How far long work is, on standard error: one line that is written over again on a terminal, and a
// line every ten seconds where it is not one.
class ProgressPrinter {
public:
    explicit ProgressPrinter(std::string what);
    ~ProgressPrinter();
    ProgressPrinter(const ProgressPrinter&) = delete;
    ProgressPrinter& operator=(const ProgressPrinter&) = delete;

    // `now` says what is being done; the time that is left is taken from the speed so far.
    void show(std::size_t done, std::size_t all, std::string_view now = {});
    void end();  // leaves no half line behind, for what is said next; so does its own end

private:
    using Clock = std::chrono::steady_clock;
    std::string m_what;
    bool m_terminal, m_shown = false;
    Clock::time_point m_start, m_last;
};

// "about 4 s", "about 3 min", for people.
std::string timeLeftText(double seconds);

}  // namespace app
