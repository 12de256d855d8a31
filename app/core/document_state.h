#pragma once
#include <filesystem>

#include "app/core/document.h"
#include "lessons/state/window_state.h"

namespace app {

// What the document shows: scene, stage, step, pixel, channel, bookmarks; views and space as they begin. The scene is
// named from `folder`. Only when it has a scene. Errors: the scene is too large for a text.
pipeline::Result<lessons::WindowState> stateOf(const Document& document, const std::filesystem::path& folder);

// How the scene of a state is taken.
enum class SceneChanges {
    Given,  // what the state changes in its file belongs to it: nothing to be kept
    Ours,   // changes that were not saved, as one step of undo
    Pasted  // likewise
};
// Shows a state, of which readStateScene gave the scene. A scene from the file that is open stays the same document with
// one more step of undo, which has `looks`.
void show(Document& document, const OpenedScene& opened, const lessons::WindowState& state, SceneChanges changes,
          Document::Looks looks = {});

// The same without its scene.
void showPlace(Document& document, const lessons::WindowState& state);

// Whether the document has the file that the state's scene comes from.
bool isOpen(const Document& document, const lessons::WindowState& state, const std::filesystem::path& folder);

// "z-buffer/polygon=2 · pixel 268, 281": where a state stands.
QString placeText(const lessons::WindowState& state);

}  // namespace app
