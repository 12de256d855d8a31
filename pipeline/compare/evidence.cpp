#include "pipeline/compare/evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "pipeline/compare/handed_in/reading_cost.h"
#include "pipeline/core/text.h"

namespace pipeline::foreign {

namespace {

constexpr double kDrawn = 0.005;    // of the reference's pixels: who draws fewer draws nothing
constexpr double kOneDepth = 1e-5;  // of a depth: what depths differ by that are one
constexpr double kFits = 2;         // tolerances: see readingCost
constexpr double kCloser = 3;       // times

// The finite numbers but for the extreme that is there most often: what a z-buffer is cleared to.
struct Range {
    double low = HUGE_VAL, high = -HUGE_VAL;
    void add(double v) { low = std::min(low, v), high = std::max(high, v); }
    bool isOne() const { return high - low <= kOneDepth * std::max(std::abs(low), std::abs(high)); }
};
Range drawnDepths(const std::vector<double>& numbers) {
    Range whole, drawn;
    for (const double v : numbers)
        if (std::isfinite(v)) whole.add(v);
    const auto cleared =
        std::ranges::count(numbers, whole.low) > std::ranges::count(numbers, whole.high) ? whole.low : whole.high;
    for (const double v : numbers)
        if (std::isfinite(v) && v != cleared) drawn.add(v);
    return drawn.low <= drawn.high ? drawn : whole;
}

bool isOneNumber(const std::vector<double>& numbers) {
    return std::ranges::all_of(
        numbers, [&](double v) { return v == numbers.front() || (!std::isfinite(v) && !std::isfinite(numbers[0])); });
}

// The colours of a picture, row by row.
struct Colors {
    std::size_t kinds = 0;   // at most kMostKinds
    std::size_t others = 0;  // pixels of another colour than the commonest
};
constexpr std::size_t kMostKinds = 3;  // more than the background and one other
Colors colorsOf(const std::vector<double>& numbers, std::size_t channels) {
    std::map<std::vector<double>, std::size_t> colors;
    std::vector<double> color(channels);
    std::size_t* last = nullptr;  // the count of the pixel before: most pixels have its colour
    std::size_t most = 0;
    for (std::size_t i = 0; i + channels <= numbers.size(); i += channels) {
        bool isLast = last != nullptr;
        for (std::size_t c = 0; c < channels; ++c) {
            const double v = std::isfinite(numbers[i + c]) ? numbers[i + c] : 0;
            isLast = isLast && v == color[c];
            color[c] = v;
        }
        if (!isLast) last = &colors[color];
        most = std::max(most, ++*last);
    }
    return {std::min(colors.size(), kMostKinds), numbers.size() / channels - most};
}

double leastCost(const HandedFile& file, const Reference& right) {
    const std::string name = file.name.buffer.text();
    const Values& values = right.values.at(name);
    double least = std::numeric_limits<double>::infinity();
    for (const Reading& reading : readingsOf(file, right.context))
        least = std::min(least, readingCost(file, read(file, reading, right.context, values), values, right.context,
                                            right.tolerances.at(name)));
    return least;
}

bool fitsTransposed(const HandedFile& file, const Reference& right) {
    const NumberFile& numbers = file.numbers;
    if (numbers.rows() != numbers.columns() || bufferInfo(file.name.buffer.id).domain != Domain::Pixel) return false;
    HandedFile turned = file;
    const std::size_t side = numbers.rows(), channels = numbers.channels();
    for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x)
            for (std::size_t c = 0; c < channels; ++c)
                turned.numbers.values[(x * side + y) * channels + c] = numbers.values[(y * side + x) * channels + c];
    const double cost = leastCost(turned, right);
    return cost <= kFits && cost * kCloser < leastCost(file, right);
}

}  // namespace

Evidence weigh(HandedIn& in, const Reference& right) {
    Evidence out;
    std::size_t covered = 0;
    for (const std::uint8_t here : right.context.covered) covered += here;
    std::vector<HandedFile> kept, empty;
    for (HandedFile& file : in.files) {
        const BufferId id = file.name.buffer.id;
        const bool isPicture = bufferInfo(id).domain == Domain::Pixel && !file.numbers.values.empty();
        const std::string name = inQuotes(file.fileName());
        std::string why;
        if (isPicture && fitsTransposed(file, right)) {
            in.errors.push_back(
                {{file.path}, "the picture fits with rows and columns exchanged", "rows before columns: transpose it"});
            continue;
        }
        const Colors colors = id == BufferId::Color ? colorsOf(file.numbers.values, file.numbers.channels()) : Colors();
        if (id == BufferId::Color && double(colors.others) < kDrawn * double(covered))
            out.isEmpty = true, why = name + " has one colour everywhere";
        else if (id == BufferId::Color && colors.kinds < kMostKinds &&
                 colorsOf(right.values.at(file.name.buffer.text()).numbers, 3).kinds == kMostKinds)
            out.isEmpty = out.isOneColored = true, why = name + " has one colour wherever it draws";
        else if (id == BufferId::ZView && drawnDepths(file.numbers.values).isOne())
            why = name + " holds one depth everywhere";
        else if (isPicture && id != BufferId::Color && isOneNumber(file.numbers.values) &&
                 !isOneNumber(right.values.at(file.name.buffer.text()).numbers))
            why = name + " holds one number everywhere";
        if (!why.empty()) out.words.push_back(why);
        (why.empty() ? kept : empty).push_back(std::move(file));
    }
    const auto color =
        std::ranges::find_if(empty, [](const HandedFile& file) { return file.name.buffer.id == BufferId::Color; });
    if (color != empty.end()) kept.push_back(std::move(*color)), empty.erase(color);
    if (kept.empty())
        std::swap(kept, empty);
    else if (!empty.empty())
        for (std::string& words : out.words)
            if (std::ranges::any_of(
                    empty, [&](const HandedFile& file) { return words.starts_with(inQuotes(file.fileName())); }))
                words += ": it is left out";
    std::ranges::stable_sort(kept, {}, [](const HandedFile& file) { return index(file.name.buffer.id); });
    in.files = std::move(kept);
    return out;
}

}  // namespace pipeline::foreign
