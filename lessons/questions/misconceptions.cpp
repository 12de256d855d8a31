#include "lessons/questions/misconceptions.h"

#include <algorithm>

#include "lessons/lesson_text.h"
#include "lessons/library.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/key_places.h"

namespace lessons {

namespace {

constexpr std::size_t kMaxTableBytes = std::size_t{1} << 18, kColumns = 5;

Misconceptions readTable() {
    const std::filesystem::path file = lessonFolder() / "misconceptions.md";
    const auto text = pipeline::readFile(file, kMaxTableBytes);
    if (!text) return {{}, pipeline::namedAt({file.string()}, text.errors())};
    return parseMisconceptions(*text, file.string());
}

}  // namespace

// A Markdown table: a row is a line between bars, the first two are its head.
Misconceptions parseMisconceptions(std::string_view text, const std::string& file) {
    Misconceptions table;
    int bars = 0;
    for (const Line& line : linesOf(text, file)) {
        if (!line.text.starts_with('|') || ++bars <= 2) continue;
        const std::vector<Line> cells = separated(line, "|");  // one empty at each end
        if (cells.size() != kColumns + 2 || cells[1].text.empty() || cells[2].text.empty()) {
            table.errors.push_back(
                {line.where, "found a row that is not one", "| id | name | stage | defect | source |"});
            continue;
        }
        const auto cell = [&](std::size_t i) { return std::string(cells[i].text); };
        if (std::ranges::find(table.rows, cell(1), &Misconception::id) != table.rows.end())
            table.errors.push_back({line.where, "found the id \"" + cell(1) + "\" a second time", "another id"});
        table.rows.push_back({cell(1), cell(2), cell(3), cell(4), cell(5)});
    }
    return table;
}

const Misconceptions& misconceptions() {
    static const Misconceptions table = readTable();
    return table;
}

const Misconception* findMisconception(std::string_view id) {
    const auto& rows = misconceptions().rows;
    const auto found = std::ranges::find(rows, id, &Misconception::id);
    return found == rows.end() ? nullptr : &*found;
}

}  // namespace lessons
