#include "pipeline/study/machine.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <thread>

namespace pipeline {

std::string machineName() {
    std::string name = "unknown processor";
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const auto colon = line.find(": ");
        if (!line.starts_with("model name") || colon == line.npos) continue;
        name = line.substr(colon + 2);
        break;
    }
    const unsigned count = std::thread::hardware_concurrency();
    return fmt::format("{}, {} processor{}", name, count, count == 1 ? "" : "s");
}

std::string compilerName() {
#ifdef __clang__
    const std::string compiler = "Clang " __clang_version__;
#else
    const std::string compiler = "GCC " __VERSION__;
#endif
#ifdef __OPTIMIZE__
    return compiler + ", optimized";
#else
    return compiler + ", not optimized";
#endif
}

double loadAverage() {
    double load = -1;
    return getloadavg(&load, 1) == 1 ? load : -1;
}

}  // namespace pipeline
