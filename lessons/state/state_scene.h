#pragma once
#include <filesystem>
#include <string>

#include "lessons/state/window_state.h"
#include "pipeline/formats/text/read_progress.h"
#include "pipeline/scene/scene.h"

namespace lessons {

// A scene by its file, looked for from `folder`, or by the name of a built-in scene; a file goes before a built-in
// scene of the same name. Empty `folder`: the current one.
std::filesystem::path sceneFile(const std::string& name, const std::filesystem::path& folder);
pipeline::Result<pipeline::Scene> readNamedScene(const std::string& name, const std::filesystem::path& folder,
                                                 const pipeline::ReadProgress& progress = {});
// What sceneFile finds again: the name of a built-in scene, a path within `folder`, or an absolute one.
std::string sceneName(const std::filesystem::path& file, const std::filesystem::path& folder);

// The files that views are compared with: named from `folder` where they are within it; and as absolute paths again.
void nameFilesFrom(WindowState& state, const std::filesystem::path& folder);
void findFilesFrom(WindowState& state, const std::filesystem::path& folder);

// The scene that a state shows. original: what readNamedScene gives for state.scene; unused where the state has the
// whole text. Errors: a setting that the scene does not have, a text that is no scene. The result has passed checkScene.
pipeline::Result<pipeline::Scene> sceneOf(const WindowState& state, const pipeline::Scene& original,
                                          const pipeline::ReadProgress& progress = {});
// The same with the original read from its file.
pipeline::Result<pipeline::Scene> sceneOf(const WindowState& state, const std::filesystem::path& folder,
                                          const pipeline::ReadProgress& progress = {});

// Makes the state show `scene`: by settings where these lead from `original` to it, else as text. original may be null.
// Errors: the text is too large; `set` and `sceneText` are empty then.
pipeline::Errors describeScene(WindowState& state, const pipeline::Scene& scene, const pipeline::Scene* original);

}  // namespace lessons
