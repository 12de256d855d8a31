#include "pipeline/formats/png_scene.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <cstring>

#include "pipeline/formats/toml/toml_scene.h"

namespace pipeline {
namespace {

// A picture as libpng takes it, piece by piece.
struct Bytes {
    std::string_view left;
    StopCheck check;
};
void take(png_structp png, png_bytep bytes, png_size_t size) {
    auto& from = *static_cast<Bytes*>(png_get_io_ptr(png));
    if (from.left.size() < size || from.check.stopped(size)) png_error(png, "");
    std::memcpy(bytes, from.left.data(), size);
    from.left.remove_prefix(size);
}
void fail(png_structp png, png_const_charp) { longjmp(png_jmpbuf(png), 1); }
void ignore(png_structp, png_const_charp) {}

// A few KB may hold a thousand texts of a megabyte each; ours hold a few.
constexpr png_uint_32 kMostChunks = 32;
constexpr png_alloc_size_t kMostChunkBytes = 2 * kMaxCarriedScene;

// libpng only warns of a chunk that claims more than its limit, and allocates what it claims, up to 2 GB. A chunk within
// the limit takes some bytes beside its own.
png_voidp allocate(png_structp, png_alloc_size_t size) {
    return size <= 2 * kMostChunkBytes ? std::malloc(size) : nullptr;
}
void release(png_structp, png_voidp memory) { std::free(memory); }

// libpng reports by longjmp: what has a destructor lives in the caller. Text stands before the pixels.
bool readHead(png_structp png, png_infop info, Bytes& from) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_chunk_malloc_max(png, kMostChunkBytes);
    png_set_chunk_cache_max(png, kMostChunks);
    png_set_read_fn(png, &from, take);
    png_read_info(png, info);
    return true;
}

// The text of one key; empty where there is none, or the file is damaged.
std::string textOf(std::string_view file, std::string_view key, const Stop& stop) {
    Bytes from{file, StopCheck(stop)};
    png_structp png =
        png_create_read_struct_2(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore, nullptr, allocate, release);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    std::string found;
    if (info && readHead(png, info, from)) {
        png_textp texts = nullptr;
        const int count = png_get_text(png, info, &texts, nullptr);
        for (int i = 0; i < count; ++i) {
            const std::size_t length = std::max(texts[i].text_length, texts[i].itxt_length);
            if (texts[i].key == key && texts[i].text) found.assign(texts[i].text, length);
        }
    }
    png_destroy_read_struct(&png, &info, nullptr);
    return found;
}

}  // namespace

bool looksLikePng(std::string_view start) { return start.starts_with("\x89PNG\r\n\x1a\n"); }

Result<Scene> readPngScene(const SourceText& source, const FileLoader&) {
    const std::string scene = textOf(source.text, kSceneChunk, source.progress.stop);
    if (source.progress.stop.stop_requested()) return readingStopped(source.name);
    if (scene.empty())
        return Error{{source.name, 0, 0}, "the picture carries no scene", "a picture that this program exported"};
    // Whatever a picture claims, no file is read on its behalf.
    const FileLoader none = [](std::string_view) -> Result<NamedFile> {
        return Error{{}, "the scene in the picture names a file", "a scene that needs none"};
    };
    return readTomlScene({scene, source.name, source.progress}, none);
}

std::string carriedState(std::string_view png, const Stop& stop) {
    return looksLikePng(png) ? textOf(png, kStateChunk, stop) : std::string();
}

std::string shownBuffer(std::string_view png, const Stop& stop) {
    return looksLikePng(png) ? textOf(png, "Title", stop) : std::string();
}

}  // namespace pipeline
