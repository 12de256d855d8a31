#include "pipeline/export/manifest.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/contents.h"
#include "pipeline/export/exporter.h"
#include "pipeline/export/file_hash.h"
#include "pipeline/export/png_file.h"
#include "pipeline/stages/cull.h"

namespace pipeline {

namespace {

Json runTimes(const Frame& frame) {
    Json stages = Json::array();
    for (const StageId stage : kStages) {
        const StageRun& run = frame.run(stage);
        stages.push_back({{"stage", stageInfo(stage).name},
                          {"milliseconds", run.milliseconds},
                          {"counts", run.counts},
                          {"tallies", toJson(run.tallies)}});
    }
    return stages;
}

Json verdicts() {
    Json codes = Json::array();
    for (std::size_t code = 0; code < kVerdictCount; ++code) {
        const auto verdict = static_cast<Verdict>(code);
        codes.push_back({{"code", code}, {"letter", std::string(1, letter(verdict))}, {"verdict", name(verdict)}});
    }
    return codes;
}

Json describe(const WrittenBuffer& written) {
    const AnyBuffer& buffer = written.item.buffer;
    const BufferInfo& info = *buffer.info;
    const BufferStatistics& found = written.item.found;
    Json files = Json::array();
    for (const WrittenFile& file : written.files) {
        Json entry{{"file", file.file}, {"format", file.exporter->name}, {"bytes", file.bytes}};
        if (file.exporter->usesPalette) {
            entry["palette"] = paletteName(info.palette);
            entry["range"] = {written.item.range.first, written.item.range.last};
        }
        files.push_back(entry);
    }
    Json entry{{"name", buffer.name.text()},
               {"stage", isDerived(info.id) ? Json() : Json(stageInfo(info.stage).name)},
               {"meaning", written.meaning.empty() ? std::string(info.meaning) : written.meaning},
               {"shape", buffer.shape},
               {"dtype", buffer.dtype()},
               {"unit", info.unit},
               {"space", info.space},
               {"minimum", found.finite > 0 ? Json(found.min) : Json()},
               {"maximum", found.finite > 0 ? Json(found.max) : Json()},
               {"non_finite", found.nan + found.infinite},
               {"nan", found.nan},
               {"files", files}};
    if (!info.withoutValue.empty())
        entry["without_value"] = {{"count", found.withoutValue}, {"what", info.withoutValue}};
    return entry;
}

Json absent(const Frame& frame, const std::vector<BufferName>& asked) {
    Json buffers = Json::array();
    for (const BufferName& buffer : asked) {
        if (isDerived(buffer.id) || frame.buffer(buffer)) continue;
        buffers.push_back({{"name", buffer.text()},
                           {"stage", stageInfo(bufferInfo(buffer.id).stage).name},
                           {"why", frame.whyAbsent(buffer)}});
    }
    return buffers;
}

}  // namespace

Json manifest(const Frame& frame, const std::vector<BufferName>& asked, const std::vector<WrittenBuffer>& buffers,
              const std::vector<WrittenScene>& whole, const std::vector<std::string>& views, const std::string& at) {
    Json files = Json::array();
    for (const WrittenScene& file : whole)
        files.push_back({{"file", file.file}, {"format", file.exporter->name}, {"bytes", file.bytes}});
    Json described = Json::array();
    Json derived = Json::array();
    for (const WrittenBuffer& buffer : buffers)
        (isDerived(buffer.item.buffer.name.id) ? derived : described).push_back(describe(buffer));
    Json all{{"program", programMark()},
             {"scene", sceneToJson(frame.scene())},
             {"settings", settingsToJson(frame.scene())},
             {"remarks", remarksToJson(frame)},
             {"until", stageInfo(frame.until()).name},
             {"plan", toJson(frame.plan())},
             {"milliseconds", frame.milliseconds()},
             {"stages", runTimes(frame)},
             {"verdicts", verdicts()},
             {"buffers", described},
             {"absent", absent(frame, asked)},
             {"files", files},
             {"views", views}};
    if (!derived.empty()) all["derived"] = std::move(derived);
    if (!at.empty()) all["at"] = at;
    const Json ofFrame{all["program"], all["scene"], all["settings"], at};
    all["frame"] = sha256Of(ofFrame.dump(-1, ' ', false, Json::error_handler_t::replace));
    return all;
}

namespace {

// Whatever is not as a manifest has it is passed over.
template <class Visit>
void forEach(const Json& json, const char* key, Visit visit) {
    if (json.is_object() && json.contains(key) && json[key].is_array()) std::ranges::for_each(json[key], visit);
}
std::string textAt(const Json& json, const char* key) {
    return json.is_object() && json.contains(key) && json[key].is_string() ? json[key].get<std::string>()
                                                                           : std::string();
}
Json* entryOf(Json& buffers, const std::string& name) {
    const auto found = std::ranges::find(buffers, name, [](const Json& one) { return textAt(one, "name"); });
    return found == buffers.end() ? nullptr : &*found;
}

constexpr std::array kBufferLists{"buffers", "derived"};

// Whether the hashes tell that a file has changed: not where it could not be read, and a .gltf has vertices in others.
bool tellsChanges(const Json& scene) {
    bool tells = true;
    forEach(scene, "objects", [&](const Json& object) {
        if (!object.is_object() || !object.contains("file")) return;
        const std::string file = textAt(object, "file");
        tells = tells && object.value("sha256", Json()).is_string() &&
                !sameLetters(file.substr(file.find_last_of('.') + 1), "gltf");
    });
    return tells;
}

}  // namespace

bool isWritten(std::string_view name) {
    const auto ends = [&](std::string_view ending) { return name.size() > ending.size() && name.ends_with(ending); };
    return ends(".png") ||  // views
           std::ranges::any_of(exporterTable(), [&](const Exporter& e) { return ends('.' + std::string(e.name)); }) ||
           std::ranges::any_of(frameExporterTable(), [&](const FrameExporter& e) { return ends(e.ending); });
}

std::vector<std::string> filesNamedBy(const Json& manifest) {
    std::set<std::string> names;
    const auto add = [&](const std::string& name) {
        const std::filesystem::path file = name;
        if (file.has_filename() && file == file.filename() && isWritten(name)) names.insert(name);
    };
    const auto addFiles = [&](const Json& json) {
        forEach(json, "files", [&](const Json& file) { add(textAt(file, "file")); });
    };
    const Json::json_pointer program("/program/name");
    if (!manifest.contains(program) || manifest[program] != "Shadescope") return {};
    for (const char* buffers : kBufferLists) forEach(manifest, buffers, addFiles);
    addFiles(manifest);
    forEach(manifest, "views", [&](const Json& view) { add(view.is_string() ? view.get<std::string>() : ""); });
    return {names.begin(), names.end()};
}

bool areOfOneFrame(const Json& a, const Json& b) {
    const std::string frame = textAt(a, "frame");
    return !frame.empty() && frame == textAt(b, "frame") && tellsChanges(b.at("scene"));
}

void addEarlier(const Json& earlier, const std::vector<std::string>& staying, Json& manifest) {
    const auto stays = [&](const std::string& file) { return std::ranges::find(staying, file) != staying.end(); };
    const auto addFiles = [&](const Json& from, Json& to) {
        forEach(from, "files", [&](const Json& file) {
            if (stays(textAt(file, "file"))) to.push_back(file);
        });
    };
    for (const char* list : kBufferLists)
        forEach(earlier, list, [&](const Json& buffer) {
            Json files = Json::array();
            addFiles(buffer, files);
            if (files.empty()) return;
            Json* entry = manifest.contains(list) ? entryOf(manifest[list], textAt(buffer, "name")) : nullptr;
            if (!entry) {
                entry = &manifest[list].emplace_back(buffer);
                (*entry)["files"] = Json::array();
            }
            for (Json& file : files) (*entry)["files"].push_back(std::move(file));
        });
    addFiles(earlier, manifest["files"]);
    forEach(earlier, "contents", [&](const Json& file) {
        if (stays(textAt(file, "file"))) manifest["contents"].push_back(file);
    });
    forEach(earlier, "views", [&](const Json& view) {
        if (view.is_string() && stays(view.get<std::string>())) manifest["views"].push_back(view);
    });
    std::erase_if(manifest["absent"].get_ref<Json::array_t&>(),
                  [&](const Json& one) { return entryOf(manifest["buffers"], textAt(one, "name")) != nullptr; });
}

}  // namespace pipeline
