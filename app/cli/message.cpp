#include "app/cli/message.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

#include "pipeline/core/printable.h"

namespace app {

void writeEscaped(std::string_view text, std::FILE* to) {
    const std::string escaped = pipeline::escapedLines(text);
    std::fwrite(escaped.data(), 1, escaped.size(), to);
}

void sayText(std::string_view text) {
    errno = 0;
    writeEscaped(text, stdout);
    if (std::ferror(stdout) != 0) throw std::system_error(errno != 0 ? errno : EIO, std::generic_category());
}

void sayBold(std::string_view text) {
    std::fputs("\x1b[1m", stdout);
    writeEscaped(text, stdout);
    std::fputs("\x1b[0m", stdout);
}

void clearLine() { std::fputs("\r\x1b[K", stderr); }

void keepStandardFiles() {
    // open() gives the lowest free number, so that these are filled from below.
    for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(number, F_GETFD) < 0) ::open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void tellOfFullFiles() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace app
