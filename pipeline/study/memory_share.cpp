#include "pipeline/study/memory_share.h"

#include <chrono>
#include <cstring>
#include <memory>
#include <variant>

#include "pipeline/run/parallel.h"

namespace pipeline {

double bufferBytes(const Frame& frame) {
    double bytes = 0;
    for (const AnyBuffer& buffer : frame.buffers())
        bytes += std::visit([](const auto& numbers) { return double(numbers.size_bytes()); }, buffer.data);
    return bytes;
}

double memsetBandwidth(int threads) {
    constexpr std::size_t kBytes = std::size_t(256) << 20, kPiece = std::size_t(8) << 20;
    Threads team(threads, {});
    const auto block = std::make_unique_for_overwrite<unsigned char[]>(kBytes);
    double fastest = 0;
    for (int time = -1; time < 5; ++time) {  // the first finds the pages
        const auto start = std::chrono::steady_clock::now();
        team.forRange(kBytes, kPiece, [&](std::size_t begin, std::size_t end) {
            std::memset(block.get() + begin, time & 0xff, end - begin);
        });
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        if (time >= 0) fastest = std::max(fastest, double(kBytes) / taken.count());
    }
    // Read once, so that no compiler may leave the writing out.
    const volatile unsigned char last = block[kBytes - 1];
    return last == 4 ? fastest : 0;
}

}  // namespace pipeline
