#pragma once
#include <span>
#include <string>
#include <vector>

#include "pipeline/buffers/buffer2d.h"
#include "pipeline/export/buffers/exporter.h"
#include "pipeline/formats/png_scene.h"

namespace pipeline {

// 8-bit sRGB. The frame buffer as it is; other buffers through their palette, whose name and range stand in text chunks,
// as does the scene where the item has it. Unbounded values as palette.h says.
std::uint64_t pngEstimate(const AnyBuffer& buffer);
Result<std::uint64_t> writePng(const ExportItem& item, const std::filesystem::path& file);

// Small is for files. Fast takes a fifth of the time for four tenths more bytes: for pictures that are looked at once.
enum class Packing : std::uint8_t { Small, Fast };
// A picture in sRGB as the bytes of a PNG file; empty where it is too large for the format.
std::string pngOf(const Buffer2D<Color8>& picture, Packing packing = Packing::Small);

// The same with transparency: rgba row by row, 4 bytes a pixel, not premultiplied. texts: in UTF-8, packed.
struct PngText {
    std::string key, text;
};
std::string pngOf(std::span<const std::uint8_t> rgba, glm::ivec2 size, const std::vector<PngText>& texts);

// "ember", "slope", "eight", "verdict", "shadow verdict", "truth", "direction", "color".
std::string_view paletteName(Palette palette);

}  // namespace pipeline
