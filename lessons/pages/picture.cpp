#include "lessons/pages/picture.h"

#include <charconv>

#include "pipeline/core/text.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/text/bytes.h"
#include "pipeline/formats/text/text_scanner.h"

namespace lessons {
namespace {

using pipeline::Error;
using pipeline::numberAt;

constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n", kJpeg = "\xff\xd8\xff";

// Width and height stand at fixed bytes, in the chunk that comes first.
glm::ivec2 pngSize(std::string_view bytes) {
    if (!pipeline::hasBytes(bytes, 16, 8) || bytes.substr(12, 4) != "IHDR") return glm::ivec2(0);
    const auto at = [&](std::size_t i) { return numberAt<std::uint32_t>(bytes, i, std::endian::big); };
    constexpr std::uint32_t kMost = 0x7fffffff;  // PNG, 2nd edition, 7.1
    return at(16) > kMost || at(20) > kMost ? glm::ivec2(0) : glm::ivec2(int(at(16)), int(at(20)));
}

// In the first segment that begins a frame (ITU T.81, B.2.2); each segment before it says how long it is.
glm::ivec2 jpegSize(std::string_view bytes) {
    std::size_t at = 2;
    while (pipeline::hasBytes(bytes, at, 9) && bytes[at] == '\xff') {
        const auto marker = static_cast<unsigned char>(bytes[at + 1]);
        if (marker == 0xff) {  // fill
            ++at;
            continue;
        }
        const bool isFrame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        const auto number = [&](std::size_t i) { return numberAt<std::uint16_t>(bytes, at + i, std::endian::big); };
        if (isFrame) return {number(7), number(5)};
        at += 2 + std::size_t(number(2));
    }
    return glm::ivec2(0);
}

// "%41" is "A"; what is no such pair of digits stays.
std::string decoded(std::string_view address) {
    std::string text;
    for (std::size_t i = 0; i < address.size(); ++i) {
        unsigned char byte = 0;
        const char* const digits = address.data() + i + 1;
        if (address[i] == '%' && i + 2 < address.size() &&
            std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2)
            text += static_cast<char>(byte), i += 2;
        else
            text += address[i];
    }
    return text;
}

}  // namespace

pipeline::Result<Picture> Pictures::read(std::string_view address) {
    const std::string name = decoded(address);
    const std::string quoted = pipeline::quotedInput(name);
    const auto refuse = [&](std::string why, std::string expected = {}) {
        return Error{{}, quoted + ": " + std::move(why), std::move(expected)};
    };
    if (m_folder.empty()) return refuse("this lesson has no folder, and so no pictures");
    if (linkTarget(address) != LinkTarget::Inside) return Error{{}, quoted + " is no file of the lesson's folder", {}};
    const auto file = pipeline::pathInFolder(m_folder, name, "lesson");
    if (!file) return file.errors();
    auto bytes = pipeline::readFile(*file, std::min(kMaxPictureBytes, m_bytesLeft));
    if (!bytes) return refuse(bytes.errors().front().found, bytes.errors().front().expected);
    Picture picture;
    picture.bytes = std::move(bytes).value();
    if (picture.bytes.starts_with(kPng))
        picture.type = "png", picture.size = pngSize(picture.bytes);
    else if (picture.bytes.starts_with(kJpeg))
        picture.type = "jpeg", picture.size = jpegSize(picture.bytes);
    if (picture.size.x <= 0 || picture.size.y <= 0) return refuse("found no picture", "a PNG or JPEG file");
    const std::int64_t pixels = std::int64_t(picture.size.x) * picture.size.y;
    if (pixels > kMaxPicturePixels)
        return refuse("the picture has " + pipeline::groupedDigits(std::uint64_t(pixels)) + " pixels",
                      "at most " + pipeline::groupedDigits(kMaxPicturePixels));
    if (pixels > m_pixelsLeft)
        return refuse(
            "the pictures up to this one have more than " + pipeline::groupedDigits(kMaxPicturesPixels) + " pixels",
            "fewer or smaller pictures");
    m_bytesLeft -= picture.bytes.size();
    m_pixelsLeft -= pixels;
    return picture;
}

LinkTarget linkTarget(std::string_view address) {
    const std::string name = decoded(address);
    if (!pipeline::isPrintable(name) || name.find('\\') != name.npos || name.starts_with(' ')) return LinkTarget::None;
    const std::size_t end = name.find_first_of(":/?#");
    if (end != name.npos && name[end] == ':') {
        const std::string_view scheme = std::string_view(name).substr(0, end);
        for (const std::string_view web : {"https", "http", "mailto"})
            if (pipeline::sameLetters(scheme, web)) return LinkTarget::Web;
        return LinkTarget::None;
    }
    const std::filesystem::path path =
        std::filesystem::path(name.substr(0, name.find_first_of("?#"))).lexically_normal();
    const bool leaves = path.is_absolute() || (!path.empty() && *path.begin() == "..");
    return leaves ? LinkTarget::None : LinkTarget::Inside;
}

}  // namespace lessons
