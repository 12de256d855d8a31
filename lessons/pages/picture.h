#pragma once
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "pipeline/core/result.h"

namespace lessons {

// A PNG or JPEG file as it is, with its size as its header says.
struct Picture {
    std::string bytes;
    std::string_view type;  // "png" or "jpeg"
    glm::ivec2 size{0};     // pixels
};

inline constexpr std::size_t kMaxPictureBytes = std::size_t{8} << 20;  // one picture
inline constexpr std::int64_t kMaxPicturePixels = 16'000'000;          // one picture: 4 bytes each once it is unpacked
inline constexpr std::size_t kMaxPicturesBytes = std::size_t{32} << 20;  // all that one Pictures reads
inline constexpr std::int64_t kMaxPicturesPixels = 48'000'000;

// Reads the pictures that a lesson's Markdown names.
class Pictures {
public:
    // folder: the lesson's; empty where it has none, and then no picture is read.
    explicit Pictures(std::filesystem::path folder) : m_folder(std::move(folder)) {}

    // From here on those of another folder; the budget stays.
    void readFrom(std::filesystem::path folder) { m_folder = std::move(folder); }

    // address: of ![words](address), with %20 for a space. Read are regular files in the folder and below it; errors
    // have no place.
    pipeline::Result<Picture> read(std::string_view address);

private:
    std::filesystem::path m_folder;
    std::size_t m_bytesLeft = kMaxPicturesBytes;
    std::int64_t m_pixelsLeft = kMaxPicturesPixels;
};

// Whether a link of a lesson keeps its address: a page of the web, an address of mail, a place in the page, or a file in
// the lesson's folder or below it. Everything else would run something, or lead a reader's click to a file elsewhere.
enum class LinkTarget { None, Web, Inside };
LinkTarget linkTarget(std::string_view address);

}  // namespace lessons
