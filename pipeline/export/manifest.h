#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/export/buffers/exporter.h"
#include "pipeline/export/json/json.h"

namespace pipeline {

// A file that an export has written.
struct WrittenFile {
    std::string file;  // in the export's folder
    const Exporter* exporter;
    std::uint64_t bytes;
};

struct WrittenBuffer {
    ExportItem item;
    std::vector<WrittenFile> files;
    std::string meaning{};  // of a derived buffer
};

// A file of the whole frame.
struct WrittenScene {
    std::string file;  // in the export's folder
    const FrameExporter* exporter;
    std::uint64_t bytes;
};

// The text of manifest.json: which program made this of what, with which settings and plan,
// and what each file holds; its "contents" (pipeline/export/folder/contents.h) and "contracts" are for the caller to add. `asked` are the
// buffers that were to be exported.
Json manifest(const Frame& frame, const std::vector<BufferName>& asked, const std::vector<WrittenBuffer>& buffers,
              const std::vector<WrittenScene>& whole, const std::vector<std::string>& views, const std::string& at);

// The names of the files that such a text says are beside it; none where it is not one of this program's. A name that
// leads out of its folder is left out: anybody may have written the text.
std::vector<std::string> filesNamedBy(const Json& manifest);

// Whether a file of this name may be one that an export has written: what else a manifest names is not the program's.
bool isWritten(std::string_view name);

// Whether both are of the same program, scene, settings and place in the run, whose hash stands in "frame": their
// buffers are of the same numbers. b: made by manifest().
bool areOfOneFrame(const Json& a, const Json& b);

// Adds to a manifest what an earlier one of the same frame says of files that stay beside the new ones.
void addEarlier(const Json& earlier, const std::vector<std::string>& staying, Json& manifest);

}  // namespace pipeline
