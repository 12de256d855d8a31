#pragma once
#include <csignal>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace test {

struct Finished {
    int status = -1;  // exit status; 128 + n when signal n ended it
    std::string out, err;
    std::size_t peakBytes = 0;  // of memory that it had at once
};

// Starts the program with these arguments, as a shell would, without a display, and waits.
Finished run(const std::vector<std::string>& arguments);

// The same, with variables of the environment: "XDG_DATA_HOME=data". Without them it has none but the language.
Finished runIn(const std::vector<std::string>& environment, const std::vector<std::string>& arguments);

// The same, with standard input coming from a file; else there is nothing to be read.
Finished runReading(const std::string& file, const std::vector<std::string>& arguments);

// The same, with standard output going to a file.
Finished runInto(const std::string& file, const std::vector<std::string>& arguments);

// The same, with standard error going to a file; closed where it has no name.
Finished runTellingInto(const std::string& file, const std::vector<std::string>& arguments);

// The same, with so many bytes of memory at most, code and libraries among them.
Finished runWithin(std::size_t bytes, const std::vector<std::string>& arguments);

// The same, with Ctrl+C, or another signal, some time after the program has begun to wait for it.
Finished runAndInterrupt(const std::vector<std::string>& arguments, int milliseconds, int signal = SIGINT);

// The same; meanwhile() is called once, with the number of the process.
Finished runWhile(const std::vector<std::string>& arguments, const std::function<void(int process)>& meanwhile);

// The same, with faults of tests/support/faults.cpp: {{"KILL_AT", 3}}. Not under a sanitizer.
using Faults = std::map<std::string, std::size_t>;
Finished runWithFaults(const Faults& faults, const std::vector<std::string>& arguments);
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kHasFaults = false;
#else
constexpr bool kHasFaults = true;
#endif
// How many changes of folders and allocations there are without a fault.
struct FaultCounts {
    std::size_t changes = 0, allocations = 0;
};
FaultCounts countFaults(const std::vector<std::string>& arguments);

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

// A file of resources/scenes.
std::string scene(const std::string& name);

}  // namespace test
