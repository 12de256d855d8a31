#include "pipeline/export/folder/hidden_folders.h"

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace pipeline {

namespace {

struct Place {
    std::atomic<bool> taken{false};
    std::atomic<bool> filled{false};
    std::array<char, 2048> path{};
    std::size_t made = 0;
};
constinit std::array<Place, 16> places{};

// As getdents64(2) has it; the name follows.
struct Entry {
    std::uint64_t inode;
    std::int64_t offset;
    std::uint16_t bytes;
    std::uint8_t type;
};
constexpr std::size_t kName = 19;  // where the name begins

// Of a folder that is open: what is in it. A hidden folder holds at most another one and what that sets aside.
void removeContents(int folder, int levels) noexcept {
    alignas(Entry) std::array<char, 4096> block;
    bool more = true;
    while (more) {
        more = false;
        ::lseek(folder, 0, SEEK_SET);
        const long size = ::syscall(SYS_getdents64, folder, block.data(), block.size());
        for (long at = 0; at < size;) {
            const char* const record = block.data() + at;
            Entry entry;
            std::memcpy(&entry, record, kName);
            at += entry.bytes;
            const char* const name = record + kName;
            if (std::string_view(name) == "." || std::string_view(name) == "..") continue;
            if (const int inner = ::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
                inner >= 0 && levels > 0) {
                removeContents(inner, levels - 1);
                ::close(inner);
                more = ::unlinkat(folder, name, AT_REMOVEDIR) == 0 || more;
            } else {
                more = ::unlinkat(folder, name, 0) == 0 || more;  // until nothing goes any more
            }
        }
    }
}

void removeAt(Place& place) noexcept {
    char* const path = place.path.data();
    const int folder = ::open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder >= 0) {
        constexpr int kLevels = 3;
        removeContents(folder, kLevels);
        ::close(folder);
        ::rmdir(path);
    }
    for (std::size_t i = 0; i < place.made; ++i) {
        char* const last = std::strrchr(path, '/');
        if (!last || last == path) return;
        *last = '\0';
        if (::rmdir(path) != 0) return;
    }
}

constexpr std::size_t kNoPlace = places.size();

}  // namespace

HiddenFolder::HiddenFolder(const std::filesystem::path& folder, std::size_t made) : m_place(kNoPlace) {
    const std::string& path = folder.native();
    if (path.size() >= places[0].path.size()) return;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i].taken.exchange(true)) continue;
        std::ranges::copy(path, places[i].path.begin());
        places[i].path[path.size()] = '\0';
        places[i].made = made;
        places[i].filled = true;
        m_place = i;
        return;
    }
}

HiddenFolder::HiddenFolder(HiddenFolder&& other) noexcept : m_place(std::exchange(other.m_place, kNoPlace)) {}

void HiddenFolder::addParent() noexcept {
    if (m_place != kNoPlace) ++places[m_place].made;
}

HiddenFolder::~HiddenFolder() {
    if (m_place == kNoPlace) return;
    places[m_place].filled = false;
    places[m_place].taken = false;
}

void removeHiddenFolders() noexcept {
    for (Place& place : places)
        if (place.filled.exchange(false)) removeAt(place);
}

}  // namespace pipeline
