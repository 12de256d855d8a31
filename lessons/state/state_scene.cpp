#include "lessons/state/state_scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/core/text.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/formats/toml/toml_writer.h"
#include "pipeline/scene/key_places.h"
#include "pipeline/scene/settings_table.h"

namespace lessons {

namespace fs = std::filesystem;
using pipeline::BuiltInScene;
using pipeline::Error;
using pipeline::Errors;
using pipeline::Result;
using pipeline::Scene;

fs::path sceneFile(const std::string& name, const fs::path& folder) {
    std::error_code ignored;
    const fs::path file = folder / name;
    if (fs::is_regular_file(file, ignored)) return file;
    const auto scenes = pipeline::builtInScenes();
    const auto found = std::ranges::find(scenes, name, &BuiltInScene::name);
    return found != scenes.end() ? found->file : file;
}

Result<Scene> readNamedScene(const std::string& name, const fs::path& folder, const pipeline::ReadProgress& progress) {
    const fs::path file = sceneFile(name, folder);
    std::error_code ignored;
    // A path says best itself why it cannot be read.
    if (fs::exists(file, ignored) || name.find_first_of("./") != name.npos) return pipeline::readScene(file, progress);
    std::vector<std::string> names;
    for (const BuiltInScene& scene : pipeline::builtInScenes()) names.push_back(scene.name);
    return Error{
        {},
        fmt::format("no file and no built-in scene {}; {}", pipeline::inQuotes(name), pipeline::insteadOf(name, names)),
        {}};
}

std::string sceneName(const fs::path& file, const fs::path& folder) {
    std::error_code ignored;
    for (const BuiltInScene& scene : pipeline::builtInScenes())
        if (fs::equivalent(scene.file, file, ignored)) return scene.name;
    const fs::path whole = fs::absolute(file, ignored).lexically_normal();
    const fs::path inside = whole.lexically_relative(fs::absolute(folder, ignored).lexically_normal());
    if (folder.empty() || inside.empty() || *inside.begin() == "..") return whole.string();
    return inside.string();
}

Result<Scene> sceneOf(const WindowState& state, const Scene& original, const pipeline::ReadProgress& progress) {
    if (!state.sceneText.empty()) {
        const pipeline::FileLoader none = [](std::string_view) -> Result<pipeline::NamedFile> {
            return Error{{}, "the scene's text names a file", "a scene that needs none"};
        };
        return readTomlScene({state.sceneText, "scene_text", progress}, none);
    }
    Scene scene = original;
    pipeline::KeyPlaces places;
    for (std::size_t i = 0; i < state.set.size(); ++i) {
        const pipeline::SourceLocation where = state.places.of(fmt::format("set.{}", i));
        places.add(std::string(pipeline::assignedKey(state.set[i])), where);
        Result<Scene> changed = withSetting(std::move(scene), state.set[i]);
        if (!changed) return namedAt(where, changed.errors());
        scene = std::move(changed).value();
    }
    if (const Errors errors = checkScene(scene); !errors.empty()) return places.placed(errors);
    return scene;
}

Result<Scene> sceneOf(const WindowState& state, const fs::path& folder, const pipeline::ReadProgress& progress) {
    if (!state.sceneText.empty()) return sceneOf(state, Scene(), progress);
    const Result<Scene> original = readNamedScene(state.scene, folder, progress);
    if (!original) return namedAt(state.places.of("scene"), original.errors());
    return sceneOf(state, *original);
}

namespace {

// The settings that make `scene` of `original`; nothing where they do not.
std::optional<std::vector<std::string>> settingsBetween(const Scene& original, const Scene& scene) {
    Scene made = original;
    std::vector<std::string> set;
    if (original.objects.size() != scene.objects.size() || original.lights.size() != scene.lights.size()) return {};
    for (const pipeline::SettingRef& setting : settingsOf(original)) {
        const double value = setting.get(scene);
        if (value == setting.get(made)) continue;
        set.push_back(setting.key() + '=' + formatSetting(setting, value));
        setting.set(made, value);
    }
    made.name = scene.name, made.file = scene.file, made.look = scene.look;
    return made == scene ? std::optional(set) : std::nullopt;
}

}  // namespace

namespace {

constexpr std::string_view kFileWord = "file ";

template <class Change>
void changeFiles(WindowState& state, Change change) {
    for (BufferShown& view : state.views)
        if (view.compared && view.compared->with.starts_with(kFileWord))
            view.compared->with =
                std::string(kFileWord) + change(fs::path(view.compared->with.substr(kFileWord.size()))).string();
}

}  // namespace

void nameFilesFrom(WindowState& state, const fs::path& folder) {
    if (folder.empty()) return;
    changeFiles(state, [&](const fs::path& file) {
        const fs::path within = file.lexically_relative(folder);
        return within.empty() || *within.begin() == ".." ? file : within;
    });
}

void findFilesFrom(WindowState& state, const fs::path& folder) {
    changeFiles(state,
                [&](const fs::path& file) { return file.is_absolute() || folder.empty() ? file : folder / file; });
}

Errors describeScene(WindowState& state, const Scene& scene, const Scene* original) {
    state.set.clear();
    state.sceneText.clear();
    if (original) {
        if (auto set = settingsBetween(*original, scene)) {
            state.set = std::move(*set);
            return {};
        }
    }
    const auto text = toTomlScene(scene);
    if (!text) return text.errors();
    state.sceneText = *text;
    return {};
}

}  // namespace lessons
