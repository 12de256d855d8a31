#include "pipeline/formats/scene_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <set>

#include "pipeline/core/text.h"
#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/text/inputs.h"
#include "pipeline/formats/text/text_scanner.h"
#include "pipeline/formats/text/utf16.h"

namespace pipeline {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxEntries = 100'000;  // of folders, looked at for a name in another case

Error noPlace(std::string found, std::string expected = {}) { return {{}, std::move(found), std::move(expected)}; }

Error tooLarge(std::size_t limit) {
    return noPlace("the file is larger than " + groupedDigits(limit) + " bytes", "a smaller file");
}

// The inputs by their paths without links: what replaces a file by another name leaves the file.
struct Inputs {
    std::mutex mutex;
    std::optional<std::set<fs::path>> paths;  // none: nothing is remembered
};
Inputs& inputs() {
    static Inputs all;
    return all;
}
void remember(const fs::path& file) {
    const std::scoped_lock lock(inputs().mutex);
    std::error_code ignored;
    if (inputs().paths) inputs().paths->insert(fs::weakly_canonical(file, ignored));
}

struct OpenFile {
    std::ifstream stream;
    std::size_t size = 0;  // what the file system reports, a guess: a file may grow, and some have none
};
Result<OpenFile> open(const fs::path& file) {
    std::error_code ignored;  // a file that cannot be looked at is not a regular one
    const fs::file_status status = fs::status(file, ignored);
    if (status.type() == fs::file_type::not_found) return noPlace("no such file");
    if (fs::is_directory(status)) return noPlace("this is a folder", "a file");
    if (!fs::is_regular_file(status)) return noPlace("this is not a regular file", "a file");

    errno = 0;
    OpenFile opened{std::ifstream(file, std::ios::binary)};
    if (!opened.stream.is_open() && errno == ENOMEM) throw std::bad_alloc();
    if (!opened.stream.is_open()) return noPlace("the file cannot be read");
    const std::uintmax_t size = fs::file_size(file, ignored);
    if (!ignored) opened.size = static_cast<std::size_t>(size);
    return opened;
}

// Appends up to `count` bytes.
void append(std::istream& stream, std::size_t count, std::string& text) {
    const std::size_t end = text.size() + count;
    while (stream && text.size() < end) {
        const std::size_t before = text.size();
        const std::size_t step =
            std::min(end - before, std::max({before, text.capacity() - before, std::size_t{64} << 10}));
        text.resize(before + step);
        stream.read(text.data() + before, static_cast<std::streamsize>(step));
        text.resize(before + static_cast<std::size_t>(stream.gcount()));
    }
}

// Its first bytes, at most `count`; the stream stands after them.
Result<std::string> readFrom(OpenFile& file, std::size_t count) {
    std::string text;
    text.reserve(std::min(file.size, count) + 1);
    append(file.stream, count, text);
    if (file.stream.bad()) return noPlace("the file cannot be read");
    return text;
}
Result<std::string> readBytes(const fs::path& file, std::size_t count) {
    Result<OpenFile> opened = open(file);
    if (!opened) return opened.errors();
    OpenFile from = std::move(opened).value();
    return readFrom(from, count);
}
Result<std::string> readWhole(const fs::path& file, std::size_t limit) {
    Result<std::string> text = readBytes(file, limit + 1);
    if (text && text->size() > limit) return tooLarge(limit);
    return text;
}

// Whether all components of `folder` begin `path`; "/a/bc" is not below "/a/b".
bool isBelow(const fs::path& path, const fs::path& folder) {
    const auto [inFolder, inPath] = std::ranges::mismatch(folder, path);
    return inFolder == folder.end();
}

// The path below `folder` whose components are those of `name` but for the case of A to Z; the first in alphabetical order.
// left: how many entries of folders may still be looked at.
std::optional<fs::path> inOtherCase(const fs::path& folder, const fs::path& name, std::size_t& left) {
    fs::path found;
    for (const fs::path& component : name) {
        if (component == "." || component.empty()) continue;
        if (component == "..") return {};
        std::error_code failed;
        if (fs::exists(folder / found / component, failed)) {
            found /= component;
            continue;
        }
        fs::path best;
        for (fs::directory_iterator entry(folder / found, failed), end; !failed && entry != end && left > 0;
             entry.increment(failed), --left) {
            const fs::path there = entry->path().filename();
            if (sameLetters(there.string(), component.string()) && (best.empty() || there < best)) best = there;
        }
        if (best.empty()) return {};
        found /= best;
    }
    return found;
}

}  // namespace

