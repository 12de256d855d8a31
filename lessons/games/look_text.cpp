#include "lessons/games/look_text.h"

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

std::vector<std::string> channelNames(const pipeline::BufferInfo& info) {
    if (info.channels == 1) return {};
    if (info.id == pipeline::BufferId::Barycentric) return {"λ0", "λ1", "λ2"};
    if (info.palette == pipeline::Palette::Color) return {"r", "g", "b"};
    return {"x", "y", "z"};
}

namespace {

using pipeline::AnyBuffer;
using pipeline::BufferId;
using pipeline::Domain;

constexpr std::size_t kMostRows = 12;

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

using Table = std::vector<std::vector<std::string>>;  // the first row: the columns' names

std::size_t lettersIn(const std::string& text) {
    return std::size_t(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

// In columns, as for a font whose letters have one width.
std::string tableText(const Table& table) {
    std::vector<std::size_t> widths(table[0].size());
    for (const auto& row : table)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], lettersIn(row[i]));
    std::string text;
    for (const auto& row : table) {
        for (std::size_t i = 0; i < row.size(); ++i)
            text += std::string(widths[i] - lettersIn(row[i]) + (i == 0 ? 0 : 2), ' ') + row[i];
        text += '\n';
    }
    return text;
}

// The columns' names of a buffer's values: of its channels, else its own.
std::vector<std::string> headOf(std::vector<std::string> head, const AnyBuffer& buffer,
                                const pipeline::BufferName& name) {
    const auto channels = channelNames(*buffer.info);
    if (channels.empty()) head.push_back(name.text());
    head.insert(head.end(), channels.begin(), channels.end());
    return head;
}

void addValues(std::vector<std::string>& row, const AnyBuffer& buffer, std::size_t x, std::size_t y) {
    if (buffer.info->palette == pipeline::Palette::Verdict)
        return row.emplace_back(name(static_cast<pipeline::Verdict>(buffer.value(x, y)))), void();
    for (int c = 0; c < buffer.channels(); ++c) row.push_back(numberText(buffer.value(x, y, c)));
}

std::string rowsText(const AnyBuffer& buffer, const pipeline::BufferName& name) {
    Table table{headOf({buffer.info->domain == Domain::Polygon ? "polygon" : "vertex"}, buffer, name)};
    for (std::size_t row = 0; row < std::min(buffer.rows(), kMostRows); ++row)
        addValues(table.emplace_back(1, std::to_string(row)), buffer, 0, row);
    std::string text = '\n' + tableText(table);
    if (buffer.rows() > kMostRows) text += fmt::format("and {} more\n", buffer.rows() - kMostRows);
    return text;
}

// Pixels on a grid of 5 by 4, where something is drawn.
std::string pixelsText(const AnyBuffer& buffer, const std::vector<bool>& drawn, const pipeline::BufferName& name) {
    std::size_t left = buffer.columns(), right = 0, top = buffer.rows(), bottom = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (!drawn[i]) continue;
        const std::size_t x = i % buffer.columns(), y = i / buffer.columns();
        left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
    }
    if (left > right) return {};
    Table table{headOf({"column", "row"}, buffer, name)};
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t i = 0; i < 5; ++i) {
            const std::size_t x = left + (right - left) * (2 * i + 1) / 10, y = top + (bottom - top) * (2 * j + 1) / 8;
            if (!drawn[y * buffer.columns() + x]) continue;
            addValues(table.emplace_back(std::vector{std::to_string(x), std::to_string(y)}), buffer, x, y);
        }
    return fmt::format("Drawn are columns {} to {}, rows {} to {}.\n\n", left, right, top, bottom) + tableText(table);
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
    if (buffer->info->domain == Domain::Pixel) return text + pixelsText(*buffer, drawn, name);
    return buffer->info->domain == Domain::Texel ? text : text + rowsText(*buffer, name);
}

std::string lookText(const pipeline::Frame& frame, glm::ivec2 pixel) {
    pipeline::PixelReport report = inspectPixel(frame, pixel);
    for (pipeline::Evaluation& evaluation : report.evaluations)
        for (pipeline::LightReport& light : evaluation.lights) light.note.clear();
    return toText(frame, report);
}

}  // namespace lessons
