#include "app/cli/progress_printer.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include "app/cli/message.h"

namespace app {

std::string timeLeftText(double seconds) {
    if (seconds < 90) return fmt::format("about {:.0f} s", std::ceil(seconds));
    if (seconds < 5400) return fmt::format("about {:.0f} min", std::ceil(seconds / 60));
    return fmt::format("about {:.1f} h", seconds / 3600);
}

ProgressPrinter::ProgressPrinter(std::string what)
    : m_what(std::move(what)), m_terminal(isatty(STDERR_FILENO) != 0), m_start(Clock::now()), m_last(m_start) {}

ProgressPrinter::~ProgressPrinter() { end(); }

void ProgressPrinter::end() {
    if (std::exchange(m_shown, false)) clearLine();
}

void ProgressPrinter::show(std::size_t done, std::size_t all, std::string_view now) {
    const Clock::time_point at = Clock::now();
    // On a terminal five times a second is as fast as anybody reads.
    const auto pause = m_terminal ? std::chrono::milliseconds(200) : std::chrono::milliseconds(10'000);
    if (at - m_last < pause) return;
    m_last = at;
    const double spent = std::chrono::duration<double>(at - m_start).count();
    std::string text = fmt::format("{}: {} of {}", m_what, done, all);
    if (!now.empty()) text += fmt::format(", {}", now);
    if (done > 0)
        text +=
            fmt::format("; {} left", timeLeftText(spent * static_cast<double>(all - done) / static_cast<double>(done)));
    if (m_terminal) clearLine();
    tell("{}{}", text, m_terminal ? "" : "\n");
    std::fflush(stderr);
    m_shown = m_terminal;
}

}  // namespace app
