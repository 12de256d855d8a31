#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/core/number.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/numbers/number_file.h"

namespace pipeline {

namespace {

std::string_view trimmed(std::string_view word) {
    constexpr std::string_view kSpace = " \t\r\"";
    const auto first = word.find_first_not_of(kSpace);
    if (first == word.npos) return {};
    return word.substr(first, word.find_last_not_of(kSpace) - first + 1);
}

// The fields of a line one by one: a line of separators alone takes no memory.
class Fields {
public:
    explicit Fields(std::string_view line)
        : m_left(line),
          m_separator(line.find(',') != line.npos   ? ','
                      : line.find(';') != line.npos ? ';'
                                                    : '\t') {}
    std::size_t count() const { return std::size_t(std::ranges::count(m_left, m_separator)) + 1; }
    const char* place() const { return m_left.data(); }  // of the next one
    std::string_view next() {
        const auto end = std::min(m_left.find(m_separator), m_left.size());
        const std::string_view field = trimmed(m_left.substr(0, end));
        m_left.remove_prefix(std::min(end + 1, m_left.size()));
        return field;
    }

private:
    std::string_view m_left;
    char m_separator;
};

// "-0.5", "+2", "nan", "inf", "True".
std::optional<double> csvNumber(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    if (sameLetters(word, "true")) return 1;
    if (sameLetters(word, "false")) return 0;
    return readNumber(word);
}

// How many of the first columns give the place of a row's numbers.
std::size_t placeColumns(Fields heading, std::size_t columns) {
    constexpr std::array<std::string_view, 6> kPlaces{"row", "column", "vertex", "polygon", "index", "id"};
    std::size_t places = 0;
    while (places < columns && places < 2 &&
           std::ranges::any_of(kPlaces, [field = heading.next()](auto name) { return sameLetters(name, field); }))
        ++places;
    return places < columns ? places : 0;
}

}  // namespace

Result<NumberFile> readCsvNumbers(std::string_view bytes, const std::string& name, std::size_t most) {
    NumberFile file{name, {0, 0}, {}};
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    std::size_t places = 0, columns = 0, height = 0, width = 0;
    bool whole = true;
    int number = 0;
    while (!bytes.empty()) {
        ++number;
        const auto end = std::min(bytes.find('\n'), bytes.size());
        const std::string_view line = trimmed(bytes.substr(0, end));
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
        if (line.empty() || line[0] == '#') continue;
        Fields fields(line);
        const std::size_t count = fields.count();
        if (columns == 0) {
            columns = count;
            if (!csvNumber(Fields(line).next())) {
                places = placeColumns(fields, columns);
                continue;
            }
        }
        if (count != columns)
            return Error{{name, number, 1},
                         fmt::format("{} numbers in a line", count),
                         fmt::format("{}, as in the lines before", columns)};
        if (file.values.size() + columns > most)
            return Error{{name, number, 1}, "more numbers", fmt::format("at most {}", most)};
        for (std::size_t i = 0; i < columns; ++i) {
            const char* const place = fields.place();
            const std::string_view field = fields.next();
            const auto value = csvNumber(field);
            if (!value)
                return Error{{name, number, int((field.empty() ? place : field.data()) - line.data()) + 1},
                             "found " + inQuotes(field),
                             "a number"};
            if (i < places && places == 2) {
                std::size_t& side = i == 0 ? width : height;
                if (*value >= 0 && *value < 65536) side = std::max(side, std::size_t(*value) + 1);
            }
            if (i < places) continue;
            whole = whole && *value == std::floor(*value);
            file.values.push_back(*value);
        }
    }
    const std::size_t channels = columns - places;
    const std::size_t lines = channels == 0 ? 0 : file.values.size() / channels;
    if (lines == 0) return Error{{name, number, 0}, "no numbers", "lines of numbers with commas between them"};
    // Row by row with both places: a picture, if no line is missing.
    file.shape = {lines};
    if (places == 2 && width * height == lines) file.shape = {height, width};
    if (channels > 1) file.shape.push_back(channels);
    file.kind = whole ? NumberKind::Whole : NumberKind::Real;
    return file;
}

}  // namespace pipeline
