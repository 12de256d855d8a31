#include "pipeline/export/staging.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "pipeline/export/byte_file.h"
#include "pipeline/export/exporter.h"

namespace pipeline {

namespace fs = std::filesystem;

namespace {

Error folderError(const fs::path& folder, const std::error_code& error) { return writeError(folder, error.value()); }

// A new folder ".NAME.part-PID" in `parent`.
fs::path makeHidden(const fs::path& parent, const fs::path& name, std::error_code& error) {
    for (int attempt = 0; attempt < 100; ++attempt) {
        const std::string suffix = ".part-" + std::to_string(::getpid()) + '-' + std::to_string(attempt);
        const fs::path folder = parent / ('.' + name.string() + suffix);
        if (fs::create_directory(folder, error) || error) return folder;
    }
    error = std::make_error_code(std::errc::file_exists);
    return {};
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
        if (staging.makeFolder(error)) return staging;
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
    for (auto p = missing.rbegin(); p != missing.rend(); ++p) {
        const bool made = fs::create_directory(*p, error);
        if (made) m_made.push_back(*p);
        // Another process may have been first, with a folder or with a file.
        if (!made && !error && !fs::is_directory(*p, error) && !error)
            error = std::make_error_code(std::errc::file_exists);
        if (error) return false;
    }
    const fs::path folder = makeHidden(parent, m_target.filename(), error);
    if (!error) m_folder = folder;
    return !error;
}

Staging::Staging(Staging&& other) noexcept
    : m_target(std::move(other.m_target)),
      m_folder(std::exchange(other.m_folder, {})),
      m_made(std::exchange(other.m_made, {})),
      m_lock(std::exchange(other.m_lock, -1)) {}

Staging::~Staging() {
    std::error_code ignored;
    if (!m_folder.empty()) fs::remove_all(m_folder, ignored);
    for (auto p = m_made.rbegin(); p != m_made.rend(); ++p) fs::remove(*p, ignored);  // only while empty
    if (m_lock >= 0) ::close(m_lock);
}

void Staging::waitForOthers() {
    if (m_lock >= 0) return;
    // Of the folder that the target stands in, or will: the target itself may not be there yet. Where it cannot be locked
    // files are published all the same.
    m_lock = ::open(m_target.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    while (m_lock >= 0 && ::flock(m_lock, LOCK_EX) != 0 && errno == EINTR) {
    }
}

Result<std::monostate> Staging::publish(const std::vector<std::string>& gone) {
    waitForOthers();
    std::error_code error;
    bool isThere = fs::exists(m_target, error);
    if (!isThere) {
        fs::rename(m_folder, m_target, error);
        // Another process has put its files there meanwhile: these join them.
        isThere = error == std::errc::directory_not_empty || error == std::errc::file_exists;
        if (error && !isThere) return folderError(m_target, error);
        error.clear();
    }
    if (isThere) {
        std::vector<fs::path> names;
        for (const fs::directory_entry& entry : fs::directory_iterator(m_folder, error))
            names.push_back(entry.path().filename());
        // Looked at before the first one moves: either all can, or none does.
        for (const fs::path& name : names)
            if (fs::is_directory(m_target / name, error)) return writeError(m_target / name, EISDIR);
        // Put aside before they are removed: they come back where a file cannot move after all.
        const fs::path aside = m_folder / "aside";
        std::vector<fs::path> putAside;
        const auto refuse = [&](const fs::path& name) {
            std::error_code ignored;
            for (const fs::path& old : putAside) fs::rename(aside / old, m_target / old, ignored);
            return folderError(m_target / name, error);
        };
        if (!gone.empty()) fs::create_directory(aside, error);
        for (const std::string& name : gone) {
            if (!error) fs::rename(m_target / name, aside / name, error);
            if (error) return refuse(name);
            putAside.emplace_back(name);
        }
        for (const fs::path& name : names) {
            fs::rename(m_folder / name, m_target / name, error);
            if (error) return refuse(name);
        }
        fs::remove_all(m_folder, error);
    }
    m_folder.clear();
    m_made.clear();
    if (m_lock >= 0) ::close(std::exchange(m_lock, -1));
    return std::monostate{};
}

Result<std::vector<std::string>> writeFiles(const std::vector<std::pair<std::string, std::string>>& files,
                                            const fs::path& folder) {
    Result<Staging> staging = Staging::begin(folder);
    if (!staging) return staging.errors();
    Staging target = std::move(staging).value();
    std::vector<std::string> names;
    for (const auto& [name, bytes] : files) {
        ByteFile out(target.folder() / name);
        out.write(bytes);
        if (const auto written = out.close(); !written) return inFolder(written.errors(), folder);
        names.push_back(name);
    }
    if (const auto published = target.publish(); !published) return published.errors();
    return names;
}

Errors inFolder(Errors errors, const fs::path& folder) {
    for (Error& error : errors)
        if (!error.where.file.empty()) error.where.file = (folder / fs::path(error.where.file).filename()).string();
    return errors;
}

}  // namespace pipeline
