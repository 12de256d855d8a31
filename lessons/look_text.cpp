#include "lessons/look_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "pipeline/buffers/verdict.h"
#include "pipeline/contracts/contract.h"
#include "pipeline/core/text.h"
#include "pipeline/inspect/pixel_report.h"

namespace lessons {

std::string numberText(double value) {
    if (std::isinf(value)) return value > 0 ? "+∞" : "−∞";
    return fmt::format("{:.4g}", value);
}

namespace {

using pipeline::AnyBuffer;
using pipeline::BufferId;
using pipeline::Domain;

constexpr std::size_t kMostRows = 12;

// The numbers of an element, "(0.3, 0.1, 0.9)"; of a verdict its name.
std::string valueText(const AnyBuffer& buffer, std::size_t x, std::size_t y) {
    if (buffer.info->palette == pipeline::Palette::Verdict)
        return std::string(name(static_cast<pipeline::Verdict>(buffer.value(x, y))));
    std::string text;
    for (int c = 0; c < buffer.channels(); ++c) text += (c == 0 ? "" : ", ") + numberText(buffer.value(x, y, c));
    return buffer.channels() == 1 ? text : '(' + text + ')';
}

// Which pixels show a surface; all elements of what has no pixels.
std::vector<bool> drawnIn(const pipeline::Frame& frame, const AnyBuffer& buffer) {
    const std::size_t count = buffer.rows() * buffer.columns();
    if (buffer.info->domain != Domain::Pixel) return std::vector<bool>(count, true);
    const auto seen = frame.buffer({BufferId::PolygonId});
    std::vector<bool> drawn(count, true);
    for (std::size_t i = 0; seen && i < count; ++i) drawn[i] = seen->flat(i) >= 0;
    return drawn;
}

bool isUnit(BufferId id) {
    using enum BufferId;
    return id == PolygonsNormal || id == VerticesNormal || id == Normal || id == ViewVector || id == LightVector ||
           id == ReflectionVector || id == HalfwayVector;
}

// "Lengths: 0.83 to 1, mean 0.95." and its like.
std::string rangeText(const AnyBuffer& buffer, const std::vector<bool>& drawn) {
    const bool lengths = isUnit(buffer.info->id);
    const auto channels = std::size_t(buffer.channels());
    double low = std::numeric_limits<double>::infinity(), high = -low, sum = 0;
    std::size_t count = 0, infinite = 0;
    const auto take = [&](double value) {
        if (std::isinf(value)) ++infinite;
        if (!std::isfinite(value)) return;
        low = std::min(low, value), high = std::max(high, value);
        sum += value, ++count;
    };
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (!drawn[i]) continue;
        double square = 0;
        for (std::size_t c = 0; c < channels; ++c) {
            const double value = buffer.flat(i * channels + c);
            square += value * value;
            if (!lengths) take(value);
        }
        if (lengths && square > 0) take(std::sqrt(square));  // (0, 0, 0) stands for none
    }
    const std::string infinities = infinite > 0 ? fmt::format("; {} infinite", infinite) : std::string();
    if (count == 0) return infinite > 0 ? "No finite value" + infinities + ".\n" : "Nothing is drawn.\n";
    return fmt::format("{}: {} to {}, mean {}{}.\n", lengths ? "Lengths" : "Values", numberText(low), numberText(high),
                       numberText(sum / double(count)), infinities);
}

// What must hold of the buffer, and of how many of its elements it does.
std::string contractsOf(const pipeline::Frame& frame, const pipeline::BufferName& name) {
    const pipeline::ContractInput input = pipeline::contractInput(frame);
    std::string text;
    for (const pipeline::Contract& contract : pipeline::contractTable()) {
        if (*contract.reads.begin() != name.id) continue;
        const pipeline::ContractResult result =
            checkContract(contract, input, contract.perLight() ? std::max(0, name.light) : -1);
        if (!result.why.empty() || result.checked == 0) continue;
        text += fmt::format("{} It holds for {} of {}", contract.claim, result.hold, result.checked);
        text += result.holds() ? ".\n" : fmt::format("; worst: {}.\n", contractWorst(result, input));
    }
    return text;
}

std::string verdictCounts(const AnyBuffer& buffer) {
    std::array<std::size_t, pipeline::kVerdictCount> counts{};
    for (std::size_t i = 0; i < buffer.rows(); ++i) ++counts[std::size_t(buffer.value(0, i))];
    std::string text;
    for (std::size_t code = 0; code < counts.size(); ++code)
        if (counts[code] > 0)
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts[code],
                                name(static_cast<pipeline::Verdict>(code)));
    return text + ".\n";
}

std::string rowsText(const AnyBuffer& buffer) {
    std::string text;
    const std::string_view what = buffer.info->domain == Domain::Polygon ? "polygon" : "vertex";
    for (std::size_t row = 0; row < std::min(buffer.rows(), kMostRows); ++row)
        text += fmt::format("  {} {}: {}\n", what, row, valueText(buffer, 0, row));
    if (buffer.rows() > kMostRows) text += fmt::format("  and {} more\n", buffer.rows() - kMostRows);
    return text;
}

// Pixels on a grid of 5 by 4, where something is drawn.
std::string pixelsText(const AnyBuffer& buffer, const std::vector<bool>& drawn) {
    std::size_t left = buffer.columns(), right = 0, top = buffer.rows(), bottom = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (!drawn[i]) continue;
        const std::size_t x = i % buffer.columns(), y = i / buffer.columns();
        left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
    }
    if (left > right) return {};
    std::string text = fmt::format("Drawn are columns {} to {}, rows {} to {}.\n", left, right, top, bottom);
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t i = 0; i < 5; ++i) {
            const std::size_t x = left + (right - left) * (2 * i + 1) / 10, y = top + (bottom - top) * (2 * j + 1) / 8;
            if (drawn[y * buffer.columns() + x]) text += fmt::format("  {}, {}: {}\n", x, y, valueText(buffer, x, y));
        }
    return text;
}

}  // namespace

std::string lookText(const pipeline::Frame& frame, const pipeline::BufferName& name) {
    const auto buffer = frame.buffer(name);
    if (!buffer) return name.text() + ": " + frame.whyAbsent(name) + '\n';
    const std::string unit = buffer->info->unit.empty() ? "" : fmt::format(" In {}.", buffer->info->unit);
    std::string text = fmt::format("{}: {}{}\n", name.text(), buffer->info->meaning, unit);
    const std::vector<bool> drawn = drawnIn(frame, *buffer);
    text += buffer->info->palette == pipeline::Palette::Verdict ? verdictCounts(*buffer) : rangeText(*buffer, drawn);
    text += contractsOf(frame, name);
    if (buffer->info->domain == Domain::Pixel) return text + pixelsText(*buffer, drawn);
    return buffer->info->domain == Domain::Texel ? text : text + rowsText(*buffer);
}

std::string lookText(const pipeline::Frame& frame, glm::ivec2 pixel) {
    pipeline::PixelReport report = inspectPixel(frame, pixel);
    for (pipeline::Evaluation& evaluation : report.evaluations)
        for (pipeline::LightReport& light : evaluation.lights) light.note.clear();
    return toText(frame, report);
}

}  // namespace lessons
