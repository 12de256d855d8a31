#include "pipeline/export/folder/staging.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <mutex>
#include <new>
#include <set>
#include <system_error>
#include <utility>

#include "pipeline/export/buffers/byte_file.h"
#include "pipeline/export/buffers/exporter.h"
#include "pipeline/export/folder/contents.h"
#include "pipeline/export/folder/owner.h"
#include "pipeline/export/folder/publish.h"
#include "pipeline/formats/text/inputs.h"

namespace pipeline {

namespace fs = std::filesystem;

namespace {

Error folderError(const fs::path& folder, const std::error_code& error) { return writeError(folder, error.value()); }
Error replacesInput(const fs::path& file) {
    return {{file.string()}, "this file was read, so it is not replaced", "another folder or name"};
}

// A lock on a folder that its holder's end frees, also an end by force; below 0: none.
int lockFolder(const fs::path& folder, int how) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) return -1;
    while (::flock(descriptor, how) != 0) {
        if (errno == EINTR) continue;
        const int why = errno;
        ::close(descriptor);
        errno = why;
        return -1;
    }
    return descriptor;
}

// What processes that are gone have left in `parent`. A process in a container has its own numbers: its lock tells that
// it is there.
void removeLeftovers(const fs::path& parent) {
    std::error_code error;
    std::vector<fs::path> found;
    for (fs::directory_iterator entry(parent, error), end; !error && entry != end; entry.increment(error))
        if (isLeftover(entry->path().filename().string())) found.push_back(entry->path());
    for (const fs::path& one : found) {
        const int lock = lockFolder(one, LOCK_EX | LOCK_NB);
        if (lock >= 0 || errno != EWOULDBLOCK) fs::remove_all(one, error);
        if (lock >= 0) ::close(lock);
    }
}

// Moves files one by one, and all of them back.
class Moves {
public:
    void move(const fs::path& from, const fs::path& to, std::error_code& error) {
        if (error) return;
        m_done.emplace_back(from, to);  // first: after the move nothing may fail
        fs::rename(from, to, error);
        if (error) m_done.pop_back();
    }
    void undo() {
        std::error_code ignored;
        for (auto one = m_done.rbegin(); one != m_done.rend(); ++one) fs::rename(one->second, one->first, ignored);
    }

private:
    std::vector<std::pair<fs::path, fs::path>> m_done;
};

// The folders that names of files lead to, "" among them.
std::set<fs::path> foldersOf(const std::vector<std::string>& names) {
    std::set<fs::path> folders{""};
    for (const std::string& name : names) folders.insert(fs::path(name).parent_path());
    return folders;
}

// Else a machine that goes off may keep the index and lose what it names.
void bringToDisk(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

}  // namespace

namespace {

// Where one file goes: the place that a link leads to, absolute.
Result<fs::path> placeOf(const fs::path& file) {
    std::error_code error;
    fs::path target = file;
    if (fs::is_symlink(fs::symlink_status(file, error))) target = fs::weakly_canonical(file, error);
    if (fs::exists(fs::status(target, error)) && ::access(target.c_str(), W_OK) != 0) return writeError(file, errno);
    target = fs::absolute(target, error);
    if (!fs::is_directory(target.parent_path(), error)) return writeError(file, error ? error.value() : ENOTDIR);
    return target;
}

}  // namespace

Result<Staging> Staging::begin(const fs::path& target) {
    Staging staging;
    std::error_code error;
    staging.m_target = fs::absolute(target, error).lexically_normal();
    if (!staging.m_target.has_filename()) staging.m_target = staging.m_target.parent_path();  // "out/"
    // Another process that made a parent removes it where it publishes nothing, and may do so right after this one has
    // seen it there, or has been told that it exists. Then all is looked at anew.
    constexpr int kMostAttempts = 100;
    for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
        error.clear();
        if (staging.makeFolder(error)) {
            removeLeftovers(staging.m_target);
            removeLeftovers(staging.m_target.parent_path());
            return staging;
        }
        if (error != std::errc::no_such_file_or_directory && error != std::errc::file_exists) break;
    }
    return folderError(target, error);
}

