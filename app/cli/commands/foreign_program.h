#pragma once
#include <chrono>
#include <stop_token>
#include <string>

#include "pipeline/compare/trial.h"

namespace app {

using pipeline::foreign::ProgramOutput;

struct ProgramLimits {
    std::chrono::milliseconds time{10'000};
    std::size_t output = 64 << 20;  // bytes of standard output
    std::string folder;             // where the program starts; empty: where this one does
};

// A word as a shell reads it: in quotation marks.
std::string inShell(const std::string& word);

// Runs a command in a shell, hands it `input` and collects its output. The program and its children are ended after the time
// limit, after too much output, or when it is asked to stop. It gets an environment of PATH, HOME and LANG alone. That limits
// mistakes; it does not confine a program that means harm. An error if no process could be started.
pipeline::Result<ProgramOutput> runProgram(const std::string& command, const std::string& input,
                                           const ProgramLimits& limits, const std::stop_token& stop);

}  // namespace app
