#include "app/cli/message.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

namespace app {

void keepStandardFiles() {
    // open() gives the lowest free number, so that these are filled from below.
    for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(number, F_GETFD) < 0) ::open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void tellOfFullFiles() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace app
