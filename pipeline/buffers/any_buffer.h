#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
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
    // Of polygons or vertices, one for each: false if it has no value; its numbers are 0. Null if all have one.
    std::shared_ptr<const std::vector<bool>> hasValue = nullptr;

    std::size_t rows() const;     // of the picture: H; faces · h where a light has several; V; P
    std::size_t columns() const;  // W; 1 for vertices and polygons
    int channels() const { return info->channels; }
    std::size_t count() const;  // numbers in all
    // column x, row y, channel c
    double value(std::size_t x, std::size_t y, int c = 0) const;
    double flat(std::size_t i) const;  // the i-th number
    const char* dtype() const;         // "float32", "float64", "int32", "uint8"
};

// Per polygon or vertex whether the buffer has a value for it; empty if all have one. A polygon that the cull stage
// drops has what a stage computes for all polygons: positions, verdict, area, normal. It is not lit, so it has no intensity.
// vertices.screen has no value for a vertex without a position in the picture.
std::vector<bool> rowsWithValue(const AnyBuffer& buffer);

// What a buffer holds. Minimum and maximum are of the finite numbers, 0 where there are none. Rows without a value are
// counted, and their numbers are not.
struct BufferStatistics {
    double min = 0, max = 0;
    std::size_t finite = 0, nan = 0, infinite = 0, negative = 0;
    std::size_t withoutValue = 0;
};
BufferStatistics statistics(const AnyBuffer& buffer);

}  // namespace pipeline
