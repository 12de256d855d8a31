#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/stages/translucent.h"

namespace pipeline {

// The layers of a tile, peeled off: the farthest layer of each pixel, then the next farthest, and so on.
// C. Everitt, "Interactive order-independent transparency", NVIDIA 2001, peels from the nearest.
class Peels {
public:
    // layers: those of one pixel side by side, the farthest first.
    explicit Peels(std::span<const Layer<float>> layers) : m_order(layers.size()) {
        std::vector<std::uint32_t> depths(layers.size(), 0);  // how many layers lie under it
        std::uint32_t most = 0;
        for (std::size_t i = 1; i < layers.size(); ++i) {
            if (layers[i].pixel == layers[i - 1].pixel) depths[i] = depths[i - 1] + 1;
            most = std::max(most, depths[i]);
        }
        m_first.assign(layers.empty() ? 1 : most + 2, 0);
        for (const std::uint32_t depth : depths) ++m_first[depth + 1];
        for (std::size_t k = 1; k < m_first.size(); ++k) m_first[k] += m_first[k - 1];
        std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
        for (std::size_t i = 0; i < layers.size(); ++i) m_order[next[depths[i]]++] = std::uint32_t(i);
    }
    std::size_t count() const { return m_first.size() - 1; }
    // Indices into the layers.
    std::span<const std::uint32_t> of(std::size_t k) const {
        return std::span(m_order).subspan(m_first[k], m_first[k + 1] - m_first[k]);
    }

private:
    std::vector<std::uint32_t> m_order;
    std::vector<std::uint32_t> m_first;  // of each peel, in m_order, and the end
};

}  // namespace pipeline
