#pragma once
#include "pipeline/export/buffers/exporter.h"

namespace pipeline {

// NumPy's array file, version 1.0: a header of 64-byte multiples, then the numbers,
// little-endian, C order.
std::uint64_t npySize(const AnyBuffer& buffer);
Result<std::uint64_t> writeNpy(const ExportItem& item, const std::filesystem::path& file);

inline constexpr Exporter kNpyExporter{
    "npy",   "The numbers as they are, for NumPy: version 1.0, little-endian, C order.", false, holdsAll, npySize, true,
    writeNpy};

}  // namespace pipeline
