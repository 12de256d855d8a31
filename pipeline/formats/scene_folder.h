#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "pipeline/core/result.h"
#include "pipeline/formats/read_progress.h"

namespace pipeline {

inline constexpr std::size_t kMaxFileBytes = std::size_t{256} << 20;  // one file
inline constexpr std::size_t kMaxSceneBytes = std::size_t{1} << 30;   // all files that a scene names

// A text in memory, with the name that it has in messages.
struct SourceText {
    std::string_view text;
    std::string name;
    ReadProgress progress = {};
};

// A file that a scene names, or why there is none; the error's place is left to the caller,
// who knows where the name stands. `path` is the file's name for messages.
struct NamedFile {
    std::string text;
    std::string path;
};
using FileLoader = std::function<Result<NamedFile>(std::string_view name)>;

// The whole file. Folders, devices, and more than `limit` bytes are refused.
Result<std::string> readFile(const std::filesystem::path& file, std::size_t limit = kMaxFileBytes);
// Its first bytes, at most `count`, under the same rules.
Result<std::string> readStart(const std::filesystem::path& file, std::size_t count);

// Loads files of the folder that `scene` stands in, or of folders below it. A name that leads
// out of the folder, be it by "..", by an absolute path or by a symbolic link, is refused.
FileLoader filesBeside(const std::filesystem::path& scene);

}  // namespace pipeline
