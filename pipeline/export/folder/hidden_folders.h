#pragma once
#include <cstddef>
#include <filesystem>

namespace pipeline {

// The hidden folders that this process writes into, kept so that they can be removed without any memory: when the
// process has to end because it gets none, nobody's destructor runs.
class HiddenFolder {
public:
    // The folder need not exist yet. made: how many of its parents were made for it, which go with it where nothing else
    // is in them. A folder with a very long name, or beside very many others, is not kept: it is the next run's.
    explicit HiddenFolder(const std::filesystem::path& folder, std::size_t made = 0);
    HiddenFolder(HiddenFolder&& other) noexcept;
    HiddenFolder& operator=(HiddenFolder&&) = delete;
    ~HiddenFolder();

    // One more parent was made for it, inside those made before.
    void addParent() noexcept;

private:
    std::size_t m_place;
};

// Removes all of them, and what is in them. Calls only what signal-safety(7) lists, and getdents64(2).
void removeHiddenFolders() noexcept;

}  // namespace pipeline
