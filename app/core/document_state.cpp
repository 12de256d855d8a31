#include "app/core/document_state.h"

#include "app/core/derived_buffers.h"
#include "app/core/mix_model.h"
#include "app/core/pinned_pixels.h"
#include "app/core/text.h"
#include "app/state/state_scene.h"

namespace app {

namespace fs = std::filesystem;
using pipeline::Result;
using pipeline::Scene;

namespace {

fs::path toPath(const QString& file) { return file.toStdString(); }

}  // namespace

bool isOpen(const Document& document, const WindowState& state, const fs::path& folder) {
    std::error_code ignored;
    return !state.scene.empty() && document.kept().scene &&
           fs::equivalent(sceneFile(state.scene, folder), toPath(document.kept().file), ignored);
}

namespace {

// A text stands for a file that is not there.
bool hasFile(const WindowState& state, const fs::path& folder) {
    std::error_code ignored;
    return !state.scene.empty() && (state.sceneText.empty() || fs::exists(sceneFile(state.scene, folder), ignored));
}

Result<Scene> originalOf(const Document& document, const WindowState& state, const fs::path& folder) {
    if (isOpen(document, state, folder)) return *document.kept().scene;
    if (hasFile(state, folder)) return readNamedScene(state.scene, folder);
    if (!state.sceneText.empty()) return Scene();
    return pipeline::Error{{}, "the state names no scene", "a scene file, or the name of a built-in scene"};
}

QString nameOf(SceneChanges changes) {
    switch (changes) {
        case SceneChanges::Given: return Document::tr("to what is kept");
        case SceneChanges::Ours: return Document::tr("changes of the last session");
        case SceneChanges::Pasted: break;
    }
    return Document::tr("paste");
}

bool showScene(Document& document, const WindowState& state, const fs::path& folder, SceneChanges changes) {
    const Result<Scene> original = originalOf(document, state, folder);
    if (!original) {
        emit document.failed(original.errors());
        return false;
    }
    Result<Scene> shown = sceneOf(state, *original);
    if (!shown) {
        emit document.failed(shown.errors());
        return false;
    }
    Scene scene = std::move(shown).value();
    scene.file = original->file;
    // Neither has a file: the same document.
    const bool isLoose = changes == SceneChanges::Pasted && !hasFile(state, folder) && document.hasScene() &&
                         document.kept().file.isEmpty();
    if (!isLoose && !isOpen(document, state, folder)) {
        Document::Kept kept;
        std::error_code ignored;
        if (hasFile(state, folder))
            kept = {toQString(fs::absolute(sceneFile(state.scene, folder), ignored).string()),
                    std::make_shared<const Scene>(*original)};
        document.setScene(changes == SceneChanges::Given || !kept.scene ? scene : *original, kept);
    }
    document.replace(std::move(scene), nameOf(changes));
    if (changes == SceneChanges::Given) document.undoStack()->setClean();
    return true;
}

}  // namespace

Result<WindowState> stateOf(const Document& document, const fs::path& folder) {
    WindowState state;
    const Document::Kept& kept = document.kept();
    if (!kept.file.isEmpty()) state.scene = sceneName(toPath(kept.file), folder);
    const pipeline::Errors errors = describeScene(state, document.scene(), kept.scene.get());
    if (!errors.empty()) return errors;
    state.stage = document.stage();
    state.place = document.stepper().place();
    state.step = document.stepper().level();
    if (const auto pixel = document.pixel()) state.pixel = {pixel->x, pixel->y};
    state.channel = document.channel();
    state.condition = document.derived().text().toStdString();
    state.mix = mixText(document.mixer().mix());
    state.bookmarks = document.stepper().bookmarks();
    if (const PinnedPixels* pins = PinnedPixels::find(document)) state.pins = pins->all();
    if (const auto& thing = document.selection()) state.selected = Selected{Selected::Kind(thing->kind), thing->index};
    return state;
}

bool show(Document& document, const WindowState& state, const fs::path& folder, SceneChanges changes) {
    if (!showScene(document, state, folder, changes)) return false;
    showPlace(document, state);
    return true;
}

void showPlace(Document& document, const WindowState& state) {
    Stepper& stepper = document.stepper();
    stepper.setPlaying(false);
    stepper.setLevel(state.step);
    if (!state.bookmarks.empty()) stepper.setBookmarks(state.bookmarks);
    document.setStage(state.stage);
    if (state.place) stepper.goTo(*state.place);
    document.setChannel(state.channel);
    document.derived().setText(toQString(state.condition));
    const auto mix = pipeline::parseMix(state.mix, document.scene().lights.size());
    mix ? document.mixer().set(*mix) : document.mixer().reset();  // of lights that the scene no longer has
    document.pick(state.pixel ? std::optional(glm::ivec2((*state.pixel)[0], (*state.pixel)[1])) : std::nullopt);
    PinnedPixels::of(document).set(state.pins);
    const auto& thing = state.selected;
    document.select(thing ? std::optional(Selection{Selection::Kind(thing->kind), thing->index}) : std::nullopt);
}

QString placeText(const WindowState& state) {
    QString words = toQString(state.place ? text(*state.place) : std::string(stageInfo(state.stage).name));
    if (state.pixel) words += Document::tr(" · pixel %1, %2").arg((*state.pixel)[0]).arg((*state.pixel)[1]);
    return words;
}

}  // namespace app
