#include "lessons/grading/sheet_blanks.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/export/folder/file_hash.h"

namespace lessons {

namespace {

constexpr std::string_view kCell = "<td class=number>", kCellEnd = "</td>";
constexpr std::string_view kEquation = "<div class=equation>", kEquationEnd = "</div>";

struct Hole {
    std::size_t begin, end;  // of what is left blank, in the page
};

bool isNumberPart(char c) { return (c >= '0' && c <= '9') || c == '.'; }

// One cell of each row with numbers, by turns of `seed`.
void addCells(std::string_view page, std::size_t begin, std::size_t end, std::uint64_t seed, std::vector<Hole>& holes) {
    for (std::size_t row = page.find("<tr>", begin); row < end; row = page.find("<tr>", row + 1)) {
        const std::size_t rowEnd = page.find("</tr>", row);
        std::vector<Hole> cells;
        for (std::size_t at = page.find(kCell, row); at < rowEnd; at = page.find(kCell, at + 1)) {
            const std::size_t from = at + kCell.size();
            cells.push_back({from, page.find(kCellEnd, from)});
        }
        if (!cells.empty()) holes.push_back(cells[(seed >> (8 * (holes.size() % 8)) & 0xFF) % cells.size()]);
    }
}

// The result at the end of a line of an equation, where the equation has it nowhere else.
void addResults(std::string_view page, std::size_t begin, std::size_t end, std::vector<Hole>& holes) {
    for (std::size_t block = page.find(kEquation, begin); block < end; block = page.find(kEquation, block + 1)) {
        const std::size_t blockEnd = page.find(kEquationEnd, block);
        const std::string_view whole = page.substr(block, blockEnd - block);
        for (std::size_t line = page.find("<p", block); line < blockEnd; line = page.find("<p", line + 1)) {
            const std::size_t lineEnd = page.find("</p>", line), sign = page.rfind("= ", lineEnd);
            if (sign == page.npos || sign < line) continue;
            const std::size_t from = sign + 2;
            std::size_t to = from;
            while (to < lineEnd && isNumberPart(page[to])) ++to;
            if (to == from || to != lineEnd) continue;
            const std::string_view number = page.substr(from, to - from);
            const std::size_t first = whole.find(number);
            if (whole.find(number, first + 1) == whole.npos) holes.push_back({from, to});
        }
    }
}

// The answers without their last line, which names the pages.
std::string_view withoutLastLine(std::string_view answers) {
    const std::size_t at = answers.rfind("<!-- Answers");
    return answers.substr(0, at);
}

}  // namespace

Sheets::Pages blanked(const Handout& handout, std::size_t count, std::uint64_t seed) {
    const std::string_view page = handout.pages;
    std::vector<Hole> holes;
    std::size_t begin = page.find("<section>");
    while (begin != page.npos && count > 0) {
        const std::size_t end = std::min(page.find("</section>", begin), page.size());
        std::vector<Hole> found;
        addCells(page, begin, end, seed, found);
        addResults(page, begin, end, found);
        // Spread over the page.
        const std::size_t taken = std::min(count, found.size());
        const std::size_t shift = found.empty() ? 0 : seed % found.size();
        for (std::size_t i = 0; i < taken; ++i)
            holes.push_back(found[(i * found.size() / taken + shift) % found.size()]);
        begin = page.find("<section>", end);
    }
    std::ranges::sort(holes, {}, &Hole::begin);
    std::string sheet, key;
    std::size_t at = 0;
    for (std::size_t i = 0; i < holes.size(); ++i) {
        sheet += page.substr(at, holes[i].begin - at);
        sheet += fmt::format("<span class=gap><b>{}</b>&nbsp;</span>", i + 1);
        key += fmt::format("<li>{}</li>\n", page.substr(holes[i].begin, holes[i].end - holes[i].begin));
        at = holes[i].end;
    }
    sheet += page.substr(at);
    std::string answers(withoutLastLine(handout.answers));
    if (!key.empty()) {
        const std::size_t end = answers.find("<footer>");
        answers.insert(std::min(end, answers.size()),
                       "<section>\n<h2>Blanks</h2>\n<ol class=gaps>\n" + key + "</ol>\n</section>\n");
    }
    answers +=
        fmt::format("<!-- Answers to a sheet of {} bytes, SHA-256 {} -->\n", sheet.size(), pipeline::sha256Of(sheet));
    return {std::move(sheet), std::move(answers)};
}

}  // namespace lessons
