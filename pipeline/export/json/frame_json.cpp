#include "pipeline/export/json/frame_json.h"

#include "pipeline/scene/mesh/topology.h"

namespace pipeline {

Json errorsToJson(const Errors& errors) {
    Json list = Json::array();
    for (const Error& error : errors)
        list.push_back({{"file", error.where.file},
                        {"line", error.where.line},
                        {"column", error.where.column},
                        {"found", error.found},
                        {"expected", error.expected},
                        {"keys", error.keys},
                        {"text", format(error)}});
    return {{"errors", list}};
}

Json settingToJson(const SettingRef& ref, const Scene& scene) {
    static constexpr std::array<const char*, 4> kKinds{"number", "integer", "switch", "choice"};
    const Setting& row = *ref.setting;
    Json choices = Json::array();
    for (const std::string_view choice : row.choices) choices.push_back(choice);
    const double value = ref.get(scene);
    return {{"key", ref.key()},
            {"label", row.label},
            {"unit", row.unit},
            {"meaning", row.meaning},
            {"group", name(row.group)},
            {"index", row.key.find('#') == std::string_view::npos ? Json() : Json(ref.index)},
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

Json bufferToJson(const BufferName& name, std::string_view stage, std::string_view useless) {
    static constexpr std::array<const char*, 4> kDomains{"vertex", "polygon", "pixel", "texel"};
    const BufferInfo& info = bufferInfo(name.id);
    return {{"name", name.text()},       {"stage", stage},    {"domain", kDomains[std::size_t(info.domain)]},
            {"channels", info.channels}, {"unit", info.unit}, {"meaning", info.meaning},
            {"useless", useless}};
}

Json planToJson(const Frame& frame) {
    Json stages = toJson(frame.plan());
    std::size_t i = 0;
    for (const PlanStep& step : frame.plan()) {
        Json& stage = stages[i++];
        stage["label"] = stageInfo(step.stage).label;
        stage["milliseconds"] = frame.run(step.stage).milliseconds;
        stage["counts"] = frame.run(step.stage).counts;
    }
    return {{"stages", stages},
            {"number", frame.number()},
            {"milliseconds", frame.milliseconds()},
            {"remarks", remarksToJson(frame)}};
}

Json meshToJson(const Frame& frame) {
    const Topology& topology = frame.topology();
    Json polygons = Json::array(), objects = Json::array();
    for (std::size_t p = 0; p < topology.polygonCount(); ++p) {
        const auto corners = topology.corners(p);
        Json vertices = Json::array();
        for (std::size_t i = 0; i < corners.size(); ++i) vertices.push_back(corners[i]);
        polygons.push_back(std::move(vertices));
        objects.push_back(topology.objectOfPolygon(p));
    }
    return {{"polygons", polygons}, {"objects", objects}};
}

}  // namespace pipeline
