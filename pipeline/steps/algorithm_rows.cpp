// The lines of an algorithm at a moment, and its text output.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "pipeline/inspect/formula.h"
#include "pipeline/steps/algorithm.h"

namespace pipeline {
namespace {

// The parts of a line's text inside and outside braces.
template <class Plain, class Named>
void eachPart(std::string_view text, Plain plain, Named named) {
    while (!text.empty()) {
        const std::size_t open = std::min(text.find('{'), text.size());
        if (open > 0) plain(text.substr(0, open));
        text.remove_prefix(open);
        if (text.empty()) return;
        const std::size_t close = text.find('}');
        named(text.substr(1, close - 1));
        text.remove_prefix(close + 1);
    }
}

// What the comparison in a line's text says of the numbers: "{z'} > {Z'[x'][y']} + {bias}", "{A} < 0". Nothing where
// there is none, or where the numbers are equal: stages that round may then decide either way.
std::optional<bool> compared(std::string_view text, const std::vector<AlgorithmValue>& values) {
    const std::size_t sign = text.find_first_of("<>");
    if (sign == text.npos || values.empty() || values.front().numbers.size() != 1) return {};
    double right = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (values[i].numbers.size() != 1) return {};
        right += values[i].numbers.front();
    }
    if (values.size() == 1 && !text.substr(sign + 1).starts_with(" 0")) return {};
    const double left = values.front().numbers.front();
    if (!(left < right) && !(left > right)) return {};
    return text[sign] == '<' ? left < right : left > right;
}

// A planted defect has decided against the numbers.
bool isError(const AlgorithmLine& line, const AlgorithmRow& row) {
    if (!row.taken) return false;
    const auto right = compared(line.text, row.values);
    return right && *right != *row.taken;
}

// For an If the text from its first value to its last, because the signs around them belong to the language; otherwise
// the values alone.
std::string valuesText(const AlgorithmLine& line, const std::vector<AlgorithmValue>& values, bool named, bool isError) {
    const auto written = [&](const AlgorithmValue& value) {
        return named ? value.shown + " = " + value.text : value.text;
    };
    std::string out;
    if (values.empty()) return out;
    if (line.kind != LineKind::If) {
        for (const AlgorithmValue& value : values) out += (out.empty() ? "" : "; ") + written(value);
        return out;
    }
    const std::size_t first = line.text.find('{'), last = std::max(line.text.rfind('}'), line.text.find(" 0") + 1);
    if (first == std::string_view::npos) return out;
    eachPart(
        line.text.substr(first, last + 1 - first), [&](std::string_view plain) { out += plain; },
        [&](std::string_view name) {
            const auto value = std::ranges::find(values, name, &AlgorithmValue::name);
            out += value == values.end() ? std::string(name) : written(*value);
        });
    if (!isError) return out;
    // The comparison that was made.
    char& sign = out[out.find_first_of("<>")];
    sign = sign == '<' ? '>' : '<';
    return out + " (the error)";
}

// The last visit of a line up to the state's own visit; null if there is none.
const Visit* lastVisitOf(const AlgorithmState& state, std::size_t line) {
    if (!state.visit) return nullptr;
    for (std::size_t i = *state.visit + 1; i-- > 0;)
        if (state.walk.visits[i].line == line) return &state.walk.visits[i];
    const auto around = std::ranges::find(state.walk.around, line, &Visit::line);
    return around == state.walk.around.end() ? nullptr : &*around;
}

bool isNotTaken(const AlgorithmState& state, std::size_t line) {
    const std::vector<Algorithm::Line>& lines = state.walk.algorithm.lines;
    int indent = lines[line].indent;
    for (std::size_t i = line; i-- > 0;) {
        if (lines[i].indent >= indent) continue;
        indent = lines[i].indent;
        const Visit* const last = lastVisitOf(state, i);
        if (last && last->taken == false) return true;
    }
    return false;
}

LineStatus statusOf(const AlgorithmState& state, std::size_t i) {
    const Algorithm::Line& line = state.walk.algorithm.lines[i];
    if (!line.leftOut.empty()) return LineStatus::LeftOut;
    if (line.row->kind == LineKind::Elsewhere) return LineStatus::Elsewhere;
    if (!state.visit) return LineStatus::Ahead;
    const std::vector<Visit>& visits = state.walk.visits;
    if (visits[*state.visit].line == i) return LineStatus::Now;
    if (isNotTaken(state, i)) return LineStatus::NotTaken;
    if (*state.visit + 1 < visits.size() && visits[*state.visit + 1].line == i) return LineStatus::Next;
    return lastVisitOf(state, i) ? LineStatus::Passed : LineStatus::Ahead;
}

std::string remarkOf(const AlgorithmState& state, const AlgorithmRow& row, const AlgorithmLine& line) {
    if (row.status == LineStatus::LeftOut) return "left out";
    if (row.status == LineStatus::Elsewhere) return std::string(line.of);
    if (row.status == LineStatus::Next) return "next";
    if (row.taken)
        return isError(line, row) ? (*row.taken ? "taken" : "not taken")
               : *row.taken       ? "true, taken"
                                  : "false, not taken";
    return row.status == LineStatus::Now && state.over ? "done" : "";
}

std::string lineNumbers(const std::vector<int>& numbers) {
    std::vector<std::string> runs;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
        runs.push_back(end - i == 1
                           ? std::to_string(numbers[i])
                           : fmt::format("{}{}{}", numbers[i], end - i == 2 ? " and " : " to ", numbers[end - 1]));
        i = end;
    }
    const std::string last = runs.back();
    runs.pop_back();
    const std::string all = runs.empty() ? last : fmt::format("{} and {}", fmt::join(runs, ", "), last);
    return numbers.size() == 1 ? fmt::format("Line {} is", all) : fmt::format("Lines {} are", all);
}

}  // namespace

