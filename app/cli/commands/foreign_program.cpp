#include "app/cli/commands/foreign_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>
#include <vector>

namespace app {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kMessages = 4096;  // bytes

class Pipe {
public:
    Pipe() { m_open = ::pipe2(m_ends.data(), O_CLOEXEC) == 0; }
    ~Pipe() { close(0), close(1); }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    bool isOpen() const { return m_open; }
    int end(std::size_t i) const { return m_ends[i]; }
    void close(std::size_t i) {
        if (m_ends[i] >= 0) ::close(m_ends[i]);
        m_ends[i] = -1;
    }
    // The end that this process keeps.
    void keep(std::size_t i) {
        close(1 - i);
        ::fcntl(m_ends[i], F_SETFL, O_NONBLOCK);
    }

private:
    std::array<int, 2> m_ends{-1, -1};
    bool m_open = false;
};

pipeline::Error failed(std::string_view what) {
    return {{}, fmt::format("{}: {}", what, std::generic_category().message(errno))};
}

// A program that reads no further is no error of ours.
class NoBrokenPipes {
public:
    NoBrokenPipes() : m_before(::signal(SIGPIPE, SIG_IGN)) {}
    ~NoBrokenPipes() { ::signal(SIGPIPE, m_before); }
    NoBrokenPipes(const NoBrokenPipes&) = delete;
    NoBrokenPipes& operator=(const NoBrokenPipes&) = delete;

private:
    void (*m_before)(int);
};

[[noreturn]] void become(const std::vector<char*>& argv, const std::vector<char*>& environment, const Pipe& in,
                         const Pipe& out, const Pipe& err, const std::string& folder) {
    // Between fork and execve only what signal-safety(7) lists.
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::signal(SIGTERM, SIG_DFL), ::signal(SIGPIPE, SIG_DFL), ::signal(SIGINT, SIG_DFL);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    ::dup2(in.end(0), STDIN_FILENO), ::dup2(out.end(1), STDOUT_FILENO), ::dup2(err.end(1), STDERR_FILENO);
    if (!folder.empty() && ::chdir(folder.c_str()) != 0) ::_exit(126);
    ::execve(argv[0], argv.data(), environment.data());
    ::_exit(127);
}

// What is there now, at the end of a text. False at the end of the stream.
bool readInto(int from, std::string& text) {
    std::array<char, 65536> bytes;
    const ssize_t count = ::read(from, bytes.data(), bytes.size());
    if (count > 0) text.append(bytes.data(), std::size_t(count));
    return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

}  // namespace

std::string inShell(const std::string& word) {
    std::string out = "'";
    for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

pipeline::Result<ProgramOutput> runProgram(const std::string& command, const std::string& input,
                                           const ProgramLimits& limits, const std::stop_token& stop) {
    Pipe in, out, err;
    if (!in.isOpen() || !out.isOpen() || !err.isOpen()) return failed("could not make a pipe");
    std::string shell = "/bin/sh", flag = "-c", text = command;
    const std::vector<char*> argv{shell.data(), flag.data(), text.data(), nullptr};
    std::vector<std::string> variables{"LANG=C.UTF-8"};
    for (const char* variable : {"PATH", "HOME"})
        if (const char* const value = std::getenv(variable)) variables.push_back(fmt::format("{}={}", variable, value));
    std::vector<char*> environment;
    for (std::string& variable : variables) environment.push_back(variable.data());
    environment.push_back(nullptr);

    const NoBrokenPipes quiet;
    const Clock::time_point start = Clock::now();
    const pid_t child = ::fork();
    if (child < 0) return failed("could not start a process");
    if (child == 0) become(argv, environment, in, out, err, limits.folder);
    ::setpgid(child, child);  // also here: whichever process comes first
    in.keep(1), out.keep(0), err.keep(0);

    ProgramOutput result;
    std::string ended;  // why it was
    std::size_t written = 0;
    bool reads = true, says = true;
    while (reads || says) {
        if (stop.stop_requested()) ended = "it was asked to stop";
        if (Clock::now() - start > limits.time)
            ended = fmt::format("it was still running after {:.3g} s", double(limits.time.count()) / 1000);
        if (result.output.size() > limits.output) ended = fmt::format("it wrote more than {} MB", limits.output >> 20);
        if (!ended.empty()) break;
        std::array<pollfd, 3> waits{
            {{reads ? out.end(0) : -1, POLLIN, 0}, {says ? err.end(0) : -1, POLLIN, 0}, {in.end(1), POLLOUT, 0}}};
        if (in.end(1) < 0) waits[2].fd = -1;
        constexpr int kLook = 20;  // ms between looks at the clock
        if (::poll(waits.data(), waits.size(), kLook) <= 0) continue;
        if (waits[0].revents) reads = readInto(out.end(0), result.output);
        if (waits[1].revents) {
            says = readInto(err.end(0), result.messages);
            if (result.messages.size() > kMessages) result.messages.erase(0, result.messages.size() - kMessages);
        }
        if (waits[2].revents) {
            const ssize_t count = ::write(in.end(1), input.data() + written, input.size() - written);
            if (count > 0) written += std::size_t(count);
            if (written == input.size() || (count < 0 && errno != EAGAIN && errno != EINTR)) in.close(1);
        }
    }
    in.close(1);
    // A program may close its output and go on.
    int status = 0;
    while (ended.empty() && ::waitpid(child, &status, WNOHANG) == 0) {
        if (stop.stop_requested()) ended = "it was asked to stop";
        if (Clock::now() - start > limits.time)
            ended = fmt::format("it was still running after {:.3g} s", double(limits.time.count()) / 1000);
        constexpr timespec kLook{0, 2'000'000};
        ::nanosleep(&kLook, nullptr);
    }
    ::kill(-child, SIGKILL);  // children that it left behind too
    if (!ended.empty()) {
        while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
        }
        result.failure = "Your program was ended: " + ended + ".", result.isEnded = true;
        return result;
    }
    result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (WIFSIGNALED(status))
        result.failure = fmt::format("Your program was ended by signal {}.", WTERMSIG(status));
    else if (WEXITSTATUS(status) != 0)
        result.failure = fmt::format("Your program ended with status {}.", WEXITSTATUS(status));
    return result;
}

}  // namespace app
