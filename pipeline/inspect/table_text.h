#pragma once
#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/inspect/scene_tables.h"

namespace pipeline {

// How a cell reads: with the column's decimals and a true minus sign; "–" where there is none.
std::string readableText(const TableColumn& column, const Cell& cell);
// The shortest text that reads back as the same number, plain ASCII; empty where there is none.
std::string exactText(const Cell& cell);

// Text: facts, aligned columns, and what each column means. Csv: RFC 4180 with LF at the ends of lines, exact numbers.
// Markdown and Latex: a table for a page; LaTeX as a tabular, in words of plain LaTeX. NumPy: an expression in Python, a
// structured array with a field a column, exact numbers, NaN where there is none.
enum class TableFormat : std::uint8_t { Text, Csv, Markdown, Latex, NumPy };
inline constexpr std::array<std::string_view, 5> kTableFormats{"text", "csv", "markdown", "latex", "numpy"};

// Gives the text to `sink` in pieces: a table of a million rows is never one string.
using TextSink = std::function<void(std::string_view)>;
void writeTable(const SceneTable& table, std::span<const std::uint32_t> rows, TableFormat format, const TextSink& sink);
std::vector<std::uint32_t> allRows(const SceneTable& table);

}  // namespace pipeline
