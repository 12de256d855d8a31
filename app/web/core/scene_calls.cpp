#include "app/web/core/core.h"
#include "app/web/core/scene_text.h"
#include "pipeline/formats/format_table.h"
#include "pipeline/formats/text_scanner.h"
#include "pipeline/formats/toml_writer.h"
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
    if (found == core().files.end())
        return pipeline::Error{{}, "\"" + std::string(name) + "\" is not in this page", {}};
    return pipeline::NamedFile{found->second, std::string(name)};
}

Json settingJson(const pipeline::SettingRef& ref, const Scene& scene) {
    static constexpr std::array<const char*, 4> kKinds{"number", "integer", "switch", "choice"};
    const pipeline::Setting& row = *ref.setting;
    Json choices = Json::array();
    for (const std::string_view choice : row.choices) choices.push_back(choice);
    const double value = ref.get(scene);
    return {{"key", ref.key()},
            {"label", row.label},
            {"unit", row.unit},
            {"meaning", row.meaning},
            {"group", name(row.group)},
            {"index", ref.setting->key.find('#') == std::string_view::npos ? Json() : Json(ref.index)},
            {"kind", kKinds[std::size_t(row.kind)]},
            {"low", row.low},
            {"high", row.high},
            {"min", row.min},
            {"max", row.max},
            {"choices", choices},
            {"value", value},
            {"text", formatSetting(ref, value)},
            {"idle", row.idle ? row.idle(scene) : std::string_view()}};
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
    if (scene.name.empty()) scene.name = pipeline::printableText(file);
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
    core() = LiveCore{.files = std::move(core().files)};
    take(std::move(scene).value());
    return give({{"name", core().own.scene->name}});
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

WEB_CALL(plan) int webPlan() {
    const pipeline::Frame& frame = *core().own.frame;
    Json stages = toJson(frame.plan());
    std::size_t i = 0;
    for (Json& stage : stages) {
        const pipeline::StageId id = frame.plan()[i++].stage;
        stage["label"] = pipeline::stageInfo(id).label;
        stage["milliseconds"] = frame.run(id).milliseconds;
        stage["counts"] = frame.run(id).counts;
    }
    return give({{"stages", stages},
                 {"number", frame.number()},
                 {"milliseconds", frame.milliseconds()},
                 {"remarks", remarksToJson(frame)}});
}

WEB_CALL(settings) int webSettings() {
    const Scene& scene = *core().own.scene;
    Json list = Json::array();
    for (const pipeline::SettingRef& ref : settingsOf(scene)) list.push_back(settingJson(ref, scene));
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
