#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/buffers/palette.h"
#include "pipeline/core/result.h"
#include "pipeline/run/frame.h"

namespace pipeline {

// A buffer on its way to a file.
struct ExportItem {
    AnyBuffer buffer;
    BufferStatistics found;
    PaletteRange range;                          // what a picture of it maps to the palette's ends
    std::shared_ptr<const std::string> scene{};  // as TOML, for files that carry it; null: none does
    std::shared_ptr<const std::string> state{};  // likewise, what the window shows
};

// A file format. A new one is its pair of files and a row in exporter_table.cpp.
struct Exporter {
    std::string_view name;     // "npy": for --format, and the file's ending
    std::string_view meaning;  // one sentence
    bool usesPalette;          // the file shows colours; the range that they stand for goes with it
    // Why the format cannot hold such a buffer, or empty.
    std::string_view (*refuses)(const BufferInfo& info);
    // The size of the file in bytes before it is written; exact only where `sizeIsExact`.
    std::uint64_t (*estimate)(const AnyBuffer& buffer);
    bool sizeIsExact;
    // Writes a whole file; gives its size in bytes, or why it could not. A file that could not be
    // finished stays for the caller to remove.
    Result<std::uint64_t> (*write)(const ExportItem& item, const std::filesystem::path& file);
};

// Those that the program has; the core of the page has fewer.
std::span<const Exporter> exporterTable();
const Exporter* findExporter(std::string_view name);  // null where there is none
std::string_view holdsAll(const BufferInfo& info);    // refuses nothing

// A format whose one file holds a whole frame, not one buffer.
struct FrameExporter {
    std::string_view name;     // "opengl": for --format
    std::string_view meaning;  // one sentence
    std::string_view ending;   // ".gl.c", after the scene's name
    // Why the format cannot hold a frame of such a scene, or empty.
    std::string (*refuses)(const Scene& scene);
    // As Exporter::write.
    Result<std::uint64_t> (*write)(const Frame& frame, const std::filesystem::path& file);
};

std::string anyScene(const Scene& scene);  // refuses nothing
Result<std::uint64_t> writeSceneFile(const Frame& frame, const std::filesystem::path& file);
inline constexpr FrameExporter kSceneExporter{"scene", "The scene and its settings as TOML, which opens again.",
                                              ".toml", anyScene, writeSceneFile};

std::span<const FrameExporter> frameExporterTable();
const FrameExporter* findFrameExporter(std::string_view name);  // null where there is none
// "pyramid.gl.c" of the scene "pyramid.scene"; a title that no file can have as its name is cut.
std::string sceneFileName(const std::string& scene, const FrameExporter& exporter);

// "could not write: no space left on device", at `file`; reason from errno.
Error writeError(const std::filesystem::path& file, int errorNumber);

}  // namespace pipeline
