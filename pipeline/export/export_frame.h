#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/export/json/json_value.h"
#include "pipeline/run/frame.h"

namespace pipeline {

struct ExportRequest {
    std::filesystem::path folder;
    std::vector<BufferName> buffers;                 // empty: all that the frame holds; derived ones always
    std::vector<std::string> formats{"npy", "png"};  // names of exporterTable(), frameExporterTable()
    // Writes more files into the folder it is given, for the same export: pictures of the 3D
    // views. Gives their names. May be empty.
    std::function<Result<std::vector<std::filesystem::path>>(const std::filesystem::path& folder)> writeMore;
    std::string state{};  // what the window shows, as TOML, for pictures that carry their scene; may be empty
    // Made of the frame beside its own buffers; `buffers` may name them.
    struct Derived {
        AnyBuffer buffer;
        std::string meaning;  // one sentence
    };
    std::vector<Derived> derived{};
    bool replacesAny = true;  // also files in the folder that the program did not write (whyNotReplaced())
    std::string at{};         // where inside a stage the frame stands, as a Place is written; for the manifest
};

// One file of a buffer, or the reason there is none.
struct PlannedFile {
    BufferName buffer;
    std::string format;
    std::string file;         // "depth.npy"; empty where there is none
    std::uint64_t bytes = 0;  // before it is written
    bool exact = false;       // bytes is certain
    std::string whyNot;       // "A picture has pixels, not vertices."
};

inline constexpr const char* kManifest = "manifest.json";
// What an export of the scene writes beside its buffers: the files of formats that hold a whole frame; the manifest last.
std::vector<std::string> wholeFiles(const Scene& scene, const std::vector<std::string>& formats);

// What an export would write of its buffers, in the order in which it would.
std::vector<PlannedFile> plannedFiles(const Frame& frame, const ExportRequest& request);

struct ExportSummary {
    bool cancelled = false;              // nothing was written
    std::vector<std::string> files;      // names in the folder, manifest.json last
    std::vector<std::string> removed{};  // of the export that was there before, and are not among them
    std::uint64_t bytes = 0;
    std::string inDoubt{};  // why the files of the export before were not those of its manifest; it was replaced then
};

// Called before each file with the share that is done, 0 to 1; false cancels.
using ExportProgress = std::function<bool(double share, std::string_view file)>;

// Writes more files, counts their bytes and gives their names; may be empty.
using WriteViews = std::function<Result<std::vector<std::string>>(std::uint64_t& bytes)>;

// The files of an export but for its manifest, written into a folder that is there; and the manifest, which lacks
// "contents" still.
struct ExportFiles {
    bool cancelled = false;
    std::vector<std::string> names;
    std::uint64_t bytes = 0;
    Json manifest;
};
Result<ExportFiles> writeExportFiles(const Frame& frame, const ExportRequest& request,
                                     const std::filesystem::path& folder, const ExportProgress& progress = {},
                                     const WriteViews& writeViews = {});

// Writes the buffers of a frame and manifest.json: all of them, or nothing. To an export of the same frame that is in the
// folder already they are added; one of another frame, or whose files are not as its manifest has them, is
// replaced: all files that its manifest names go. Other files stay.
// Errors: what could not be written, and why.
Result<ExportSummary> exportFrame(const Frame& frame, const ExportRequest& request,
                                  const ExportProgress& progress = {});

}  // namespace pipeline
