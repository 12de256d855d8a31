#pragma once
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>

#include "lessons/state/window_state.h"
#include "pipeline/core/stage.h"
#include "pipeline/formats/read_progress.h"
#include "pipeline/scene/scene.h"

namespace app {

// The file that a scene was read from or saved to last, as an absolute path, and the scene in it; null where it came
// from no file.
struct KeptScene {
    QString file;
    std::shared_ptr<const pipeline::Scene> scene;
};

// What opening a file or a state reads: values alone, so that any thread can.
struct OpenedScene {
    pipeline::Scene scene;  // as it is to be shown
    KeptScene kept;
    std::optional<pipeline::StageId> stage;  // of the buffer that a picture shows
    // What the window showed when a picture was made; nothing for any other file. Errors: it is no state.
    pipeline::Result<std::optional<lessons::WindowState>> carried = std::optional<lessons::WindowState>();
};

// Reads a scene file, or a picture that carries its scene.
pipeline::Result<OpenedScene> readSceneFile(const QString& file, const pipeline::ReadProgress& progress = {});

// Reads the file again. Meshes that are as they were stay the same ones, so that what was computed of them can be reused.
pipeline::Result<OpenedScene> readSceneAgain(const KeptScene& kept, const pipeline::ReadProgress& progress = {});

// Reads the scene of a state, named from `folder`. open: of the file that the state names, where that is open already.
pipeline::Result<OpenedScene> readStateScene(const lessons::WindowState& state, const std::filesystem::path& folder,
                                             const KeptScene& open, const pipeline::ReadProgress& progress = {});

// The state that a slide, or a picture of a buffer, carries; nothing where it carries none. Errors: it is no state.
pipeline::Result<std::optional<lessons::WindowState>> stateInPicture(const QString& file,
                                                                     const pipeline::Stop& stop = {});

}  // namespace app
