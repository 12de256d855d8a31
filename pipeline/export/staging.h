#pragma once
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "pipeline/core/result.h"

namespace pipeline {

// Files that appear in a folder together or not at all: they are written into a hidden folder
// on the same disk and moved when all are there. What was in the folder stays, but for files of
// the same name and those that are to go. Gone without a trace when it is destroyed unpublished.
class Staging {
public:
    // `target` may exist, or not; missing parents are made.
    static Result<Staging> begin(const std::filesystem::path& target);
    Staging(Staging&& other) noexcept;
    Staging& operator=(Staging&&) = delete;
    ~Staging();

    const std::filesystem::path& folder() const { return m_folder; }  // to write into
    // Waits until nobody else publishes into the target, in this process or another one, and from then on nobody does
    // until this has published or is destroyed: for who has to look at what is there first.
    void waitForOthers();
    // gone: names of files in the target that go when the new ones come.
    Result<std::monostate> publish(const std::vector<std::string>& gone = {});

private:
    Staging() = default;
    // In the target, or beside it where there is none, after the parents that are missing. False: why not.
    bool makeFolder(std::error_code& error);

    std::filesystem::path m_target, m_folder;   // m_folder is empty once published or moved from
    std::vector<std::filesystem::path> m_made;  // parents that were missing, outermost first
    int m_lock = -1;                            // a descriptor; below 0: not locked
};

// Files that are whole in memory, (name, bytes) each, into a folder: all of them, or none. Gives their names.
Result<std::vector<std::string>> writeFiles(const std::vector<std::pair<std::string, std::string>>& files,
                                            const std::filesystem::path& folder);

// Errors of files that were to appear in `folder`, as the user calls it: the hidden folder's name must not reach them.
Errors inFolder(Errors errors, const std::filesystem::path& folder);

}  // namespace pipeline
