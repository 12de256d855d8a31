#include "app/web/core/core.h"
#include "app/web/core/scene_text.h"
#include "pipeline/export/json/frame_json.h"
#include "pipeline/formats/format_table.h"
#include "pipeline/formats/text/text_scanner.h"
#include "pipeline/formats/toml/toml_writer.h"
#include "pipeline/plan/memory_limit.h"
#include "pipeline/plan/needs.h"
#include "pipeline/scene/settings_table.h"

// Scenes, their settings, the frame and its plan.

namespace web {

using pipeline::Errors;
using pipeline::Result;
using pipeline::Scene;

namespace {

Result<pipeline::NamedFile> fileOfPage(std::string_view name) {
    const auto found = core().files.find(name);
    if (found == core().files.end()) core().missing.insert(std::string(name));
    if (found == core().files.end())
        return pipeline::Error{{}, "\"" + std::string(name) + "\" is not in this page", {}};
    return pipeline::NamedFile{found->second, std::string(name)};
}

}  // namespace

Result<Scene> sceneFromText(std::string_view name, std::string_view text) {
    const std::string file(name);
    const std::size_t dot = file.rfind('.');
    const std::string extension = dot == std::string::npos ? std::string() : file.substr(dot);
    const pipeline::Format* format = pipeline::findFormat(text, extension);
    if (!format) return pipeline::Error{{file, 0, 0}, "found no scene", pipeline::knownFormats()};
    Result<Scene> read = format->read({text, file}, fileOfPage);
    if (!read) return read;
    Scene scene = std::move(read).value();
    if (scene.name.empty()) scene.name = pipeline::printableText(file.substr(file.rfind('/') + 1));
    scene.file = file;
    if (Errors errors = pipeline::checkSceneAndMemory(scene); !errors.empty()) return errors;
    return scene;
}

WEB_CALL(file) int webFile(const char* name, int nameSize, const char* text, int size) {
    core().files[std::string(textAt(name, nameSize))] = std::string(textAt(text, size));
    return give(true);
}

WEB_CALL(open) int webOpen(const char* name, int nameSize, const char* text, int size) {
    auto scene = sceneFromText(textAt(name, nameSize), textAt(text, size));
    if (!scene) return refuse(scene.errors());
    core() = LiveCore{.files = std::move(core().files), .missing = {}};
    take(std::move(scene).value());
    return give({{"name", core().own.scene->name}});
}

// The files that the scene names and the page has not given, since this was asked last: to give, and to open again.
WEB_CALL(missing) int webMissing() {
    Json list = Json::array();
    for (const std::string& name : std::exchange(core().missing, {})) list.push_back(name);
    return give(list);
}

// "KEY=VALUE", or several with "; " between them: the scene is checked once all of them hold.
WEB_CALL(set) int webSet(const char* text, int size) {
    auto scene = pipeline::withSettings(*core().own.scene, textAt(text, size));
    if (!scene) return refuse(scene.errors());
    if (const Errors errors = pipeline::checkSceneAndMemory(*scene); !errors.empty()) return refuse(errors);
    take(std::move(scene).value());
    return give(true);
}

// Buffers that the page shows beside those of its lesson: "color,n_dot_l.0"; "all": what the scene has a use for.
WEB_CALL(want) int webWant(const char* text, int size) {
    pipeline::BufferSet wanted;
    std::string_view rest = textAt(text, size);
    while (!rest.empty()) {
        const std::string_view name = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(rest.size(), name.size() + 1));
        if (name == "all") {
            wanted |= pipeline::usefulBuffers(*core().own.scene);
        } else if (name == "every") {
            wanted.set();
        } else {
            const auto found = pipeline::findAnyBuffer(name);
            if (!found) return refuse("no buffer \"" + std::string(name) + "\"; " + pipeline::insteadOfAnyBuffer(name));
            if (!isDerived(found->id))
                wanted.set(index(found->id));
            else if (const auto needed = buffersFor(*found, core().recipe, *core().own.scene))
                wanted |= *needed;  // else its picture says why
        }
    }
    if (const auto& open = core().lesson) wanted |= shownAlways() | readByPage(*open);
    core().wanted = wanted;
    return give(true);
}

WEB_CALL(frame) double webFrame(int fresh) {
    runOwn(fresh != 0);
    return core().own.frame->milliseconds();
}

WEB_CALL(plan) int webPlan() { return give(planToJson(*core().own.frame)); }

WEB_CALL(settings) int webSettings() {
    const Scene& scene = *core().own.scene;
    Json list = Json::array();
    for (const pipeline::SettingRef& ref : settingsOf(scene)) list.push_back(settingToJson(ref, scene));
    return give(list);
}

// What moves of them, in the same order: values, texts, why idle.
WEB_CALL(values) int webValues() {
    const Scene& scene = *core().own.scene;
    Json list = Json::array();
    for (const pipeline::SettingRef& ref : settingsOf(scene)) {
        const double value = ref.get(scene);
        list.push_back({value, formatSetting(ref, value), ref.setting->idle ? ref.setting->idle(scene) : ""});
    }
    return give(list);
}

// As TOML, to open in the program.
WEB_CALL(scene) int webScene() {
    auto text = pipeline::toTomlScene(*core().own.scene);
    if (!text) return refuse(text.errors());
    return giveText(std::move(text).value());
}

// A second scene beside the reader's, with one more setting, "shading=flat"; empty: none.
WEB_CALL(compare) int webCompare(const char* text, int size) {
    const std::string_view assignment = textAt(text, size);
    if (assignment.empty()) {
        core().other.reset();
        return give(true);
    }
    auto scene = pipeline::withSettings(*core().own.scene, assignment);
    if (!scene) return refuse(scene.errors());
    if (const Errors errors = pipeline::checkSceneAndMemory(*scene); !errors.empty()) return refuse(errors);
    ShownScene other;
    other.scene = std::make_shared<const Scene>(std::move(scene).value());
    pipeline::FrameRequest request;
    request.wanted = core().wanted, request.threads = 1;
    other.frame = runFrame(other.scene, request, core().other ? core().other->frame : core().own.frame);
    core().other = std::move(other);
    return give({{"milliseconds", core().other->frame->milliseconds()}});
}

}  // namespace web
