#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/inspect/pixel_report.h"

namespace pipeline {

// How the lines of an equation are written out.
//   Text      a line each, as `inspect` prints them
//   Markdown  one block between $$, aligned at the equals signs
//   Latex     an align* of the packages amsmath and cancel, which a comment names
enum class EquationFormat : std::uint8_t { Text, Markdown, Latex };
inline constexpr std::array<std::string_view, 3> kEquationFormats{"text", "markdown", "latex"};

// Ends with a line break; empty for no lines.
std::string equationText(std::span<const EquationLine> lines, EquationFormat format);

}  // namespace pipeline
