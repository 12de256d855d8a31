// Files made to take a reader quadratic time: twice the file is about twice the work.
#include "tests/support/hostile_files.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include "tests/support/looks.h"

namespace {

std::atomic<std::size_t> allocations{0}, allocatedBytes{0};

}  // namespace

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which have operators of their own

// Of the whole test program: what operator new is asked for is counted. Inlined, one of a pair looks mismatched.
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations, allocatedBytes += size;
    if (void* const at = std::malloc(size > 0 ? size : 1)) return at;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* at) noexcept { std::free(at); }
[[gnu::noinline]] void operator delete(void* at, std::size_t) noexcept { std::free(at); }

#endif

namespace {

struct Work {
    std::size_t items = 0, allocations = 0, bytes = 0;
};

Work workOf(const test::HostileFile& file, std::size_t n) {
    const std::string text = file.text(n);
    const test::Looks looks;
    const std::size_t before = allocations, bytesBefore = allocatedBytes;
    file.read(text);
    return {test::Looks::items(), allocations - before, allocatedBytes - bytesBefore};
}

class HostileFiles : public testing::TestWithParam<test::HostileFile> {};

// Quadratic work would be 16 times as much of 4 times the file. Linear work is 4 times, n log n a fifth more, and n^1.5
// 8 times; buffers that double, and tables that are there once, move it a little.
TEST_P(HostileFiles, DoNotTakeQuadraticWork) {
    constexpr std::size_t n = 1000;
    const Work once = workOf(GetParam(), n), more = workOf(GetParam(), 4 * n);
    EXPECT_LE(double(more.items), 1.35 * std::pow(4, GetParam().power) * double(once.items));
    EXPECT_LE(double(more.allocations), 5.5 * double(once.allocations) + 100);
    EXPECT_LE(double(more.bytes), 6.5 * double(once.bytes) + 100'000);
}

INSTANTIATE_TEST_SUITE_P(Of, HostileFiles, testing::ValuesIn(test::hostileFiles().begin(), test::hostileFiles().end()),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
