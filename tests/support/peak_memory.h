#pragma once
#include <fstream>
#include <string>

#include "pipeline/core/memory.h"

namespace test {

// Bytes that this process has held at most.
inline double peakBytes() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) * 1024;
    return 0;
}

// How many bytes more it held at most while `work` ran.
template <class Work>
double peakOf(Work work) {
    pipeline::giveBackFreedMemory();
    std::ofstream("/proc/self/clear_refs") << 5;  // the peak begins anew, see proc(5)
    const double before = peakBytes();
    work();
    return peakBytes() - before;
}

}  // namespace test
