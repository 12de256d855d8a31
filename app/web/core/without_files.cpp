// What the page of one lesson has no use for: hashes of files, scenes by their names, exact rays.
#include "app/web/core/rays.h"
#include "pipeline/export/folder/file_hash.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/study/shadow_verdict.h"

namespace pipeline {

std::optional<std::string> sha256(const std::filesystem::path&) { return {}; }
std::string sha256Of(std::string_view) { return {}; }

std::vector<BuiltInScene> builtInScenes() { return {}; }
Result<Scene> readScene(const std::filesystem::path& file, const ReadProgress&) {
    return Error{{file.string(), 0, 0}, "not in this page", {}};
}

// A lesson may show them; the buffer itself says what is missing, in buffer_calls.cpp.
std::string whyNoShadowVerdicts(const Scene&, std::size_t) { return {}; }
bool haveSameRays(const Scene&, const Scene&) { return false; }
std::optional<ExactShadows> exactShadows(const Scene&, std::size_t, int, Stop, const std::function<void(double)>&) {
    return {};
}
std::optional<ShadowVerdicts> judgeShadows(const Frame&, const ExactShadows&) { return {}; }
AnyBuffer bufferOf(const ShadowVerdicts&) { return {}; }

}  // namespace pipeline

namespace web {

bool castsRays() { return false; }

}  // namespace web
