#include "pipeline/export/json/json.h"

#include <cmath>
#include <map>

#include "pipeline/export/folder/file_hash.h"
#include "pipeline/plan/scene_remarks.h"
#include "pipeline/run/frame_remarks.h"
#include "pipeline/scene/settings_table.h"

namespace pipeline {

namespace {

Json lightToJson(const LightReport& light) {
    return {{"light", light.light},
            {"L", toJson(light.L)},
            {"R", toJson(light.R)},
            {"H", toJson(light.H)},
            {"n_dot_l", light.nDotL},
            {"r_dot_v", light.rDotV},
            {"n_dot_h", light.nDotH},
            {"specular_power", light.specularPower},
            {"shadow", light.shadow},
            {"fading", light.fading},
            {"ambient", toJson(light.ambient)},
            {"diffuse", toJson(light.diffuse)},
            {"specular", toJson(light.specular)},
            {"note", light.note}};
}

Json evaluationToJson(const Evaluation& evaluation) {
    Json lights = Json::array();
    for (const LightReport& light : evaluation.lights) lights.push_back(lightToJson(light));
    return {{"where", evaluation.where},
            {"weight", evaluation.weight},
            {"position", toJson(evaluation.position)},
            {"N", toJson(evaluation.N)},
            {"V", toJson(evaluation.V)},
            {"lights", lights},
            {"emission", toJson(evaluation.emission)},
            {"ambient", toJson(evaluation.ambient)},
            {"intensity", toJson(evaluation.intensity)},
            {"clamped", evaluation.clamped}};
}

Json placeToJson(const std::optional<SourceLocation>& place) {
    return place ? Json{{"file", place->file}, {"line", place->line}, {"column", place->column}} : Json();
}

Json vectorsToJson(const std::vector<Vec3d>& vectors) {
    Json array = Json::array();
    for (const Vec3d& vector : vectors) array.push_back(toJson(vector));
    return array;
}

}  // namespace

Json toJson(const std::vector<EquationLine>& lines) {
    Json array = Json::array();
    for (const EquationLine& line : lines)
        array.push_back({{"role", line.role},
                         {"text", toText(line.formula)},
                         {"latex", toLatex(line.formula)},
                         {"remark", line.remark}});
    return array;
}

Json toJson(const Vec3d& vector) { return {vector.x, vector.y, vector.z}; }

namespace {

Json ruleJson(std::optional<Rule> rule) { return rule ? Json(name(*rule)) : Json(); }

}  // namespace

Json toJson(const Plan& plan) {
    Json steps = Json::array();
    for (const PlanStep& step : plan) {
        Json parts = Json::array();
        for (const PlanPart& part : step.parts)
            parts.push_back({{"part", part.name},
                             {"action", name(part.action)},
                             {"why", part.why},
                             {"saves", part.saves},
                             {"rule", ruleJson(part.rule)}});
        steps.push_back({{"stage", stageInfo(step.stage).name},
                         {"action", name(step.action)},
                         {"why", step.why},
                         {"rule", ruleJson(step.rule)},
                         {"parts", parts}});
    }
    return steps;
}

Json toJson(const std::vector<Tally>& tallies) {
    Json json = Json::array();
    for (const Tally& tally : tallies)
        json.push_back(
            {{"what", tally.what}, {"done", tally.done}, {"left_out", tally.leftOut}, {"rule", ruleJson(tally.rule)}});
    return json;
}

Json settingsToJson(const Scene& scene) {
    Json settings = Json::object();
    for (const SettingRef& ref : settingsOf(scene)) {
        Json& value = settings.add(ref.key(), {});  // each key once: to look for it takes as long as there are keys
        switch (ref.setting->kind) {
            case SettingKind::Number: value = ref.get(scene); break;
            case SettingKind::Integer: value = static_cast<long>(ref.get(scene)); break;
            case SettingKind::Switch: value = ref.get(scene) != 0; break;
            case SettingKind::Choice: value = formatSetting(ref, ref.get(scene)); break;
        }
    }
    return settings;
}

Json sceneToJson(const Scene& scene) {
    std::map<std::string, Json> known;  // objects share files
    const auto hash = [&](const std::string& file) -> Json {
        const auto [at, isNew] = known.try_emplace(file);
        if (const auto found = isNew ? sha256(file) : std::nullopt) at->second = *found;
        return at->second;
    };
    Json objects = Json::array();
    const std::string folder = scene.file.substr(0, scene.file.rfind('/') + 1);  // empty where there is no slash
    for (const Object& object : scene.objects) {
        Json entry{{"name", object.name},
                   {"vertices", object.mesh->positions.size()},
                   {"polygons", object.mesh->polygonCount()}};
        if (!object.mesh->file.empty()) {
            entry["file"] = object.mesh->file;
            entry["sha256"] = hash((object.mesh->file.starts_with('/') ? "" : folder) + object.mesh->file);
        }
        objects.push_back(entry);
    }
    return {{"name", scene.name}, {"file", scene.file}, {"sha256", hash(scene.file)}, {"objects", objects}};
}

Json toJson(const Frame& frame, const PixelReport& report) {
    Json json{{"pixel", {report.pixel.x, report.pixel.y}},
              {"color", {report.color.r, report.color.g, report.color.b}},
              {"covered", report.covered},
              {"outline", report.outline}};
    Json fragments = Json::array(), culled = Json::array();
    for (const FragmentReport& fragment : report.fragments)
        fragments.push_back({{"polygon", fragment.polygon},
                             {"depth", fragment.depth},
                             {"stored", fragment.stored},
                             {"verdict", name(fragment.verdict)},
                             {"text", comparisonText(fragment).whole()},
                             {"shadows", fragment.shadows}});
    for (const CulledReport& polygon : report.culled)
        culled.push_back({{"polygon", polygon.polygon},
                          {"letter", std::string(1, polygon.letter)},
                          {"reason", polygon.reason},
                          {"signed_area", polygon.signedArea ? Json(*polygon.signedArea) : Json()}});
    if (report.covered) {
        Json evaluations = Json::array(), weights = Json::array();
        for (const auto& [vertex, weight] : report.weights) weights.push_back({{"vertex", vertex}, {"weight", weight}});
        for (const Evaluation& evaluation : report.evaluations) evaluations.push_back(evaluationToJson(evaluation));
        update(json, {{"object", report.object},
                      {"polygon", report.polygon},
                      {"defined_at", placeToJson(definedAt(frame, report.polygon))},
                      {"vertices", report.vertices},
                      {"barycentric", toJson(report.barycentric)},
                      {"interpolation", report.interpolation},
                      {"weights", weights},
                      {"position", toJson(report.position)},
                      {"z_view", report.zView},
                      {"depth", report.depth},
                      {"shadow", report.shadow},
                      {"shadow_places", report.shadowPlaces},
                      {"ambient", toJson(report.ambient)},
                      {"diffuse", vectorsToJson(report.diffuse)},
                      {"specular", vectorsToJson(report.specular)},
                      {"emission", toJson(report.emission)},
                      {"opaque", toJson(report.intensity)},
                      {"i_max", report.iMax},
                      {"evaluations", evaluations},
                      {"equation",
                       {{"r", toJson(equation(frame.scene(), report, 0))},
                        {"g", toJson(equation(frame.scene(), report, 1))},
                        {"b", toJson(equation(frame.scene(), report, 2))}}}});
    }
    Json layers = Json::array();
    for (const LayerReport& layer : report.layers)
        layers.push_back({{"polygon", layer.polygon},
                          {"z_view", layer.zView},
                          {"alpha", layer.alpha},
                          {"intensity", toJson(layer.intensity)},
                          {"composed", toJson(layer.composed)}});
    json["layers"] = layers;
    json["transmittance"] = report.transmittance;
    json["translucent"] = toJson(report.translucent);
    json["intensity"] = toJson(report.composed);
    if (report.antialiased) json["antialiased"] = toJson(*report.antialiased);
    json["fragments"] = fragments;
    json["culled"] = culled;
    return json;
}

Json toJson(const ScanlineSection& section) {
    Json runs = Json::array(), intensity = Json::object();
    for (const ScanlineRun& run : section.runs) {
        Json samples = Json::array();
        for (const ScanlineRun::Sample& sample : run.samples)
            samples.push_back({{"x", sample.x}, {"depth", sample.depth}, {"seen", sample.stays}});
        runs.push_back({{"polygon", run.polygon}, {"samples", samples}});
    }
    for (std::size_t i = 0; i < section.intensity.size(); ++i) {
        if (section.intensity[i].empty()) continue;
        Json& row = intensity[std::string(kSectionShadings[i])] = Json::array();
        for (const Vec3d& value : section.intensity[i]) row.push_back(std::isnan(value.x) ? Json() : toJson(value));
    }
    return {{"row", section.row}, {"width", section.width}, {"depth", section.storesDepth ? "depth" : "z_view"},
            {"runs", runs},       {"intensity", intensity}, {"i_max", section.iMax}};
}

namespace {

Json remarkToJson(const Remark& remark) { return {{"about", remark.about}, {"text", remark.text}}; }

}  // namespace

Json remarksToJson(const Scene& scene) {
    Json remarks = Json::array();
    for (const Remark& remark : sceneRemarks(scene)) remarks.push_back(remarkToJson(remark));
    return remarks;
}

Json remarksToJson(const Frame& frame) {
    Json remarks = Json::array();
    for (const Remark& remark : frameRemarks(frame)) remarks.push_back(remarkToJson(remark));
    return remarks;
}

}  // namespace pipeline
