#include "app/document/opened_scene.h"

#include <QFileInfo>
#include <tuple>

#include "app/look/text.h"
#include "lessons/state/state_scene.h"
#include "pipeline/buffers/buffer_table.h"
#include "pipeline/formats/png_scene.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/plan/memory_limit.h"

namespace app {

namespace fs = std::filesystem;
using pipeline::Error;
using pipeline::Result;
using pipeline::Scene;

namespace {

bool isPicture(const QString& file) { return file.endsWith(".png", Qt::CaseInsensitive); }

// Of a picture, more than what stands before the pixels.
Result<std::string> headOf(const QString& file) {
    constexpr std::size_t kHead = std::size_t{4} << 20;
    return pipeline::readStart(file.toStdString(), kHead);
}

// A text stands for a file that is not there.
bool hasFile(const lessons::WindowState& state, const fs::path& folder) {
    std::error_code ignored;
    return !state.scene.empty() &&
           (state.sceneText.empty() || fs::exists(lessons::sceneFile(state.scene, folder), ignored));
}

std::optional<pipeline::StageId> stageShownBy(const QString& picture, const pipeline::Stop& stop) {
    const auto head = headOf(picture);
    const auto name = head ? pipeline::findAnyBuffer(pipeline::shownBuffer(*head, stop)) : std::nullopt;
    return name ? std::optional(pipeline::bufferInfo(name->id).stage) : std::nullopt;
}

// What else makeMesh derives follows from these.
bool isSame(const pipeline::Mesh& a, const pipeline::Mesh& b) {
    const auto given = [](const pipeline::Mesh& mesh) {
        return std::tie(mesh.file, mesh.positions, mesh.normals, mesh.triangles, mesh.corners, mesh.firstCorner,
                        mesh.polygonPlaces);
    };
    return given(a) == given(b);
}

}  // namespace

Result<std::optional<lessons::WindowState>> stateInPicture(const QString& file, const pipeline::Stop& stop) {
    const auto head = headOf(file);
    const std::string text = head ? pipeline::carriedState(*head, stop) : std::string();
    if (text.empty()) return std::optional<lessons::WindowState>();
    const auto state = lessons::readState(text, file.toStdString());
    if (!state) return state.errors();
    lessons::WindowState shown = *state;
    if (const std::string buffer = pipeline::shownBuffer(*head, stop);
        pipeline::findAnyBuffer(buffer) && !shown.views.empty() && shown.views.front().buffer != buffer)
        shown.views.front() = {buffer};
    return std::optional(shown);
}

Result<OpenedScene> readSceneFile(const QString& file, const pipeline::ReadProgress& progress) {
    Result<Scene> scene = pipeline::readScene(file.toStdString(), progress);
    if (!scene) return scene.errors();
    if (const pipeline::Errors errors = checkSceneAndMemory(*scene); !errors.empty()) return errors;
    OpenedScene opened;
    opened.scene = std::move(scene).value();
    opened.kept = {QFileInfo(file).absoluteFilePath(), std::make_shared<const Scene>(opened.scene)};
    if (isPicture(file)) {
        opened.stage = stageShownBy(file, progress.stop);
        opened.carried = stateInPicture(file, progress.stop);
    }
    return opened;
}

Result<OpenedScene> readSceneAgain(const KeptScene& kept, const pipeline::ReadProgress& progress) {
    Result<OpenedScene> read = readSceneFile(kept.file, progress);
    if (!read) return read;
    OpenedScene again = std::move(read).value();
    std::vector<pipeline::Object>& objects = again.scene.objects;
    for (std::size_t i = 0; i < std::min(objects.size(), kept.scene->objects.size()); ++i)
        if (const auto& mesh = kept.scene->objects[i].mesh; isSame(*objects[i].mesh, *mesh)) objects[i].mesh = mesh;
    again.kept.scene = std::make_shared<const Scene>(again.scene);
    return again;
}

Result<OpenedScene> readStateScene(const lessons::WindowState& state, const fs::path& folder, const KeptScene& open,
                                   const pipeline::ReadProgress& progress) {
    OpenedScene opened;
    opened.kept = open;
    if (!open.scene && hasFile(state, folder)) {
        Result<Scene> original = lessons::readNamedScene(state.scene, folder, progress);
        if (!original) return original.errors();
        std::error_code ignored;
        opened.kept = {toQString(fs::absolute(lessons::sceneFile(state.scene, folder), ignored).string()),
                       std::make_shared<const Scene>(std::move(original).value())};
    }
    if (!opened.kept.scene && state.sceneText.empty())
        return Error{{}, "the state names no scene", "a scene file, or the name of a built-in scene"};
    Result<Scene> shown = sceneOf(state, opened.kept.scene ? *opened.kept.scene : Scene(), progress);
    if (!shown) return shown.errors();
    if (const pipeline::Errors errors = checkSceneAndMemory(*shown); !errors.empty()) return errors;
    opened.scene = std::move(shown).value();
    opened.scene.file = opened.kept.scene ? opened.kept.scene->file : std::string();
    return opened;
}

}  // namespace app
