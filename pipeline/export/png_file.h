#pragma once
#include <string>

#include "pipeline/buffers/buffer2d.h"
#include "pipeline/export/exporter.h"

namespace pipeline {

// 8-bit sRGB. The frame buffer as it is; other buffers through their palette, whose name and
// range stand in text chunks. Unbounded values as palette.h says.
std::uint64_t pngEstimate(const AnyBuffer& buffer);
Result<std::uint64_t> writePng(const ExportItem& item, const std::filesystem::path& file);

// A picture in sRGB as the bytes of a PNG file; empty where it is too large for the format.
std::string pngOf(const Buffer2D<Color8>& picture);

// "ember", "slope", "eight", "verdict", "direction", "color".
std::string_view paletteName(Palette palette);

}  // namespace pipeline
