#include "pipeline/buffers/any_buffer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace pipeline {

std::size_t AnyBuffer::rows() const {
    return info->domain == Domain::Texel && shape.size() == 3 ? shape[0] * shape[1] : shape[0];
}

std::size_t AnyBuffer::columns() const {
    switch (info->domain) {
        case Domain::Vertex:
        case Domain::Polygon: return 1;
        case Domain::Pixel: return shape[1];
        case Domain::Texel: return shape.back();
    }
    return 1;
}

std::size_t AnyBuffer::count() const {
    return std::visit([](const auto& numbers) { return numbers.size(); }, data);
}

double AnyBuffer::value(std::size_t x, std::size_t y, int c) const {
    assert(x < columns() && y < rows() && c >= 0 && c < channels());
    const auto channelCount = static_cast<std::size_t>(channels());
    return flat((y * columns() + x) * channelCount + static_cast<std::size_t>(c));
}

double AnyBuffer::flat(std::size_t i) const {
    return std::visit([i](const auto& numbers) { return static_cast<double>(numbers[i]); }, data);
}

const char* AnyBuffer::dtype() const {
    constexpr std::array<const char*, 4> kNames{"float32", "float64", "int32", "uint8"};
    return kNames[data.index()];
}

BufferStatistics statistics(const AnyBuffer& buffer) {
    BufferStatistics result;
    double min = std::numeric_limits<double>::infinity(), max = -min;
    std::visit(
        [&](const auto& numbers) {
            for (const auto number : numbers) {
                const double value = static_cast<double>(number);
                if (std::isnan(value))
                    ++result.nan;
                else if (std::isinf(value))
                    ++result.infinite;
                else {
                    ++result.finite;
                    min = std::min(min, value);
                    max = std::max(max, value);
                }
                if (value < 0) ++result.negative;
            }
        },
        buffer.data);
    if (result.finite > 0) {
        result.min = min;
        result.max = max;
    }
    return result;
}

}  // namespace pipeline