std::vector<std::string> AlgorithmState::leftOut() const {
    std::vector<std::pair<std::string, std::vector<int>>> reasons;
    for (std::size_t i = 0; i < walk.algorithm.lines.size(); ++i) {
        const std::string& why = walk.algorithm.lines[i].leftOut;
        if (why.empty()) continue;
        auto reason = std::ranges::find(reasons, why, &decltype(reasons)::value_type::first);
        if (reason == reasons.end()) reason = reasons.insert(reasons.end(), {why, {}});
        reason->second.push_back(int(i) + 1);
    }
    std::vector<std::string> sentences;
    for (const auto& [why, numbers] : reasons)
        sentences.push_back(fmt::format("{} left out. {}", lineNumbers(numbers), why));
    return sentences;
}

std::vector<AlgorithmRow> rowsOf(const AlgorithmState& state) {
    std::vector<AlgorithmRow> rows;
    for (std::size_t i = 0; i < state.walk.algorithm.lines.size(); ++i) {
        const Algorithm::Line& line = state.walk.algorithm.lines[i];
        AlgorithmRow row{int(i) + 1, line.text, line.indent, statusOf(state, i), {}, {}, {}, {}, {}};
        if (const Visit* const last = lastVisitOf(state, i); last && row.status != LineStatus::NotTaken)
            row.values = last->values, row.taken = last->taken;
        row.valuesText = valuesText(*line.row, row.values, false, isError(*line.row, row));
        row.named = valuesText(*line.row, row.values, true, isError(*line.row, row));
        row.remark = remarkOf(state, row, *line.row);
        rows.push_back(std::move(row));
    }
    return rows;
}

const AlgorithmValue* innermostLoop(const std::vector<AlgorithmRow>& rows) {
    const AlgorithmValue* inner = nullptr;
    for (const AlgorithmRow& row : rows) {
        for (const AlgorithmValue& value : row.values)
            if (value.range) inner = &value;
        if (row.status == LineStatus::Now) break;
    }
    return inner;
}

namespace {

std::size_t lettersOf(std::string_view text) {
    return std::size_t(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string behind(const AlgorithmRow& row) {
    return row.named.empty() || row.remark.empty() ? row.named + row.remark : row.named + ": " + row.remark;
}

std::string plainText(const AlgorithmState& state) {
    const std::vector<AlgorithmRow> rows = rowsOf(state);
    std::size_t width = 0;
    for (const AlgorithmRow& row : rows) width = std::max(width, lettersOf(row.text) + 2 * std::size_t(row.indent));
    std::string out = fmt::format("{}\n\n", state.walk.algorithm.row->title);
    for (const AlgorithmRow& row : rows) {
        std::string line = fmt::format("{} {:>2}  {}{}", row.status == LineStatus::Now ? '>' : ' ', row.number,
                                       std::string(2 * std::size_t(row.indent), ' '), row.text);
        if (const std::string values = behind(row); !values.empty())
            line += std::string(width + 3 - lettersOf(row.text) - 2 * std::size_t(row.indent), ' ') + values;
        out += line + '\n';
    }
    const auto say = [&out](std::string_view sentence) { out.append("\n").append(sentence).append("\n"); };
    for (const std::string& sentence : state.leftOut()) say(sentence);
    if (!state.walk.algorithm.row->note.empty()) say(state.walk.algorithm.row->note);
    return out;
}

std::string latexText(const AlgorithmState& state) {
    std::string out = fmt::format("% {}\n\\begin{{tabular}}{{rll}}\n", state.walk.algorithm.row->title);
    for (const AlgorithmRow& row : rowsOf(state)) {
        const std::string code = fmt::format("\\hspace*{{{}em}}\\texttt{{{}}}", row.indent, latexWords(row.text));
        out += fmt::format("{} & {} & {} \\\\\n", row.number,
                           row.status == LineStatus::Now ? "\\fbox{" + code + "}" : code, latexWords(behind(row)));
    }
    return out + "\\end{tabular}\n";
}

}  // namespace

std::string algorithmText(const AlgorithmState& state, AlgorithmFormat format) {
    return format == AlgorithmFormat::Text ? plainText(state) : latexText(state);
}

}  // namespace pipeline
