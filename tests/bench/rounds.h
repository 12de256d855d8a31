#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace bench {

// Renderers that take turns on the same processors: whatever else the machine does hits all of them.
struct Contestant {
    std::string name;
    std::function<void()> drawFrame;
};

struct Turns {
    int rounds = 5;
    double seconds = 0.3;  // that a contestant draws for in each round; at least three frames
};

// What a frame's time is read from: the clock on the wall, or how long the process' threads had a processor. Of one
// thread the two are the same on an idle machine; on a busy one the second leaves out the time of others.
enum class Watch : std::uint8_t { Wall, Processor };

// The median time of a frame in every round, ms: [contestant][round]. One round more is drawn before, and not counted.
std::vector<std::vector<double>> takeTurns(const std::vector<Contestant>& contestants, const Turns& turns, Watch watch);

double median(std::vector<double> values);  // at least one

// Runs the calling process, and the threads it starts from now on, on `count` processors; false where there are
// fewer. All of them where count is 0.
bool useProcessors(int count);
int processorCount();         // that this process may use
std::string processorName();  // as the system calls it; empty where it does not say
double peakMegabytes();       // of this process so far, 10^6 bytes

}  // namespace bench
