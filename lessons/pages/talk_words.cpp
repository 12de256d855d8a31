#include "lessons/pages/talk_words.h"

#include <algorithm>
#include <regex>

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

std::vector<SetPiece> setPieces(const std::string& sentence) {
    // A letter and what is below it, or a bracket and what is raised behind it.
    static const std::regex s_symbols("\\b([IkSc])_([a-z0-9]{1,3})\\b|(\\))\\^([a-z0-9]{1,2})\\b");
    using Script = SetPiece::Script;
    std::vector<SetPiece> pieces;
    auto rest = sentence.cbegin();
    for (std::sregex_iterator found(sentence.begin(), sentence.end(), s_symbols), end; found != end; ++found) {
        const std::smatch& match = *found;
        const bool isBelow = match[1].matched;
        pieces.push_back({std::string(rest, match[0].first) + match[isBelow ? 1 : 3].str(), Script::None});
        pieces.push_back({match[isBelow ? 2 : 4].str(), isBelow ? Script::Below : Script::Raised});
        rest = match[0].second;
    }
    if (rest != sentence.cend()) pieces.push_back({std::string(rest, sentence.cend()), Script::None});
    return pieces;
}

}  // namespace lessons
