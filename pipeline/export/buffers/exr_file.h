#pragma once
#include "pipeline/export/buffers/exporter.h"

namespace pipeline {

// OpenEXR, 32-bit float, scan lines from the top. Channels: R G B of colours, X Y Z of vectors,
// Z of distances, Y of other single numbers. The six faces of a point light one below the other.
std::uint64_t exrEstimate(const AnyBuffer& buffer);
Result<std::uint64_t> writeExr(const ExportItem& item, const std::filesystem::path& file);

// A scan-line or tiled file of one part with the channels that writeExr gives `like`, half, float or whole
// numbers, as a buffer of that kind; its size may be another one. A file without them is an error that names
// those that it has.
Result<AnyBuffer> readExr(const std::filesystem::path& file, const AnyBuffer& like);

}  // namespace pipeline
