#pragma once
#include "pipeline/export/buffers/exporter.h"

namespace pipeline {

// One line of names, then one line per pixel (column, row), texel, vertex or polygon, each number with
// the fewest digits that read back as the same number; nan, inf and -inf as words.
std::uint64_t csvEstimate(const AnyBuffer& buffer);
Result<std::uint64_t> writeCsv(const ExportItem& item, const std::filesystem::path& file);

inline constexpr Exporter kCsvExporter{
    "csv", "A table: one line a pixel, vertex or polygon.", false, holdsAll, csvEstimate, false, writeCsv};

}  // namespace pipeline