bool Staging::makeFolder(std::error_code& error) {
    const bool exists = fs::exists(m_target, error);
    if (exists && !fs::is_directory(m_target, error)) {
        error = std::make_error_code(std::errc::not_a_directory);
        return false;
    }
    const fs::path parent = exists ? m_target : m_target.parent_path();
    std::vector<fs::path> missing;  // innermost first
    for (fs::path p = parent; !fs::exists(p, error) && !error && p.has_relative_path(); p = p.parent_path())
        missing.push_back(p);
    // What needs memory comes before the first folder is made: if there is none, no empty folder is left.
    m_made.reserve(m_made.size() + missing.size());
    fs::path folder = parent / hiddenName(0);
    m_kept.emplace(folder, m_made.size());
    for (auto p = missing.rbegin(); p != missing.rend(); ++p) {
        const bool made = fs::create_directory(*p, error);
        // Another process may have been first, with a folder or with a file.
        if (!made && !error && !fs::is_directory(*p, error) && !error)
            error = std::make_error_code(std::errc::file_exists);
        if (error) return false;
        if (!made) continue;
        m_made.push_back(std::move(*p));
        m_kept->addParent();
    }
    constexpr int kMostNames = 100;
    bool made = fs::create_directory(folder, error);
    for (int number = 1; !made && !error && number < kMostNames; ++number) {
        folder = parent / hiddenName(number);
        m_kept.emplace(folder, m_made.size());
        made = fs::create_directory(folder, error);
    }
    if (!made && !error) error = std::make_error_code(std::errc::file_exists);
    if (error) return false;
    m_folder = std::move(folder);
    m_own = lockFolder(m_folder, LOCK_EX | LOCK_NB);
    return true;
}

Staging::Staging(Staging&& other) noexcept
    : m_target(std::move(other.m_target)),
      m_folder(std::exchange(other.m_folder, {})),
      m_made(std::exchange(other.m_made, {})),
      m_kept(std::move(other.m_kept)),
      m_own(std::exchange(other.m_own, -1)),
      m_lock(std::exchange(other.m_lock, -1)) {}

Staging::~Staging() {
    std::error_code ignored;
    if (!m_folder.empty()) fs::remove_all(m_folder, ignored);
    for (auto p = m_made.rbegin(); p != m_made.rend(); ++p) fs::remove(*p, ignored);  // only while empty
    if (m_own >= 0) ::close(m_own);
    if (m_lock >= 0) ::close(m_lock);
}

void Staging::waitForOthers() {
    if (m_lock >= 0) return;
    // Of the folder that the target stands in, or will: the target itself may not be there yet. Where it cannot be locked
    // files are published all the same.
    m_lock = lockFolder(m_target.parent_path(), LOCK_EX);
}

namespace {

std::mutex publishing;
std::uint64_t published = 0;  // under it

}  // namespace

std::uint64_t publications() {
    const std::scoped_lock lock(publishing);
    return published;
}

void endBetweenPublications(std::uint64_t known, void (*end)()) {
    const std::scoped_lock lock(publishing);
    if (published == known) end();
}

Result<std::monostate> Staging::publish(const std::vector<std::string>& gone, const std::string& index) {
    waitForOthers();
    const std::scoped_lock lock(publishing);
    ++published;
    std::error_code error;
    bool isThere = fs::exists(m_target, error);
    if (!isThere) {
        fs::rename(m_folder, m_target, error);
        // Another process has put its files there meanwhile: these join them.
        isThere = error == std::errc::directory_not_empty || error == std::errc::file_exists;
        if (error && !isThere) return folderError(m_target, error);
    }
    if (isThere) {
        if (const auto moved = moveFiles(gone, index); !moved) return moved.errors();
        fs::remove_all(m_folder, error);
    }
    m_folder.clear();
    m_kept.reset();
    m_made.clear();
    if (m_own >= 0) ::close(std::exchange(m_own, -1));
    if (m_lock >= 0) ::close(std::exchange(m_lock, -1));
    return std::monostate{};
}

