#include "pipeline/buffers/late_buffer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <thread>

#include "pipeline/buffers/block_buffer.h"

namespace pipeline {
namespace {

TEST(LateBuffer, IsMadeOnceForWhoeverReadsFirst) {
    std::atomic<int> made = 0;
    const LateBuffer2D<int> late([&] {
        ++made;
        return Buffer2D<int>({2, 2}, 7);
    });
    EXPECT_EQ(made, 0);
    std::atomic<int> sum = 0;
    {
        std::vector<std::jthread> readers;
        for (int i = 0; i < 8; ++i) readers.emplace_back([&] { sum += late->at({1, 1}); });
    }
    EXPECT_EQ(made, 1);
    EXPECT_EQ(sum, 8 * 7);
}

TEST(LateBuffer, HasCopiesOfItsOwn) {
    const LateBuffer2D<int> late([] { return Buffer2D<int>({3, 1}, 1); });
    LateBuffer2D<int> copy = late;
    copy->at({2, 0}) = 9;
    EXPECT_EQ(copy->pixels, (Buffer2D<int>::Pixels{1, 1, 9}));
    EXPECT_EQ(late->pixels, (Buffer2D<int>::Pixels{1, 1, 1}));
}

// Vectors load and store whole blocks: each must stand at a multiple of its own size, 64 bytes, whatever the C library
// gives; a copy and what has been moved, too.
TEST(BlockBuffer, StandsAtAMultipleOfABlock) {
    const auto misplaced = [](const auto& buffer) { return reinterpret_cast<std::uintptr_t>(buffer.tile(0)) % 64; };
    for (int width = 1; width < 700; width += 64) {
        BlockBuffer2D<float> buffer({width, 1});
        const BlockBuffer2D<std::uint32_t> other({width, 65});
        buffer.fill(0, 1);
        const BlockBuffer2D<float> copy = buffer, moved = std::move(buffer);
        EXPECT_EQ(misplaced(other), 0u);
        EXPECT_EQ(misplaced(copy), 0u);
        EXPECT_EQ(misplaced(moved), 0u);
        EXPECT_EQ(copy.tile(0)->of[15], 1);
    }
}

// Every pixel is written where the documentation of BlockBuffer2D says: tile after tile of 64 × 64, in it block after
// block of 4 × 4, in a block row after row. Rows must give it back, also where a tile or a block ends beyond the picture.
TEST(BlockBuffer, GivesRowsOfTheSamePixels) {
    for (const glm::ivec2 size : {glm::ivec2(64, 64), glm::ivec2(130, 67), glm::ivec2(3, 5), glm::ivec2(65, 1)}) {
        BlockBuffer2D<int> blocks(size);
        const int columns = (size.x + 63) / 64;
        std::vector<int> numbers(std::size_t(size.x) * std::size_t(size.y));
        std::iota(numbers.begin(), numbers.end(), 0);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const int tile = y / 64 * columns + x / 64, block = y % 64 / 4 * 16 + x % 64 / 4;
                blocks.tile(std::size_t(tile))[block].of[y % 4 * 4 + x % 4] = numbers[std::size_t(y * size.x + x)];
            }
        const Buffer2D<int> rows = rowsOf(blocks, std::vector<std::uint8_t>(blocks.tileCount(), 1), -1);
        EXPECT_EQ(rows.size, size);
        EXPECT_TRUE(std::ranges::equal(rows.pixels, numbers)) << size.x << " by " << size.y;
    }
}

TEST(BlockBuffer, HoldsNothingInTilesThatAreNotWritten) {
    BlockBuffer2D<int> blocks({128, 64});
    blocks.fill(1, 5);
    const Buffer2D<int> rows = rowsOf(blocks, {0, 1}, -1);
    for (int x = 0; x < 128; ++x) EXPECT_EQ(rows.at({x, 63}), x < 64 ? -1 : 5);
}

}  // namespace
}  // namespace pipeline
