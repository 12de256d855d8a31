#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <istream>
#include <memory>
#include <string>
#include <string_view>

#include "pipeline/core/result.h"
#include "pipeline/formats/text/read_progress.h"

namespace pipeline {

inline constexpr std::size_t kMaxFileBytes = std::size_t{256} << 20;  // one file that is in memory as a whole
inline constexpr std::size_t kFileStart = std::size_t{64} << 10;      // what tells a format, and a model begins with
inline constexpr std::size_t kMaxSceneBytes = std::size_t{1} << 30;   // all of these that a scene names

// What follows the beginning of a file, read piece by piece.
class FileTail {
public:
    static constexpr std::size_t kPiece = std::size_t{1} << 20;  // bytes

    // size: how many bytes there should be; the file may have grown or shrunk meanwhile.
    FileTail(std::unique_ptr<std::istream> stream, std::size_t size, std::size_t piece = kPiece)
        : m_stream(std::move(stream)), m_size(size), m_piece(piece) {}
    std::size_t size() const { return m_size; }
    std::size_t piece() const { return m_piece; }
    // Appends up to `count` bytes; false where these are the last.
    bool read(std::string& to, std::size_t count);

private:
    std::unique_ptr<std::istream> m_stream;
    std::size_t m_size, m_piece;
};

// A text in memory, with the name that it has in messages. Of a model `text` may be the beginning, and `tail` the rest;
// `called` is what a scene that names it calls it, from the scene's folder, empty where none does.
struct SourceText {
    std::string_view text;
    std::string name;
    ReadProgress progress = {};
    std::shared_ptr<FileTail> tail = nullptr;
    std::string called = {};
};

// A file that a scene names, or why there is none; the error's place is left to the caller,
// who knows where the name stands. `path` is the file's name for messages.
struct NamedFile {
    std::string text;
    std::string path;
    std::shared_ptr<FileTail> tail = nullptr;  // of a model, as in SourceText
    std::string otherName = {};                // what it is called where that differs from what was asked for
};
using FileLoader = std::function<Result<NamedFile>(std::string_view name)>;

// The whole file. Folders, devices, and more than `limit` bytes are refused.
Result<std::string> readFile(const std::filesystem::path& file, std::size_t limit = kMaxFileBytes);
// Its first bytes, at most `count`, under the same rules.
Result<std::string> readStart(const std::filesystem::path& file, std::size_t count);
// Its first bytes, and the rest where it is larger: for what is read piece by piece, of any size. Text in UTF-16 is given
// in UTF-8.
Result<NamedFile> openFile(const std::filesystem::path& file);

// The whole text of a source, of at most kMaxFileBytes.
Result<std::string> wholeText(const SourceText& source);

// Where a file stands that `owner` ("scene") names, in its folder or below. A name that leads out of the folder, be it by
// "..", by an absolute path or by a symbolic link, is refused.
Result<std::filesystem::path> pathInFolder(const std::filesystem::path& folder, std::string_view name,
                                           std::string_view owner);

// Loads files of the folder that `scene` stands in, or of folders below it; models as openFile does. Names are
// looked up as pathInFolder does. Where there is no file of that name, but one whose letters are of another case, that is
// loaded.
FileLoader filesBeside(const std::filesystem::path& scene);

}  // namespace pipeline
