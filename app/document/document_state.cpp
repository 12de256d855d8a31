#include "app/document/document_state.h"

#include "app/frames/derived_buffers.h"
#include "app/frames/mix_model.h"
#include "app/look/text.h"
#include "lessons/state/state_scene.h"
#include "pipeline/formats/toml/toml_writer.h"

namespace app {

namespace fs = std::filesystem;
using pipeline::Result;

namespace {

fs::path toPath(const QString& file) { return file.toStdString(); }

}  // namespace

bool isOpen(const Document& document, const lessons::WindowState& state, const fs::path& folder) {
    std::error_code ignored;
    return !state.scene.empty() && document.kept().scene &&
           fs::equivalent(lessons::sceneFile(state.scene, folder), toPath(document.kept().file), ignored);
}

namespace {

bool isSameText(const pipeline::Scene& a, const pipeline::Scene& b) {
    const auto first = toTomlScene(a), second = toTomlScene(b);
    return first && second && *first == *second;
}

QString nameOf(SceneChanges changes) {
    switch (changes) {
        case SceneChanges::Given: return Document::tr("to what is kept");
        case SceneChanges::Ours: return Document::tr("changes of the last session");
        case SceneChanges::Pasted: break;
    }
    return Document::tr("paste");
}

}  // namespace

Result<lessons::WindowState> stateOf(const Document& document, const fs::path& folder) {
    lessons::WindowState state;
    const KeptScene& kept = document.kept();
    if (!kept.file.isEmpty()) state.scene = lessons::sceneName(toPath(kept.file), folder);
    const pipeline::Errors errors = describeScene(state, document.scene(), kept.scene.get());
    if (!errors.empty()) return errors;
    state.stage = document.stage();
    state.place = document.stepper().place();
    state.step = document.stepper().level();
    state.algorithm = document.stepper().showsAlgorithm();
    if (const auto pixel = document.pointing().pixel()) state.pixel = {pixel->x, pixel->y};
    state.channel = document.pointing().channel();
    state.condition = document.derived().text().toStdString();
    state.mix = mixText(document.mixer().mix());
    state.bookmarks = document.stepper().bookmarks();
    state.pins = document.pointing().pins().all();
    state.selected = document.pointing().selection();
    return state;
}

void show(Document& document, const OpenedScene& opened, const lessons::WindowState& state, SceneChanges changes,
          StepLooks looks) {
    const KeptScene& kept = opened.kept;
    const bool isOpen = kept.scene && kept.scene == document.kept().scene;
    // Neither has a file: the same document.
    const bool isLoose =
        changes == SceneChanges::Pasted && !kept.scene && document.hasScene() && document.kept().file.isEmpty();
    if (!isLoose && !isOpen) {
        document.setScene(changes == SceneChanges::Given || !kept.scene ? opened.scene : *kept.scene, kept);
        looks = {};  // of a document that is gone
    }
    // Text makes new objects of the same scene: what is no change is not one because of that.
    const bool isPasted = changes == SceneChanges::Pasted && isOpen && opened.scene != document.scene();
    const bool isSame = isPasted && isSameText(opened.scene, document.scene());
    document.replace(isSame ? document.scene() : opened.scene, nameOf(changes), std::move(looks));
    if (changes == SceneChanges::Given) document.history().stack()->setClean();
    showPlace(document, state);
}

void showPlace(Document& document, const lessons::WindowState& state) {
    Stepper& stepper = document.stepper();
    stepper.setPlaying(false);
    stepper.setLevel(state.step);
    stepper.setShowsAlgorithm(state.algorithm);
    if (!state.bookmarks.empty()) stepper.setBookmarks(state.bookmarks);
    document.setStage(state.stage);
    if (state.place) stepper.goTo(*state.place);
    document.pointing().setChannel(state.channel);
    document.derived().setText(toQString(state.condition));
    const auto mix = pipeline::parseMix(state.mix, document.scene().lights.size());
    mix ? document.mixer().set(*mix) : document.mixer().reset();  // of lights that the scene no longer has
    document.pointing().pick(state.pixel ? std::optional(glm::ivec2((*state.pixel)[0], (*state.pixel)[1]))
                                         : std::nullopt);
    document.pointing().pins().set(state.pins);
    document.pointing().select(state.selected);
}

QString placeText(const lessons::WindowState& state) {
    QString words = toQString(state.place ? text(*state.place) : std::string(stageInfo(state.stage).name));
    if (state.pixel) words += Document::tr(" · pixel %1, %2").arg((*state.pixel)[0]).arg((*state.pixel)[1]);
    return words;
}

}  // namespace app
