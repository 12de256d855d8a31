#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/export/folder/hidden_folders.h"

namespace pipeline {

// Files that appear in a folder together or not at all: they are written into a hidden folder
// on the same disk and moved when all are there. What was in the folder stays, but for files of
// the same name and those that are to go. Gone without a trace when it is destroyed unpublished.
//
// Several files cannot move in one step. So the one that names the others, the index, is taken away first and published
// last: where a process is ended in between there is none, and INDEX.unfinished says why (pipeline/export/folder/contents.h).
class Staging {
public:
    // `target` may exist, or not; missing parents are made. Removes what processes that are gone have left in it.
    static Result<Staging> begin(const std::filesystem::path& target);
    Staging(Staging&& other) noexcept;
    Staging& operator=(Staging&&) = delete;
    ~Staging();

    const std::filesystem::path& folder() const { return m_folder; }  // to write into
    // Waits until nobody else publishes into the target, in this process or another one, and from then on nobody does
    // until this has published or is destroyed: for who has to look at what is there first.
    void waitForOthers();
    // gone: names of files in the target that go when the new ones come. index: the name of the file that names the
    // others; empty where a single file moves. Where a file cannot move all that has moved comes back.
    Result<std::monostate> publish(const std::vector<std::string>& gone = {}, const std::string& index = {});

private:
    Staging() = default;
    // In the target, or beside it where there is none, after the parents that are missing. False: why not.
    bool makeFolder(std::error_code& error);
    Result<std::monostate> moveFiles(const std::vector<std::string>& gone, const std::string& index);

    std::filesystem::path m_target, m_folder;   // m_folder is empty once published or moved from
    std::vector<std::filesystem::path> m_made;  // parents that were missing, outermost first
    std::optional<HiddenFolder> m_kept;         // removed also where no memory is left
    int m_own = -1;                             // a descriptor of m_folder, locked as long as it is in use
    int m_lock = -1;                            // of the folder that the target stands in; below 0: not locked
};

// Files that are whole in memory, (name, bytes) each, into a folder: all of them, or none; the last of several is their index.
// Gives their names.
Result<std::vector<std::string>> writeFiles(const std::vector<std::pair<std::string, std::string>>& files,
                                            const std::filesystem::path& folder);

// One file, whole, or what stands there stays. Where that is a link the file it leads to is written; permissions stay.
// Its folder has to be there.
Result<std::monostate> writeWhole(const std::filesystem::path& file, std::string_view bytes);

// Errors of files that were to appear in `folder`, as the user calls it: the hidden folder's name must not reach them.
Errors inFolder(Errors errors, const std::filesystem::path& folder);

}  // namespace pipeline
