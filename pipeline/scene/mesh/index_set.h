#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pipeline {

// Numbers from 0 to n - 1 of which the next one is found in time log n: a bit each, and above every 64 words one word that
// says which of them hold a bit.
class IndexSet {
public:
    static constexpr std::uint32_t kNone = UINT32_MAX;

    explicit IndexSet(std::size_t n) {
        do {
            n = (n + 63) / 64;
            m_levels.emplace_back(n, 0);
        } while (n > 1);
    }

    void insert(std::uint32_t i) {
        for (std::vector<std::uint64_t>& words : m_levels) words[i / 64] |= bitOf(i), i /= 64;
    }
    void erase(std::uint32_t i) {
        for (std::vector<std::uint64_t>& words : m_levels) {
            words[i / 64] &= ~bitOf(i);
            if (words[i / 64] != 0) return;
            i /= 64;
        }
    }
    // The smallest that is not below i, else the smallest of all; kNone where there is none.
    std::uint32_t from(std::uint32_t i) const {
        const std::uint32_t found = notBelow(i);
        return found == kNone && i > 0 ? notBelow(0) : found;
    }

private:
    static std::uint64_t bitOf(std::uint32_t i) { return std::uint64_t{1} << (i % 64); }

    std::uint32_t notBelow(std::uint32_t i) const {
        for (std::size_t level = 0; level < m_levels.size(); ++level) {
            if (i / 64 >= m_levels[level].size()) return kNone;
            const std::uint64_t word = m_levels[level][i / 64] & ~(bitOf(i) - 1);
            if (word == 0) {
                i = i / 64 + 1;
                continue;
            }
            i = i / 64 * 64 + static_cast<std::uint32_t>(std::countr_zero(word));
            while (level-- > 0) i = i * 64 + static_cast<std::uint32_t>(std::countr_zero(m_levels[level][i]));
            return i;
        }
        return kNone;
    }

    std::vector<std::vector<std::uint64_t>> m_levels;
};

}  // namespace pipeline
