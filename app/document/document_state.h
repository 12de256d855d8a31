#pragma once
#include <filesystem>

#include "app/document/document.h"
#include "lessons/state/window_state.h"

namespace app {

// The state of the document: scene, stage, step, pixel, channel, bookmarks; views and space have their defaults. The
// scene's name is relative to `folder`. The document must have a scene. Errors: the scene is too large for a text.
pipeline::Result<lessons::WindowState> stateOf(const Document& document, const std::filesystem::path& folder);

// How to treat the scene of a state.
enum class SceneChanges {
    Given,  // the state's changes belong to the scene: nothing to save
    Ours,   // unsaved changes, as one step of undo
    Pasted  // likewise
};
// Shows a state; readStateScene has read its scene. If the scene is from the open file, the document stays and gets one
// more step of undo, with `looks`.
void show(Document& document, const OpenedScene& opened, const lessons::WindowState& state, SceneChanges changes,
          StepLooks looks = {});

// The same without the scene.
void showPlace(Document& document, const lessons::WindowState& state);

// Whether the state's scene comes from the document's file.
bool isOpen(const Document& document, const lessons::WindowState& state, const std::filesystem::path& folder);

// "z-buffer/polygon=2 · pixel 268, 281": the place of a state.
QString placeText(const lessons::WindowState& state);

}  // namespace app
