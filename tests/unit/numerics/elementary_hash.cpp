// Prints a hash of a million results of the functions that frames are made of. Built several times, each time compiled
// otherwise (CMakeLists.txt): the hash is the same every time.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "pipeline/core/angles.h"
#include "pipeline/core/elementary.h"
#include "pipeline/core/power.h"

namespace {

// G. Marsaglia, "Xorshift RNGs", Journal of Statistical Software 2003.
std::uint64_t nextBits() {
    static std::uint64_t state = 0x9e3779b97f4a7c15;
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return state;
}
double between(double low, double high) { return low + (high - low) * (double(nextBits() >> 11) * 0x1p-53); }
// A positive normal number of any size.
double anySize() { return std::bit_cast<double>((nextBits() >> 12) | ((nextBits() % 2046 + 1) << 52)); }

std::uint64_t hash = 0xcbf29ce484222325;  // G. Fowler, L. C. Noll and K.-P. Vo, FNV-1a
void add(double x) { hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3; }

}  // namespace

int main() {
    using namespace pipeline;
    for (int i = 0; i < 50'000; ++i) {
        const double small = between(-1, 1), other = between(-1, 1), unit = between(0, 1), large = anySize();
        const double angle = between(-1000, 1000), exponent = between(-1100, 1100), nearOne = between(0.9, 1.1);
        add(sinDegrees(angle)), add(cosDegrees(angle));
        add(pipeline::exp(exponent)), add(pipeline::exp(small)), add(pipeline::exp2(exponent));
        add(pipeline::log(large)), add(pipeline::log2(large)), add(pipeline::log(nearOne)),
            add(pipeline::log2(nearOne));
        add(pipeline::pow(unit, std::abs(angle))), add(pipeline::pow(large, small)),
            add(pipeline::pow(-nearOne, double(i)));
        add(pipeline::atan2(small, other)), add(pipeline::atan2(small, large)), add(pipeline::acos(other));
        add(logOneMinus(unit)), add(expOfNegative(-unit * 710));
        const float a = float(small), b = float(other), positive = float(unit) * 0.99F;
        add(double(logOneMinus(positive))), add(double(expOfNegative(positive * -90)));
        add(double(pipeline::pow(positive, 30 + a))), add(double(pipeline::log2(positive)));
        add(double(pipeline::atan2(a, b))), add(double(pipeline::acos(b)));
    }
    std::printf("%016llx\n", static_cast<unsigned long long>(hash));
    return 0;
}
