#include "pipeline/formats/scene_folder.h"

#include <algorithm>
#include <fstream>
#include <memory>

#include "pipeline/formats/text_scanner.h"

namespace pipeline {
namespace {

namespace fs = std::filesystem;

Error noPlace(std::string found, std::string expected = {}) { return {{}, std::move(found), std::move(expected)}; }

// Reads up to `count` bytes. The size that the file system reports is a guess: a file may grow, and some have none.
Result<std::string> readBytes(const fs::path& file, std::size_t count) {
    std::error_code ignored;  // a file that cannot be looked at is not a regular one
    const fs::file_status status = fs::status(file, ignored);
    if (status.type() == fs::file_type::not_found) return noPlace("no such file");
    if (fs::is_directory(status)) return noPlace("this is a folder", "a file");
    if (!fs::is_regular_file(status)) return noPlace("this is not a regular file", "a file");

    std::ifstream stream(file, std::ios::binary);
    std::string text;
    const std::uintmax_t size = fs::file_size(file, ignored);
    if (!ignored) text.reserve(static_cast<std::size_t>(std::min<std::uintmax_t>(size, count)) + 1);
    while (stream && text.size() < count) {
        const std::size_t before = text.size();
        const std::size_t step =
            std::min(count - before, std::max({before, text.capacity() - before, std::size_t{64 * 1024}}));
        text.resize(before + step);
        stream.read(text.data() + before, static_cast<std::streamsize>(step));
        text.resize(before + static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad() || !stream.is_open()) return noPlace("the file cannot be read");
    return text;
}

// Whether all components of `folder` begin `path`; "/a/bc" is not below "/a/b".
bool isBelow(const fs::path& path, const fs::path& folder) {
    const auto [inFolder, inPath] = std::ranges::mismatch(folder, path);
    return inFolder == folder.end();
}

Result<fs::path> resolve(const fs::path& folder, std::string_view name) {
    if (!isPrintable(name)) return noPlace("found " + quotedInput(name), "a file name without control characters");
    const Error outside = noPlace(quotedInput(name) + " leaves the scene's folder; put the file beside the scene");
    if (fs::path(name).is_absolute()) return outside;
    std::error_code failed;
    const fs::path from = fs::weakly_canonical(folder, failed);
    const fs::path to = failed ? fs::path() : fs::weakly_canonical(from / name, failed);
    if (failed) return noPlace(quotedInput(name) + " cannot be read");
    if (!isBelow(to, from)) return outside;
    return to;
}

}  // namespace

Result<std::string> readFile(const fs::path& file, std::size_t limit) {
    Result<std::string> text = readBytes(file, limit + 1);
    if (text && text->size() > limit)
        return noPlace("the file is larger than " + groupedDigits(limit) + " bytes", "a smaller file");
    return text;
}

Result<std::string> readStart(const fs::path& file, std::size_t count) { return readBytes(file, count); }

FileLoader filesBeside(const fs::path& scene) {
    const fs::path shown = scene.parent_path();
    const fs::path folder = shown.empty() ? fs::path(".") : shown;
    return [shown, folder, left = kMaxSceneBytes](std::string_view name) mutable -> Result<NamedFile> {
        const Result<fs::path> path = resolve(folder, name);
        if (!path) return path.errors();
        Result<std::string> text = readFile(*path, std::min(left, kMaxFileBytes));
        if (!text) {
            Error error = text.errors().front();
            error.found = quotedInput(name) + ": " + error.found;
            return error;
        }
        left -= text->size();
        return NamedFile{std::move(text).value(), (shown / name).string()};
    };
}

}  // namespace pipeline
