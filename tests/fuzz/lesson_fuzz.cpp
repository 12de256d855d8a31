// Any bytes as a lesson over the built-in scenes: there are pages whose scenes can be drawn, or errors that point into
// the text.
#include <cstdint>

#include "lessons/lesson.h"
#include "pipeline/scene/settings_table.h"
#include "tests/fuzz/promises.h"
#include "tests/fuzz/small_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto lesson = lessons::parseLesson({reinterpret_cast<const char*>(data), size}, "lesson.md",
                                             [](std::string_view) { return fuzz::smallScene(); });
    if (!lesson) {
        fuzz::checkErrors(lesson.errors());
        return 0;
    }
    fuzz::require(!lesson->pages.empty());
    for (const lessons::Page& page : lesson->pages) {
        fuzz::require(pipeline::checkScene(page.first.state.scene).empty());
        fuzz::require(!shownBuffers(page.first.state).empty());
        fuzz::require(page.first.text.pieces.size() == page.first.text.holes.size() + 1);
    }
    return 0;
}
