#include "app/cli/arguments/error_argument.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/cli/arguments/frame_argument.h"
#include "pipeline/core/text.h"
#include "pipeline/study/analysis.h"
#include "pipeline/study/errors.h"

namespace app {

namespace {

std::string textOf(const pipeline::ErrorChoice& choice) {
    return fmt::format("{}:{}:{}", choice.buffer, choice.measure, name(choice.kind));
}

// Each on a line of its own, the first as well.
std::string listed(const std::vector<pipeline::ErrorChoice>& choices) {
    std::string text;
    for (const pipeline::ErrorChoice& one : choices) text += "\n  " + textOf(one);
    return text;
}

}  // namespace

std::optional<pipeline::ErrorChoice> parseChoice(const std::string& text) {
    const auto first = text.find(':'), last = text.rfind(':');
    if (first == text.npos) return std::nullopt;
    pipeline::ErrorChoice choice{text.substr(0, first), {}, pipeline::ErrorKind::Model};
    choice.measure = text.substr(first + 1, last == first ? text.npos : last - first - 1);
    if (last == first) return choice;
    for (std::size_t kind = 0; kind < pipeline::kErrorKinds; ++kind) {
        choice.kind = static_cast<pipeline::ErrorKind>(kind);
        if (name(choice.kind) == std::string_view(text).substr(last + 1)) return choice;
    }
    return std::nullopt;
}

std::string whyNoError(const pipeline::Scene& scene, const pipeline::ErrorChoice& choice) {
    const auto buffer = bufferNamed(scene, choice.buffer);
    if (!buffer) return buffer.errors().front().found;
    const std::vector<pipeline::ErrorChoice> known = knownErrors(*buffer);
    if (std::ranges::find(known, choice) != known.end()) return {};
    if (known.empty()) return fmt::format("no error of {} is measured", choice.buffer);
    return fmt::format("no {} error {} of {} is measured; there are{}", name(choice.kind),
                       pipeline::inQuotes(choice.measure), choice.buffer, listed(known));
}

std::string chooseError(const pipeline::StudyRequest& request, pipeline::StudyReport& report) {
    const std::vector<pipeline::ErrorChoice> there = choicesOf(report);
    if (there.empty() || std::ranges::find(there, report.choice) != there.end()) return {};
    if (request.choice)
        return fmt::format("--error {}: no point has this error; there are{}",
                           pipeline::inQuotes(textOf(*request.choice)), listed(there));
    const auto same = std::ranges::find_if(there, [&](const pipeline::ErrorChoice& one) {
        return one.buffer == report.choice.buffer && one.measure == report.choice.measure;
    });
    report.choice = same == there.end() ? there.front() : *same;
    return {};
}

}  // namespace app
