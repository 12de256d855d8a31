#include "pipeline/buffers/any_buffer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <type_traits>

#include "pipeline/buffers/screen_position.h"

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

namespace {

// Several counts and extremes side by side, so that the compiler takes them in one vector.
template <class T>
struct Lanes {
    static constexpr std::size_t kCount = 16;
    using Count = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
    std::array<T, kCount> min, max;
    std::array<Count, kCount> finite{}, nan{}, negative{};

    Lanes() {
        min.fill(std::numeric_limits<T>::max());
        max.fill(std::numeric_limits<T>::lowest());
    }
    void add(std::size_t lane, T value) {
        if constexpr (std::is_floating_point_v<T>) {
            const bool isFinite = value - value == 0;
            const T small = isFinite ? value : std::numeric_limits<T>::max();
            const T large = isFinite ? value : std::numeric_limits<T>::lowest();
            min[lane] = small < min[lane] ? small : min[lane];
            max[lane] = large > max[lane] ? large : max[lane];
            finite[lane] += isFinite;
            nan[lane] += value != value;
        } else {
            min[lane] = value < min[lane] ? value : min[lane];
            max[lane] = value > max[lane] ? value : max[lane];
            ++finite[lane];
        }
        if constexpr (std::is_signed_v<T>) negative[lane] += value < T(0);
    }
};

template <class T>
void addStatistics(std::span<const T> numbers, BufferStatistics& result) {
    Lanes<T> lanes;
    std::size_t i = 0;
    for (; i + Lanes<T>::kCount <= numbers.size(); i += Lanes<T>::kCount)
        for (std::size_t lane = 0; lane < Lanes<T>::kCount; ++lane) lanes.add(lane, numbers[i + lane]);
    for (std::size_t lane = 0; i < numbers.size(); ++i, ++lane) lanes.add(lane, numbers[i]);
    for (std::size_t lane = 0; lane < Lanes<T>::kCount; ++lane) {
        result.finite += std::size_t(lanes.finite[lane]);
        result.nan += std::size_t(lanes.nan[lane]);
        result.negative += std::size_t(lanes.negative[lane]);
    }
    result.infinite = numbers.size() - result.finite - result.nan;
    if (result.finite == 0) return;
    result.min = double(*std::ranges::min_element(lanes.min));
    result.max = double(*std::ranges::max_element(lanes.max));
}

}  // namespace

std::vector<bool> rowsWithValue(const AnyBuffer& buffer) {
    if (buffer.hasValue) return *buffer.hasValue;
    if (buffer.info->id != BufferId::VerticesScreen) return {};
    std::vector<bool> with(buffer.rows());
    for (std::size_t i = 0; i < with.size(); ++i)
        with[i] = hasScreenPosition(Vec3d(buffer.flat(3 * i), buffer.flat(3 * i + 1), buffer.flat(3 * i + 2)));
    return with;
}

BufferStatistics statistics(const AnyBuffer& buffer) {
    BufferStatistics result;
    const std::vector<bool> with = rowsWithValue(buffer);
    result.withoutValue = std::size_t(std::ranges::count(with, false));
    std::visit(
        [&](const auto& numbers) {
            if (result.withoutValue == 0) return addStatistics(numbers, result);
            const auto channels = std::size_t(buffer.channels());
            std::vector<typename std::decay_t<decltype(numbers)>::value_type> values;
            for (std::size_t i = 0; i < numbers.size(); ++i)
                if (with[i / channels]) values.push_back(numbers[i]);
            addStatistics(std::span<const typename decltype(values)::value_type>(values), result);
        },
        buffer.data);
    return result;
}

}  // namespace pipeline
