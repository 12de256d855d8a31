#include "app/cli/commands/child_process.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

namespace app {

pipeline::Result<int> runOurselves(const std::vector<std::string>& arguments, std::stop_token stop) {
    // The file that runs, whatever it was called by and wherever it has been moved to since.
    constexpr const char* kProgram = "/proc/self/exe";
    constexpr int kNotStarted = 127;  // as shells have it
    std::vector<char*> argv{const_cast<char*>("shadescope")};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);

    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child < 0)
        return pipeline::Error{
            {}, fmt::format("could not start a process: {}", std::generic_category().message(errno)), {}};
    if (child == 0) {
        // Between fork and execv only what signal-safety(7) lists. However this process ends, the other one ends with
        // it; where it has ended already nobody would tell.
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() != parent) ::_exit(kNotStarted);
        // Signals that Interrupt keeps for itself must reach the other one, also where a shell has them ignored.
        ::signal(SIGTERM, SIG_DFL);
        sigset_t none;
        ::sigemptyset(&none);
        ::sigprocmask(SIG_SETMASK, &none, nullptr);
        ::execv(kProgram, argv.data());
        ::_exit(kNotStarted);
    }

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
    if (WIFEXITED(status) && WEXITSTATUS(status) == kNotStarted)
        return pipeline::Error{{}, "could not start a process", {}};
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace app
