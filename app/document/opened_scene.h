#pragma once
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>

#include "lessons/state/window_state.h"
#include "pipeline/core/stage.h"
#include "pipeline/formats/text/read_progress.h"
#include "pipeline/scene/scene.h"

namespace app {

// The file that a scene was last read from or saved to, as an absolute path, and the scene in it; null if there is no
// file.
struct KeptScene {
    QString file;
    std::shared_ptr<const pipeline::Scene> scene;
};

// The result of opening a file or a state. It has only values, so any thread can make it.
struct OpenedScene {
    pipeline::Scene scene;  // as it will be shown
    KeptScene kept;
    std::optional<pipeline::StageId> stage;  // of the picture's buffer
    // The state of the window in a picture; empty for any other file. Errors: the text is no state.
    pipeline::Result<std::optional<lessons::WindowState>> carried = std::optional<lessons::WindowState>();
};

// Reads a scene file, or a picture that contains a scene.
pipeline::Result<OpenedScene> readSceneFile(const QString& file, const pipeline::ReadProgress& progress = {});

// Reloads the file. Unchanged meshes stay the same objects, so their results can be reused.
pipeline::Result<OpenedScene> readSceneAgain(const KeptScene& kept, const pipeline::ReadProgress& progress = {});

// Reads the scene of a state, with paths from `folder`. open: the file that the state names, if it is open already.
pipeline::Result<OpenedScene> readStateScene(const lessons::WindowState& state, const std::filesystem::path& folder,
                                             const KeptScene& open, const pipeline::ReadProgress& progress = {});

// The state in a slide or in a picture of a buffer; empty if there is none. Errors: the text is no state.
pipeline::Result<std::optional<lessons::WindowState>> stateInPicture(const QString& file,
                                                                     const pipeline::Stop& stop = {});

}  // namespace app
