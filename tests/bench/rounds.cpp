#include "tests/bench/rounds.h"

#include <sched.h>
#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <fstream>

namespace bench {

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

namespace {

double secondsOf(Watch watch) {
    timespec now{};
    clock_gettime(watch == Watch::Wall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

}  // namespace

std::vector<std::vector<double>> takeTurns(const std::vector<Contestant>& contestants, const Turns& turns,
                                           Watch watch) {
    std::vector<std::vector<double>> medians(contestants.size());
    for (int round = -1; round < turns.rounds; ++round) {
        for (std::size_t i = 0; i < contestants.size(); ++i) {
            std::vector<double> frames;
            contestants[i].drawFrame();  // after another's turn the caches are cold
            const double start = secondsOf(watch);
            while (frames.size() < 3 || secondsOf(watch) - start < turns.seconds) {
                const double begins = secondsOf(watch);
                contestants[i].drawFrame();
                frames.push_back((secondsOf(watch) - begins) * 1000);
            }
            if (round >= 0) medians[i].push_back(median(std::move(frames)));
        }
    }
    return medians;
}

bool useProcessors(int count) {
    cpu_set_t allowed, chosen;
    CPU_ZERO(&chosen);
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return false;
    if (count == 0) return true;
    int taken = 0;
    for (int cpu = 0; cpu < CPU_SETSIZE && taken < count; ++cpu) {
        if (!CPU_ISSET(cpu, &allowed)) continue;
        CPU_SET(cpu, &chosen);
        ++taken;
    }
    return taken == count && sched_setaffinity(0, sizeof chosen, &chosen) == 0;
}

int processorCount() {
    cpu_set_t allowed;
    return sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? CPU_COUNT(&allowed) : 1;
}

std::string processorName() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
    return {};
}

double peakMegabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) * 1024 / 1e6;
}

}  // namespace bench
