// Time of reading files made to take a careless reader quadratic time (tests/support/hostile_files.h), of one size and of
// twice that, interleaved: the ratio is about 2 where the time grows with the file, and 4 where with its square.
//   hostile_bench           20000 lines or corners, and 40000
//   hostile_bench 5000
#include <cstdlib>

#include <fmt/format.h>

#include "tests/bench/rounds.h"
#include "tests/support/hostile_files.h"

int main(int argc, char** argv) {
    const std::size_t n = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 20'000;
    if (n == 0) {
        fmt::print(stderr, "hostile_bench: the argument is a size, a whole number above 0\n");
        return 2;
    }
    fmt::print("{:<16} {:>10} {:>10} {:>10} {:>6}\n", "file", "KB", "ms", "ms of two", "ratio");
    for (const test::HostileFile& file : test::hostileFiles()) {
        const std::string once = file.text(n), twice = file.text(2 * n);
        const auto times = bench::takeTurns({{"once", [&] { file.read(once); }}, {"twice", [&] { file.read(twice); }}},
                                            {5, 0}, bench::Watch::Processor);
        std::vector<double> ratios;
        for (std::size_t round = 0; round < times[0].size(); ++round)
            ratios.push_back(times[1][round] / times[0][round]);
        fmt::print("{:<16} {:>10} {:>10.2f} {:>10.2f} {:>6.2f}\n", file.name, once.size() / 1000,
                   bench::median(times[0]), bench::median(times[1]), bench::median(ratios));
        std::fflush(stdout);
    }
}
