#include "pipeline/export/film/gif_file.h"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "pipeline/export/buffers/byte_file.h"

namespace pipeline {

struct GifFile::Inside {
    std::filesystem::path path;
    glm::ivec2 size;
    ByteFile file;
    GifFileType* gif = nullptr;
    bool failed = false;

    Inside(std::filesystem::path p, glm::ivec2 s) : path(std::move(p)), size(s), file(path) {}
    void check(int done) { failed = failed || done == GIF_ERROR; }
};

namespace {

constexpr int kColors = 256;

int append(GifFileType* gif, const GifByteType* bytes, int count) {
    static_cast<ByteFile*>(gif->UserData)->write(std::as_bytes(std::span(bytes, std::size_t(count))));
    return count;
}

// A picture in at most 256 colours.
struct Indexed {
    std::vector<GifByteType> pixels;
    std::vector<GifColorType> colors;
};

std::optional<Indexed> exact(const Buffer2D<Color8>& picture) {
    Indexed out;
    out.pixels.reserve(picture.pixels.size());
    std::unordered_map<std::uint32_t, GifByteType> known;
    for (const Color8 color : picture.pixels) {
        const std::uint32_t key = std::uint32_t(color.r) << 16 | std::uint32_t(color.g) << 8 | color.b;
        const auto [entry, isNew] = known.try_emplace(key, GifByteType(out.colors.size()));
        if (isNew && out.colors.size() == kColors) return std::nullopt;
        if (isNew) out.colors.push_back({color.r, color.g, color.b});
        out.pixels.push_back(entry->second);
    }
    return out;
}

std::optional<Indexed> nearest(const Buffer2D<Color8>& picture) {
    const std::size_t count = picture.pixels.size();
    std::array<std::vector<GifByteType>, 3> channels;
    for (int c = 0; c < 3; ++c) {
        channels[std::size_t(c)].reserve(count);
        for (const Color8 color : picture.pixels) channels[std::size_t(c)].push_back(color[c]);
    }
    Indexed out;
    out.pixels.resize(count);
    out.colors.resize(kColors);
    int colors = kColors;
    const int done = GifQuantizeBuffer(unsigned(picture.size.x), unsigned(picture.size.y), &colors, channels[0].data(),
                                       channels[1].data(), channels[2].data(), out.pixels.data(), out.colors.data());
    return done == GIF_ERROR ? std::nullopt : std::optional(std::move(out));
}

}  // namespace

GifFile::GifFile(const std::filesystem::path& path, glm::ivec2 size) : m_inside(std::make_unique<Inside>(path, size)) {
    Inside& in = *m_inside;
    int error = 0;
    constexpr int kLargest = 65535;
    if (size.x <= kLargest && size.y <= kLargest) in.gif = EGifOpen(&in.file, append, &error);
    if (!in.gif) {
        in.failed = true;
        return;
    }
    EGifSetGifVersion(in.gif, true);
    in.check(EGifPutScreenDesc(in.gif, size.x, size.y, 8, 0, nullptr));
    // Netscape's extension: again and again.
    constexpr std::array<unsigned char, 3> kForever{1, 0, 0};
    in.check(EGifPutExtensionLeader(in.gif, APPLICATION_EXT_FUNC_CODE));
    in.check(EGifPutExtensionBlock(in.gif, 11, "NETSCAPE2.0"));
    in.check(EGifPutExtensionBlock(in.gif, int(kForever.size()), kForever.data()));
    in.check(EGifPutExtensionTrailer(in.gif));
}

GifFile::~GifFile() {
    int error = 0;
    if (m_inside->gif) EGifCloseFile(m_inside->gif, &error);
}

void GifFile::add(const Buffer2D<Color8>& picture, int milliseconds) {
    Inside& in = *m_inside;
    if (in.failed) return;
    auto indexed = exact(picture);
    if (!indexed) indexed = nearest(picture);
    if (!indexed) {
        in.failed = true;
        return;
    }
    const GraphicsControlBlock control{DISPOSE_DO_NOT, false, std::max(1, (milliseconds + 5) / 10),
                                       NO_TRANSPARENT_COLOR};
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    in.check(EGifPutExtension(in.gif, GRAPHICS_EXT_FUNC_CODE, int(bytes.size()), bytes.data()));
    // A map holds a power of two.
    int room = 2;
    while (room < int(indexed->colors.size())) room *= 2;
    indexed->colors.resize(std::size_t(room));
    ColorMapObject* map = GifMakeMapObject(room, indexed->colors.data());
    in.check(map ? EGifPutImageDesc(in.gif, 0, 0, in.size.x, in.size.y, false, map) : GIF_ERROR);
    GifFreeMapObject(map);
    for (int y = 0; y < in.size.y && !in.failed; ++y)
        in.check(EGifPutLine(in.gif, indexed->pixels.data() + std::size_t(y) * std::size_t(in.size.x), in.size.x));
}

Result<std::uint64_t> GifFile::close() {
    Inside& in = *m_inside;
    int error = 0;
    if (in.gif) in.check(EGifCloseFile(in.gif, &error));
    in.gif = nullptr;
    const auto bytes = in.file.close();
    if (!bytes) return bytes.errors();
    if (in.failed)
        return Error{{in.path.string(), 0, 0}, "could not make a GIF of it", "a side of at most 65535 pixels"};
    return *bytes;
}

}  // namespace pipeline
