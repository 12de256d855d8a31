// What stands in the page for files of the program that need a folder, or a library that is not there for WebAssembly.
#include "app/web/core/core.h"
#include "lessons/library.h"
#include "pipeline/formats/png_scene.h"
#include "pipeline/formats/scene_folder.h"

namespace pipeline {

bool looksLikePng(std::string_view) { return false; }
Result<Scene> readPngScene(const SourceText& source, const FileLoader&) {
    return Error{{source.name, 0, 0}, "found a picture", "a scene: pictures open in Shadescope"};
}

Result<std::string> readFile(const std::filesystem::path& file, std::size_t limit) {
    const auto& files = web::core().files;
    const auto found = files.find(file.string());
    if (found == files.end() || found->second.size() > limit) return Error{{}, "not in this page", {}};
    return found->second;
}
Result<std::string> wholeText(const SourceText& source) { return std::string(source.text); }
bool FileTail::read(std::string&, std::size_t) { return false; }
Result<std::filesystem::path> pathInFolder(const std::filesystem::path&, std::string_view, std::string_view) {
    return Error{{}, "not in this page", {}};
}

}  // namespace pipeline

namespace lessons {

std::filesystem::path lessonFolder() { return {}; }

}  // namespace lessons

// Nothing is thrown here: memory that is out, or a length that no container has, ends the core, and the page says so.
extern "C" {
void* __cxa_allocate_exception(unsigned long) { __builtin_trap(); }
[[noreturn]] void __cxa_throw(void*, void*, void (*)(void*)) { __builtin_trap(); }
}
