#include "pipeline/inspect/table_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "pipeline/core/csv.h"
#include "pipeline/core/text.h"
#include "pipeline/inspect/formula_parts.h"

namespace pipeline {
namespace {

bool isNumber(const Cell& cell) { return cell.index() >= 1 && cell.index() <= 3; }

// Characters, not bytes.
std::size_t width(std::string_view text) {
    return std::size_t(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t to, bool right) {
    const std::string blank(to - std::min(to, width(text)), ' ');
    return right ? blank + text : text + blank;
}

// Letters that would end a cell or start a style; a line break ends the row.
std::string markdownField(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '|' || c == '\\' || c == '`' || c == '*' || c == '_' || c == '<' || c == '[') out += '\\';
        out += c == '\n' || c == '\r' ? ' ' : c;
    }
    return out;
}

std::string latexField(std::string text) {
    constexpr std::pair<std::string_view, std::string_view> kWords[]{
        {"−", "$-$"},       {"–", "--"},      {"α", "$\\alpha$"}, {"ρ", "$\\rho$"},
        {"θ", "$\\theta$"}, {"φ", "$\\phi$"}, {"²", "$^2$"},      {"∞", "$\\infty$"}};
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const std::string_view rest = std::string_view(text).substr(i);
        const auto word = std::ranges::find_if(kWords, [&](const auto& w) { return rest.starts_with(w.first); });
        if (word != std::end(kWords)) {
            out += word->second;
            i += word->first.size();
            continue;
        }
        const char c = text[i++];
        if (c == '\\')
            out += "\\textbackslash{}";
        else if (c == '~' || c == '^')
            out += fmt::format("\\{}{{}}", c);
        else if (std::string_view("{}_#$%&").find(c) != std::string_view::npos)
            out += fmt::format("\\{}", c);
        else
            out += c == '\n' || c == '\r' ? ' ' : c;
    }
    return out;
}

struct Layout {
    bool right;  // numbers stand at the right
    std::size_t width;
};

// Of a page's table the first rows decide; nobody sets a million.
constexpr std::size_t kRowsOfPage = 1000;
std::span<const std::uint32_t> firstRows(std::span<const std::uint32_t> rows) {
    return rows.first(std::min(rows.size(), kRowsOfPage));
}

std::vector<Layout> layoutOf(const SceneTable& table, std::span<const std::uint32_t> rows) {
    std::vector<Layout> layout;
    for (const TableColumn& column : table.columns) {
        Layout l{false, width(column.heading())};
        for (const std::uint32_t row : rows) {
            const Cell cell = column.cell(row);
            l.right = l.right || isNumber(cell);
            l.width = std::max(l.width, width(readableText(column, cell)));
        }
        layout.push_back(l);
    }
    return layout;
}

void writeText(const SceneTable& table, std::span<const std::uint32_t> rows, const TextSink& sink) {
    sink(table.meaning + "\n\n");
    for (const TableFact& fact : table.facts) {
        const std::string value = readableText({}, fact.value);
        sink(fmt::format("{} = {}{}{}{}\n", fact.heading(), value, fact.unit.empty() ? "" : " ", fact.unit,
                         fact.lecture.empty() ? "" : fmt::format("   ({})", fact.name)));
    }
    sink("\n");
    const std::vector<Layout> layout = layoutOf(table, rows);
    const auto line = [&](const auto& textOf) {
        std::string text;
        for (std::size_t c = 0; c < layout.size(); ++c)
            text.append(c > 0 ? "  " : "").append(padded(textOf(c), layout[c].width, layout[c].right));
        text.erase(text.find_last_not_of(' ') + 1);
        sink(text.append("\n"));
    };
    line([&](std::size_t c) { return table.columns[c].heading(); });
    for (const std::uint32_t row : rows)
        line([&](std::size_t c) { return readableText(table.columns[c], table.columns[c].cell(row)); });
    std::size_t heads = 0;
    for (const TableColumn& column : table.columns) heads = std::max(heads, width(column.heading()));
    sink("\n");
    for (const TableColumn& column : table.columns) {
        std::string also = column.heading() == column.name ? std::string() : column.name;
        if (!column.unit.empty()) also += (also.empty() ? "" : "; ") + column.unit;
        if (!also.empty()) also = fmt::format(" ({})", also);
        if (!column.whyEmpty.empty()) also += fmt::format(" Empty: {}", column.whyEmpty);
        sink(fmt::format("{}  {}{}\n", padded(column.heading(), heads, false), column.meaning, also));
    }
}

void writeCsv(const SceneTable& table, std::span<const std::uint32_t> rows, const TextSink& sink) {
    const auto line = [&](const auto& textOf) {
        std::string text;
        for (std::size_t c = 0; c < table.columns.size(); ++c)
            text.append(c > 0 ? "," : "").append(csvField(textOf(c)));
        sink(text.append("\n"));
    };
    line([&](std::size_t c) { return table.columns[c].heading(); });
    for (const std::uint32_t row : rows) line([&](std::size_t c) { return exactText(table.columns[c].cell(row)); });
}

void writeMarkdown(const SceneTable& table, std::span<const std::uint32_t> rows, const TextSink& sink) {
    const auto line = [&](const auto& textOf) {
        std::string text = "|";
        for (std::size_t c = 0; c < table.columns.size(); ++c) text.append(" ").append(textOf(c)).append(" |");
        sink(text.append("\n"));
    };
    const std::vector<Layout> layout = layoutOf(table, firstRows(rows));
    line([&](std::size_t c) { return markdownField(table.columns[c].heading()); });
    line([&](std::size_t c) { return std::string(layout[c].right ? "---:" : "---"); });
    for (const std::uint32_t row : rows)
        line([&](std::size_t c) { return markdownField(readableText(table.columns[c], table.columns[c].cell(row))); });
}