Result<std::monostate> Staging::moveFiles(const std::vector<std::string>& gone, const std::string& index) {
    std::error_code error;
    std::vector<std::string> names;
    for (fs::recursive_directory_iterator entry(m_folder, error), end; !error && entry != end; entry.increment(error)) {
        if (entry->is_directory(error)) continue;
        const std::string name = entry->path().lexically_relative(m_folder).generic_string();
        if (name != index) names.push_back(name);
    }
    if (error) return folderError(m_target, error);
    if (!index.empty()) names.push_back(index);
    // Looked at before the first one moves: either all can, or none does.
    for (const std::string& name : names) {
        if (fs::is_directory(m_target / name, error)) return writeError(m_target / name, EISDIR);
        if (isInput(m_target / name)) return replacesInput(m_target / name);
    }
    for (const std::string& name : gone)
        if (isInput(m_target / name)) return replacesInput(m_target / name);
    error.clear();

    std::vector<std::string> old;  // the index first
    if (!index.empty()) {
        std::error_code ignored;
        for (const std::string& name : names)
            if (fs::exists(fs::symlink_status(m_target / name, ignored))) old.push_back(name);
        if (!old.empty() && old.back() == index) std::swap(old.front(), old.back());
    }
    old.insert(old.end(), gone.begin(), gone.end());

    const fs::path aside = m_folder / "aside", mark = m_target / unfinishedName(index);
    const bool wasMarked = fs::exists(mark, error);
    if (!index.empty()) {
        std::vector<std::string> onTheirWay = names;
        onTheirWay.insert(onTheirWay.end(), gone.begin(), gone.end());
        ByteFile text(m_folder / mark.filename());
        text.write(unfinishedText(onTheirWay));
        if (const auto written = text.close(); !written) return inFolder(written.errors(), m_target);
        fs::rename(m_folder / mark.filename(), mark, error);
        if (error) return folderError(mark, error);
    }
    Moves moves;
    std::string moved;            // the last one
    std::vector<fs::path> added;  // folders below the target, outermost first
    const auto undo = [&] {
        moves.undo();
        std::error_code ignored;
        for (auto folder = added.rbegin(); folder != added.rend(); ++folder) fs::remove(*folder, ignored);
        if (!index.empty() && !wasMarked) fs::remove(mark, ignored);
    };
    try {
        const auto move = [&](const std::string& name, const fs::path& from, const fs::path& to) {
            if (!error) moved = name;
            moves.move(from / name, to / name, error);
        };
        if (!old.empty()) fs::create_directory(aside, error);
        std::vector<std::string> all = names;
        all.insert(all.end(), old.begin(), old.end());
        for (const std::string& name : all) {
            const fs::path below = fs::path(name).parent_path();
            if (below.empty() || error) continue;
            if (!old.empty()) fs::create_directories(aside / below, error);
            if (!error && fs::create_directory(m_target / below, error)) added.push_back(m_target / below);
        }
        for (const std::string& name : old) move(name, m_target, aside);
        for (const std::string& name : names) {
            if (name == index)
                for (const fs::path& folder : foldersOf(names)) bringToDisk(m_target / folder);
            move(name, m_folder, m_target);
        }
    } catch (const std::bad_alloc&) {
        undo();
        throw;
    }
    if (error) {
        undo();
        return folderError(m_target / moved, error);
    }
    if (!index.empty()) fs::remove(mark, error);
    return std::monostate{};
}

Errors whyNotInto(const fs::path& folder, const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (isInput(folder / name)) return {replacesInput(folder / name)};
    const Result<Staging> tried = Staging::begin(folder);
    return tried ? Errors() : tried.errors();
}

Errors whyNotTo(const fs::path& file) {
    if (isInput(file)) return {replacesInput(file)};
    const auto place = placeOf(file);
    if (!place) return place.errors();
    const Result<Staging> tried = Staging::begin(place->parent_path());
    return tried ? Errors() : inFolder(tried.errors(), file.parent_path());
}

Result<std::vector<std::string>> writeFiles(const std::vector<std::pair<std::string, std::string>>& files,
                                            const fs::path& folder) {
    return replaceFiles(files, folder, {});
}

Result<std::vector<std::string>> replaceFiles(const std::vector<std::pair<std::string, std::string>>& files,
                                              const fs::path& folder, const std::vector<std::string>& gone) {
    Result<Staging> staging = Staging::begin(folder);
    if (!staging) return staging.errors();
    Staging target = std::move(staging).value();
    std::vector<std::string> names;
    for (const auto& [name, bytes] : files) {
        std::error_code made;  // what failed the file tells
        if (const fs::path below = fs::path(name).parent_path(); !below.empty())
            fs::create_directories(target.folder() / below, made);
        ByteFile out(target.folder() / name);
        out.write(bytes);
        if (const auto written = out.close(); !written) return inFolder(written.errors(), folder);
        names.push_back(name);
    }
    if (const auto published = target.publish(gone, names.size() > 1 ? names.back() : std::string()); !published)
        return published.errors();
    return names;
}

Result<std::monostate> writeWhole(const fs::path& file, std::string_view bytes) {
    std::error_code error;
    const auto place = placeOf(file);
    if (!place) return place.errors();
    const fs::path target = *place, folder = target.parent_path();
    const fs::file_status before = fs::status(target, error);
    Result<Staging> staging = Staging::begin(folder);
    if (!staging) return inFolder(staging.errors(), folder);
    Staging hidden = std::move(staging).value();
    ByteFile out(hidden.folder() / target.filename());
    out.write(bytes);
    if (const auto written = out.close(); !written) return inFolder(written.errors(), file.parent_path());
    if (fs::exists(before)) fs::permissions(hidden.folder() / target.filename(), before.permissions(), error);
    return hidden.publish();
}

Errors inFolder(Errors errors, const fs::path& folder) {
    for (Error& error : errors)
        if (!error.where.file.empty()) error.where.file = (folder / fs::path(error.where.file).filename()).string();
    return errors;
}

}  // namespace pipeline
