#include "lessons/talk_words.h"

#include <algorithm>

namespace lessons {

std::vector<pipeline::EquationLine> shortEquation(std::vector<pipeline::EquationLine> lines) {
    constexpr std::size_t kMost = 4;
    std::vector<pipeline::EquationLine> shown;
    for (pipeline::EquationLine& line : lines) {
        const bool isLast = line.role == "frame buffer";
        const bool isWanted = isLast || line.role == "symbols" || line.role == "numbers" || line.role == "result";
        if (!isWanted || (!isLast && shown.size() == kMost)) continue;
        line.remark.clear();
        if (isLast && !shown.empty() && shown.back().role == "symbols") shown.pop_back();
        shown.push_back(std::move(line));
        if (isLast) break;
    }
    return shown;
}

std::pair<std::size_t, std::size_t> rowsAround(const std::vector<pipeline::AlgorithmRow>& rows, std::size_t most) {
    if (most == 0 || rows.size() <= most) return {0, rows.size()};
    const auto now = std::ranges::find(rows, pipeline::LineStatus::Now, &pipeline::AlgorithmRow::status);
    const auto at = now == rows.end() ? 0 : std::size_t(now - rows.begin());
    const std::size_t first = std::min(at > most / 2 ? at - most / 2 : 0, rows.size() - most);
    return {first, first + most};
}

}  // namespace lessons