void writeLatex(const SceneTable& table, std::span<const std::uint32_t> rows, const TextSink& sink) {
    const auto line = [&](const auto& textOf) {
        std::string text;
        for (std::size_t c = 0; c < table.columns.size(); ++c)
            text.append(c > 0 ? " & " : "").append(latexField(textOf(c)));
        sink(text.append(" \\\\\n"));
    };
    std::string places;
    for (const Layout& l : layoutOf(table, firstRows(rows))) places += l.right ? 'r' : 'l';
    sink(fmt::format("\\begin{{tabular}}{{{}}}\n\\hline\n", places));
    line([&](std::size_t c) { return table.columns[c].heading(); });
    sink("\\hline\n");
    for (const std::uint32_t row : rows)
        line([&](std::size_t c) { return readableText(table.columns[c], table.columns[c].cell(row)); });
    sink("\\hline\n\\end{tabular}\n");
}

std::string pythonString(const std::string& text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') out += '\\';
        out += c == '\n' || c == '\r' ? ' ' : c;
    }
    return out + '\'';
}

std::string pythonNumber(const Cell& cell) {
    const auto* single = std::get_if<float>(&cell);
    const auto* real = std::get_if<double>(&cell);
    const double value = single ? double(*single) : real ? *real : 0;
    if (std::holds_alternative<std::monostate>(cell) || std::isnan(value)) return "np.nan";
    if (std::isinf(value)) return value > 0 ? "np.inf" : "-np.inf";
    return exactText(cell);
}

// A column of whole numbers that misses one has to hold NaN: a double.
std::string dtypeOf(const TableColumn& column, std::span<const std::uint32_t> rows) {
    bool isText = false, isDouble = false, isFloat = false, isMissing = false;
    std::size_t letters = 1;
    for (const std::uint32_t row : rows) {
        const Cell cell = column.cell(row);
        if (const auto* words = std::get_if<std::string>(&cell))
            isText = true, letters = std::max(letters, width(*words));
        isDouble |= std::holds_alternative<double>(cell);
        isFloat |= std::holds_alternative<float>(cell);
        isMissing |= std::holds_alternative<std::monostate>(cell);
    }
    if (isText) return fmt::format("U{}", letters);
    return isFloat && !isDouble ? "f4" : isDouble || isMissing ? "f8" : "i8";
}

void writeNumPy(const SceneTable& table, std::span<const std::uint32_t> rows, const TextSink& sink) {
    std::vector<std::string> types, fields;
    for (const TableColumn& column : table.columns) {
        types.push_back(dtypeOf(column, rows));
        fields.push_back(fmt::format("({}, '{}')", pythonString(column.heading()), types.back()));
    }
    sink("np.array([");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::string text = i > 0 ? ",\n          (" : "(";
        for (std::size_t c = 0; c < types.size(); ++c) {
            const Cell cell = table.columns[c].cell(rows[i]);
            text += types[c][0] == 'U' ? pythonString(exactText(cell)) : pythonNumber(cell);
            text += types.size() == 1 ? "," : c + 1 < types.size() ? ", " : "";
        }
        sink(text + ')');
    }
    sink(fmt::format("],\n         dtype=[{}])\n", fmt::join(fields, ", ")));
}

}  // namespace

std::string readableText(const TableColumn& column, const Cell& cell) {
    if (std::holds_alternative<std::monostate>(cell)) return "–";
    if (const auto* words = std::get_if<std::string>(&cell)) return *words;
    if (const auto* whole = std::get_if<std::int64_t>(&cell)) return withMinus(std::to_string(*whole));
    if (column.decimals < 0) return withMinus(exactText(cell));
    const auto* real = std::get_if<float>(&cell);
    return fixed(real ? double(*real) : std::get<double>(cell), column.decimals);
}

std::string exactText(const Cell& cell) {
    if (const auto* words = std::get_if<std::string>(&cell)) return *words;
    if (const auto* whole = std::get_if<std::int64_t>(&cell)) return std::to_string(*whole);
    if (const auto* real = std::get_if<double>(&cell)) return shortestText(*real);
    if (const auto* real = std::get_if<float>(&cell)) {
        // A float's own digits: as a double it would get those of its rounding, too.
        if (*real == std::trunc(*real)) return shortestText(*real);
        std::array<char, 32> digits;
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), *real).ptr;
        return std::string(digits.data(), end);
    }
    return {};
}

void writeTable(const SceneTable& table, std::span<const std::uint32_t> rows, TableFormat format,
                const TextSink& sink) {
    switch (format) {
        case TableFormat::Text: return writeText(table, rows, sink);
        case TableFormat::Csv: return writeCsv(table, rows, sink);
        case TableFormat::Markdown: return writeMarkdown(table, rows, sink);
        case TableFormat::Latex: return writeLatex(table, rows, sink);
        case TableFormat::NumPy: return writeNumPy(table, rows, sink);
    }
}

std::vector<std::uint32_t> allRows(const SceneTable& table) {
    std::vector<std::uint32_t> rows(table.rows);
    std::iota(rows.begin(), rows.end(), 0u);
    return rows;
}

}  // namespace pipeline
