#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/buffers/buffer_table.h"

namespace pipeline {

// Any buffer of a frame, whatever its type: what views, exporters and reports read.
// Row-major, C order. It keeps the frame's data alive.
struct AnyBuffer {
    BufferName name;
    const BufferInfo* info = nullptr;
    std::vector<std::size_t> shape;  // {H, W}, {H, W, 3}, {V, 3}, {P}, {6, h, w}, samples · 6 for an area light
    std::variant<std::span<const float>, std::span<const double>, std::span<const std::int32_t>,
                 std::span<const std::uint8_t>>
        data;
    std::shared_ptr<const void> owner;

    std::size_t rows() const;     // of the picture: H; faces · h where a light has several; V; P
    std::size_t columns() const;  // W; 1 for vertices and polygons
    int channels() const { return info->channels; }
    std::size_t count() const;  // numbers in all
    // column x, row y, channel c
    double value(std::size_t x, std::size_t y, int c = 0) const;
    double flat(std::size_t i) const;  // the i-th number
    const char* dtype() const;         // "float32", "float64", "int32", "uint8"
};

// Per vertex whether vertices.screen holds a position for it; empty of any other buffer.
std::vector<bool> verticesWithPosition(const AnyBuffer& buffer);

// What a buffer holds. Minimum and maximum are of the finite numbers, 0 where there are none. Vertices without a position
// in vertices.screen are counted, and their numbers are not.
struct BufferStatistics {
    double min = 0, max = 0;
    std::size_t finite = 0, nan = 0, infinite = 0, negative = 0;
    std::size_t withoutPosition = 0;
};
BufferStatistics statistics(const AnyBuffer& buffer);

}  // namespace pipeline
