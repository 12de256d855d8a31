#include "pipeline/export/manifest.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/buffers/exporter.h"
#include "pipeline/export/buffers/png_file.h"
#include "pipeline/export/folder/contents.h"
#include "pipeline/export/folder/file_hash.h"
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
    if (!derived.elements().empty()) all["derived"] = std::move(derived);
    if (!at.empty()) all["at"] = at;
    const Json ofFrame{all["program"], all["scene"], all["settings"], at};
    all["frame"] = sha256Of(ofFrame.dump());
    return all;
}

namespace {

// Whatever is not as a manifest has it is passed over.
template <class Visit>
void forEach(const Json& json, const char* key, Visit visit) {
    if (json[key].is(Json::kArray)) std::ranges::for_each(json[key], visit);
}
Json* entryOf(Json& buffers, const std::string& name) {
    const auto found = std::ranges::find(buffers, name, [](const Json& one) { return one["name"].text(); });
    return found == end(buffers) ? nullptr : found;
}

constexpr std::array kBufferLists{"buffers", "derived"};

// Whether the hashes tell that a file has changed: not where it could not be read, and a .gltf has vertices in others.
bool tellsChanges(const Json& scene) {
    bool tells = true;
    forEach(scene, "objects", [&](const Json& object) {
        if (!object.find("file")) return;
        const std::string file = object["file"].text();
        tells = tells && object["sha256"].is(Json::kString) &&
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
        forEach(json, "files", [&](const Json& file) { add(file["file"].text()); });
    };
    if (manifest["program"]["name"] != "Shadescope") return {};
    for (const char* buffers : kBufferLists) forEach(manifest, buffers, addFiles);
    addFiles(manifest);
    forEach(manifest, "views", [&](const Json& view) { add(view.text()); });
    return {names.begin(), names.end()};
}

bool areOfOneFrame(const Json& a, const Json& b) {
    const std::string frame = a["frame"].text();
    return !frame.empty() && frame == b["frame"].text() && tellsChanges(b["scene"]);
}

void addEarlier(const Json& earlier, const std::vector<std::string>& staying, Json& manifest) {
    const auto stays = [&](const std::string& file) { return std::ranges::find(staying, file) != staying.end(); };
    const auto addFiles = [&](const Json& from, Json& to) {
        forEach(from, "files", [&](const Json& file) {
            if (stays(file["file"].text())) to.push_back(file);
        });
    };
    for (const char* list : kBufferLists)
        forEach(earlier, list, [&](const Json& buffer) {
            Json files = Json::array();
            addFiles(buffer, files);
            if (files.elements().empty()) return;
            Json* entry = manifest.find(list) ? entryOf(manifest[list], buffer["name"].text()) : nullptr;
            if (!entry) {
                entry = &manifest[list].push_back(buffer);
                (*entry)["files"] = Json::array();
            }
            for (Json& file : files) (*entry)["files"].push_back(std::move(file));
        });
    addFiles(earlier, manifest["files"]);
    forEach(earlier, "contents", [&](const Json& file) {
        if (stays(file["file"].text())) manifest["contents"].push_back(file);
    });
    forEach(earlier, "views", [&](const Json& view) {
        if (view.is(Json::kString) && stays(view.text())) manifest["views"].push_back(view);
    });
    Json absent = Json::array();
    for (const Json& one : manifest["absent"])
        if (!entryOf(manifest["buffers"], one["name"].text())) absent.push_back(one);
    manifest["absent"] = std::move(absent);
}

}  // namespace pipeline