Result<fs::path> pathInFolder(const fs::path& folder, std::string_view name, std::string_view owner) {
    if (!isPrintable(name)) return noPlace("found " + quotedInput(name), "a file name without control characters");
    const Error outside =
        noPlace(fmt::format("{} leaves the {}'s folder; put the file beside the {}", quotedInput(name), owner, owner));
    if (fs::path(name).is_absolute()) return outside;
    std::error_code failed;
    const fs::path from = fs::weakly_canonical(folder, failed);
    const fs::path to = failed ? fs::path() : fs::weakly_canonical(from / name, failed);
    if (failed == std::errc::not_enough_memory) throw std::bad_alloc();
    if (failed) return noPlace(quotedInput(name) + " cannot be read");
    if (!isBelow(to, from)) return outside;
    return to;
}

Result<std::string> readFile(const fs::path& file, std::size_t limit) {
    remember(file);
    return readWhole(file, limit);
}
Result<std::string> readOwnFile(const fs::path& file, std::size_t limit) { return readWhole(file, limit); }

Result<std::string> wholeText(const SourceText& source) {
    std::string text(source.text);
    // Piece by piece, for a slow disk's sake: reading may be stopped.
    while (source.tail && text.size() <= kMaxFileBytes && !source.progress.stop.stop_requested())
        if (!source.tail->read(text, std::min(FileTail::kPiece, kMaxFileBytes + 1 - text.size()))) break;
    if (text.size() > kMaxFileBytes) return tooLarge(kMaxFileBytes);
    return text;
}

Result<std::string> readStart(const fs::path& file, std::size_t count) { return readBytes(file, count); }

Result<NamedFile> openFile(const fs::path& file) {
    remember(file);
    Result<OpenFile> opened = open(file);
    if (!opened) return opened.errors();
    OpenFile from = std::move(opened).value();
    Result<std::string> start = readFrom(from, kFileStart);
    if (!start) return start.errors();
    NamedFile out{std::move(start).value(), file.string()};
    if (isUtf16(out.text)) {
        from.stream.clear();
        from.stream.seekg(0);
        std::unique_ptr<std::istream> decoded = utf8Of(std::make_unique<std::ifstream>(std::move(from.stream)));
        out.text.clear();
        append(*decoded, kFileStart, out.text);
        if (out.text.size() == kFileStart)
            out.tail = std::make_shared<FileTail>(std::move(decoded), std::max(from.size / 2, kFileStart) - kFileStart);
        return out;
    }
    if (out.text.size() == kFileStart)
        out.tail = std::make_shared<FileTail>(std::make_unique<std::ifstream>(std::move(from.stream)),
                                              std::max(from.size, kFileStart) - kFileStart);
    return out;
}

bool FileTail::read(std::string& to, std::size_t count) {
    const std::size_t before = to.size();
    append(*m_stream, count, to);
    return to.size() == before + count;
}

InputMemory::InputMemory() {
    const std::scoped_lock lock(inputs().mutex);
    inputs().paths.emplace();
}
InputMemory::~InputMemory() {
    const std::scoped_lock lock(inputs().mutex);
    inputs().paths.reset();
}
bool isInput(const fs::path& file) {
    const std::scoped_lock lock(inputs().mutex);
    std::error_code ignored;
    return inputs().paths && inputs().paths->contains(fs::weakly_canonical(file, ignored));
}

FileLoader filesBeside(const fs::path& scene) {
    const fs::path shown = scene.parent_path();
    const fs::path folder = shown.empty() ? fs::path(".") : shown;
    return [shown, folder, left = kMaxSceneBytes,
            entriesLeft = kMaxEntries](std::string_view asked) mutable -> Result<NamedFile> {
        Result<fs::path> path = pathInFolder(folder, asked, "scene");
        if (!path) return path.errors();
        std::string name(asked), otherName;
        if (std::error_code ignored; !fs::exists(*path, ignored))
            if (const auto other = inOtherCase(folder, asked, entriesLeft)) {
                Result<fs::path> there =
                    pathInFolder(folder, other->string(), "scene");  // a link may lead out of the folder
                if (!there) return there.errors();
                path = std::move(there), name = otherName = other->string();
            }
        const auto named = [&](Error error) {
            error.found = quotedInput(name) + ": " + error.found;
            return error;
        };
        const std::string path_ = (shown / name).string();
        if (isModel(path->extension().string())) {
            Result<NamedFile> model = openFile(*path);
            if (!model) return named(model.errors().front());
            NamedFile opened = std::move(model).value();
            opened.path = path_, opened.otherName = std::move(otherName);
            return opened;
        }
        Result<std::string> text = readFile(*path, std::min(left, kMaxFileBytes));
        if (!text) return named(text.errors().front());
        left -= text->size();
        return NamedFile{std::move(text).value(), path_, nullptr, std::move(otherName)};
    };
}

}  // namespace pipeline
