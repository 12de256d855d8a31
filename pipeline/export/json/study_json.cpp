#include "pipeline/export/json/study_json.h"

#include <cmath>

namespace pipeline {

namespace {

Json finiteOrNull(std::optional<double> value) { return value && std::isfinite(*value) ? Json(*value) : Json(); }

Json errorsJson(const std::vector<ErrorRow>& rows) {
    Json json = Json::array();
    for (const ErrorRow& row : rows) {
        Json entry{
            {"buffer", row.buffer}, {"stage", stageInfo(row.stage).name}, {"measure", row.measure}, {"unit", row.unit}};
        for (std::size_t kind = 0; kind < kErrorKinds; ++kind)
            entry[std::string(name(static_cast<ErrorKind>(kind)))] = finiteOrNull(row.value[kind]);
        if (row.drawn) entry["drawn"] = {finiteOrNull(row.drawn->first), finiteOrNull(row.drawn->second)};
        json.push_back(std::move(entry));
    }
    return json;
}

Json pointJson(const StudyPoint& point) {
    Json blame = Json::array(), stages = Json::object(), counters = Json::object();
    for (const StageBlame& stage : point.blame)
        blame.push_back({{"stage", stageInfo(stage.stage).name},
                         {"error", finiteOrNull(stage.error)},
                         {"share", finiteOrNull(stage.share)}});
    for (const StageId stage : kStages)
        if (const TimeSamples& samples = point.stages[index(stage)]; !samples.processes.empty())
            stages[std::string(stageInfo(stage).name)] = samples.processes;
    for (const auto& [what, count] : point.counters) counters[what] = count;
    return {{"number", point.number},       {"values", point.values},          {"failure", point.failure},
            {"megabytes", point.megabytes}, {"counters", std::move(counters)}, {"errors", errorsJson(point.errors)},
            {"blame", std::move(blame)},    {"frame", point.frame.processes},  {"stages", std::move(stages)}};
}

Json headJson(const StudyReport& report) {
    Json axes = Json::array(), references = Json::array();
    for (const SweepAxis& axis : report.axes)
        axes.push_back({{"key", axis.key}, {"label", axis.label}, {"values", axis.values}});
    for (std::size_t kind = 0; kind < kErrorKinds; ++kind)
        references.push_back({{"kind", name(static_cast<ErrorKind>(kind))},
                              {"name", report.references[kind]},
                              {"why_none", report.whyNone[kind]}});
    return {
        {"format", "shadescope study"},
        {"format_version", 1},
        {"scene", report.scene},
        {"file", report.file},
        {"geometry", report.geometry},
        {"version", report.version},
        {"width", report.width},
        {"height", report.height},
        {"threads", report.threads},
        {"warmups", report.warmups},
        {"repeats", report.repeats},
        {"processes", report.processes},
        {"machine", report.machine},
        {"compiler", report.compiler},
        {"load", report.load},
        {"settings", report.settings},
        {"axes", std::move(axes)},
        {"choice",
         {{"buffer", report.choice.buffer}, {"measure", report.choice.measure}, {"kind", name(report.choice.kind)}}},
        {"references", std::move(references)},
        {"error_bars", errorsJson(report.errorBars)},
        {"error_why", report.errorWhy}};
}

}  // namespace

Json toJson(const StudyReport& report) {
    Json json = headJson(report), points = Json::array();
    for (const StudyPoint& point : report.points) points.push_back(pointJson(point));
    json["points"] = std::move(points);
    return json;
}

std::string studyFileText(const StudyReport& report, const Json& contents) {
    std::string text = "{\n";
    Json head = headJson(report);
    if (!contents.is(Json::kNull)) head["contents"] = contents;
    // Replacing what is not UTF-8: a file's name may hold any bytes.
    const auto dumped = [](const Json& json) { return json.dump(); };
    for (const auto& [key, value] : head.items()) text += dumped(Json(key)) + ": " + dumped(value) + ",\n";
    text += "\"points\": [";
    for (const StudyPoint& point : report.points) {
        if (text.back() != '[') text += ',';
        text += '\n' + dumped(pointJson(point));
    }
    return text + "\n]\n}\n";
}

}  // namespace pipeline
