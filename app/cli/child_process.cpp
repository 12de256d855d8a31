#include "app/cli/child_process.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

namespace app {

pipeline::Result<int> runOurselves(const std::vector<std::string>& arguments, std::stop_token stop) {
    // The file that runs, whatever it was called by and wherever it has been moved to since.
    constexpr const char* kProgram = "/proc/self/exe";
    std::vector<char*> argv{const_cast<char*>("shadescope")};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);

    // Signals that Interrupt keeps for itself must reach the other one, also where a shell has them ignored.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    sigset_t stopping;
    sigemptyset(&stopping);
    sigaddset(&stopping, SIGTERM);
    posix_spawnattr_setsigdefault(&attributes, &stopping);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    pid_t child = 0;
    const int error = posix_spawn(&child, kProgram, nullptr, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    if (error != 0)
        return pipeline::Error{
            {}, fmt::format("could not start a process: {}", std::generic_category().message(error)), {}};

    {
        // Its number stays taken until it is waited for below: the signal never reaches another one.
        const std::stop_callback passOn(std::move(stop), [child] { kill(child, SIGTERM); });
        siginfo_t ended;
        while (waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
        }
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace app
