#include "tests/cli/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <sstream>
#include <thread>

#include "tests/support/files.h"

namespace test {

namespace {

constexpr const char* kClosed = "closed";

// Standard output and error go to these files; empty: to ones whose text is given back.
Finished start(const std::vector<std::string>& arguments, std::string out, std::string err,
               const std::function<void(pid_t)>& meanwhile, std::vector<std::string> environment = {},
               const std::string& in = "/dev/null") {
    const TemporaryFolder folder;
    if (out.empty()) out = (folder / "out").string();
    if (err.empty()) err = (folder / "err").string();

    std::vector<std::string> words{SHADESCOPE_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    environment.emplace_back("LC_ALL=C.UTF-8");  // no DISPLAY
    std::vector<char*> envp;
    for (std::string& word : environment) envp.push_back(word.data());
    envp.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, in.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
    if (err == kClosed)
        posix_spawn_file_actions_addclose(&actions, STDERR_FILENO);
    else
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
    pid_t program = 0;
    const int failed = posix_spawn(&program, argv[0], &actions, nullptr, argv.data(), envp.data());
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) return {};

    meanwhile(program);
    int status = 0;
    rusage usage{};
    wait4(program, &status, 0, &usage);
    Finished finished;
    finished.peakBytes = std::size_t(usage.ru_maxrss) * 1024;
    finished.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (out.starts_with(folder.path().string())) finished.out = readText(out);
    if (err.starts_with(folder.path().string())) finished.err = readText(err);
    return finished;
}

// Until the program has asked for the signals that end it, or has ended: a busy machine starts it late.
void waitForItsSignals(pid_t program) {
    const std::string status = "/proc/" + std::to_string(program) + "/status";
    for (int looks = 0; looks < 3000; ++looks) {
        std::istringstream lines(readText(status));
        unsigned long long blocked = 0;
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with("State:\tZ")) return;
            if (line.starts_with("SigBlk:")) blocked = std::stoull(line.substr(7), nullptr, 16);
        }
        for (const int signal : {SIGINT, SIGTERM, SIGHUP})
            if ((blocked >> (signal - 1) & 1) != 0) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

}  // namespace

Finished run(const std::vector<std::string>& arguments) { return runInto("", arguments); }

Finished runIn(const std::vector<std::string>& environment, const std::vector<std::string>& arguments) {
    return start(
        arguments, "", "", [](pid_t) {}, environment);
}

Finished runReading(const std::string& file, const std::vector<std::string>& arguments) {
    return start(
        arguments, "", "", [](pid_t) {}, {}, file);
}

Finished runInto(const std::string& file, const std::vector<std::string>& arguments) {
    return start(arguments, file, "", [](pid_t) {});
}

Finished runTellingInto(const std::string& file, const std::vector<std::string>& arguments) {
    return start(arguments, "", file.empty() ? kClosed : file, [](pid_t) {});
}

Finished runWithin(std::size_t bytes, const std::vector<std::string>& arguments) {
    rlimit before{};
    getrlimit(RLIMIT_AS, &before);
    const rlimit less{bytes, before.rlim_max};  // the program has it from here
    setrlimit(RLIMIT_AS, &less);
    Finished finished = start(arguments, "", "", [&](pid_t) { setrlimit(RLIMIT_AS, &before); });
    return finished;
}

Finished runWhile(const std::vector<std::string>& arguments, const std::function<void(int)>& meanwhile) {
    return start(arguments, "", "", meanwhile);
}

Finished runWithFaults(const Faults& faults, const std::vector<std::string>& arguments) {
    std::vector<std::string> environment{"LD_PRELOAD=" SHADESCOPE_FAULTS};
    for (const auto& [name, number] : faults)
        environment.push_back("SHADESCOPE_TEST_" + name + '=' + std::to_string(number));
    return start(
        arguments, "", "", [](pid_t) {}, environment);
}

FaultCounts countFaults(const std::vector<std::string>& arguments) {
    const TemporaryFolder folder;
    const std::string file = folder / "counts";
    start(arguments, "", "", [](pid_t) {}, {"LD_PRELOAD=" SHADESCOPE_FAULTS, "SHADESCOPE_TEST_COUNTS=" + file});
    FaultCounts counts;
    std::istringstream(readText(file)) >> counts.changes >> counts.allocations;
    return counts;
}

Finished runAndInterrupt(const std::vector<std::string>& arguments, int milliseconds, int signal) {
    return start(arguments, "", "", [&](pid_t program) {
        waitForItsSignals(program);
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
        kill(program, signal);
    });
}

std::string scene(const std::string& name) { return std::string(SHADESCOPE_SCENES) + '/' + name; }

}  // namespace test
