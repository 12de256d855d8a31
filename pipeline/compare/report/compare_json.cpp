#include <cmath>

#include "pipeline/compare/handed_in/convention_choices.h"
#include "pipeline/compare/report/compare_text.h"
#include "pipeline/core/version.h"

namespace pipeline::foreign {

namespace {

Json placeJson(const Finding& finding, std::size_t element) {
    if (!finding.isPicture()) return element;
    return Json::array({element % finding.columns, element / finding.columns});
}

Json valueJson(const Values& values, std::size_t element) {
    if (!values.there[element]) return nullptr;
    if (values.channels == 1) return values.at(element)[0];
    Json out = Json::array();
    for (int c = 0; c < values.channels; ++c) out.push_back(values.at(element)[c]);
    return out;
}

// What they have handed in: colours as the file holds them.
Json mineJson(const Report& report, const Finding& finding, std::size_t element) {
    const ReadFile& file = report.fileOf(finding);
    if (finding.name.buffer.id != BufferId::Color) return valueJson(file.mine, element);
    Json out = Json::array();
    for (const double v : numbersAt(*file.file, file.reading, element % finding.columns, element / finding.columns))
        out.push_back(std::isfinite(v) ? Json(v) : Json());
    return out;
}

Json bufferJson(const Report& report, const Finding& finding) {
    Json out;
    out["name"] = finding.name.text();
    out["file"] = finding.file;
    out["convention"] = readingText(finding.reading);
    out["text"] = findingText(finding);
    out["tolerance_text"] = toleranceText(finding);
    out["picture"] = finding.isPicture();
    out["compared"] = finding.compared;
    out["left_out"] = finding.count(Class::Left);
    for (const Class of :
         {Class::Equal, Class::Tolerated, Class::Allowed, Class::Wrong, Class::Missing, Class::Extra}) {
        std::string key(name(of));
        if (of == Class::Tolerated) key = "tolerated";
        out[key] = finding.count(of);
    }
    out["agrees"] = finding.agrees;
    out["max"] = finding.largest;
    out["rms"] = finding.rms;
    out["unit"] = finding.unit;
    out["tolerance"] = finding.tolerance;
    out["nan"] = finding.nan;
    out["infinite"] = finding.infinite;
    out["worst"] = finding.worst && report.options.hints >= 2 ? placeJson(finding, *finding.worst) : Json();
    return out;
}

Json candidateJson(const Candidate& one) {
    return {{"id", one.error.id},
            {"name", one.error.name},
            {"stage", one.error.stage ? Json(stageInfo(*one.error.stage).name) : Json("file")},
            {"explained", one.explained},
            {"left", one.left},
            {"rows_turned", one.otherRows},
            {"wrong", one.error.wrong},
            {"right", one.error.right},
            {"lesson", one.error.lesson},
            {"lesson_page", one.error.heading}};
}

}  // namespace

Json reportJson(const Report& report, int exitStatus) {
    Json out;
    out["version"] = programVersion();
    const Json scene = sceneToJson(*report.scene);
    out["scene"] = scene;
    out["size"] = {report.scene->settings.width, report.scene->settings.height};
    out["exit"] = exitStatus;
    out["headline"] = headline(report);
    out["evidence"] = evidence(report);
    const Finding* const first = report.firstDifference();
    Json wrong;
    if (report.options.hints >= 1 && !report.agrees()) {
        wrong["stage"] = report.firstWrong ? Json(stageInfo(*report.firstWrong).name) : Json();
        wrong["stages"] = Json::array();
        for (const StageId stage : report.possiblyWrong) wrong["stages"].push_back(stageInfo(stage).name);
        wrong["certain"] = report.isCertain;
        if (first && first->worst && report.options.hints >= 2) {
            wrong["buffer"] = first->name.text();
            wrong["place"] = placeJson(*first, *first->worst);
            wrong["mine"] = mineJson(report, *first, *first->worst);
            wrong["reference"] = valueJson(report.reference->values.at(first->name.buffer.text()), *first->worst);
        }
    }
    out["first_wrong"] = wrong;
    out["stages"] = Json::array();
    for (const StageVerdict& stage : report.stages) {
        Json buffers = Json::array();
        for (const std::size_t i : stage.findings) buffers.push_back(bufferJson(report, report.findings[i]));
        Json row{{"name", stageInfo(stage.stage).name}, {"label", stageInfo(stage.stage).label}};
        if (report.options.hints >= 1 || report.agrees())
            row["verdict"] = words(stage.standing), row["mark"] = mark(stage.standing, false);
        if (!stage.own.empty()) row["own"] = stage.own;
        row["buffers"] = buffers;
        out["stages"].push_back(row);
    }
    out["conventions"] = Json::array();
    for (const Convention& one : report.conventions.said)
        out["conventions"].push_back({{"buffer", one.buffer},
                                      {"key", one.key},
                                      {"value", one.value},
                                      {"own", one.own},
                                      {"certainty", certaintyText(one)},
                                      {"margin", std::isfinite(one.margin) ? Json(one.margin) : Json()}});
    out["choices"] = Json::array();
    for (const ConventionChoice& choice : conventionChoices(report))
        out["choices"].push_back({{"key", choice.key},
                                  {"value", choice.value},
                                  {"values", choice.values},
                                  {"certainty", choice.certainty},
                                  {"buffers", choice.buffers}});
    out["contracts"] = Json::array();
    for (const BrokenContract& one : report.broken)
        if (report.options.hints >= 2)
            out["contracts"].push_back({{"claim", one.claim},
                                        {"formula", one.formula},
                                        {"buffer", one.buffer},
                                        {"checked", one.checked},
                                        {"broken", one.broken},
                                        {"worst", one.worst}});
    out["likely"] = report.options.hints >= 3 ? namesText(report) : "";
    out["known"] = Json::array();
    out["together"] = false;  // whether the known errors are made at once; else they are alternatives
    out["experiment"] = nullptr;
    if (report.suspects && report.options.hints >= 3) {
        for (const Candidate& one : report.suspects->candidates) out["known"].push_back(candidateJson(one));
        out["together"] = report.suspects->areTogether;
        out["tried"] = report.suspects->tried, out["kind"] = report.suspects->kind;
        out["next"] = report.suspects->next ? candidateJson(*report.suspects->next) : Json();
        if (const auto& experiment = report.suspects->experiment) {
            Json values = Json::object(), between = Json::array();
            for (std::size_t i = 0; i < experiment->values.size(); ++i) {
                const std::string& id = report.suspects->candidates[i].error.id;
                between.push_back(id), values[id] = experiment->values[i];
            }
            out["experiment"] = {
                {"between", between}, {"buffer", experiment->buffer}, {"place", experiment->place}, {"values", values}};
        }
    }
    out["hints"] = hints(report);
    out["not_handed_in"] = report.notHandedIn();
    Json problems = Json::array();
    for (const std::string& other : report.in->others) problems.push_back(other);
    for (const Error& error : report.in->errors) problems.push_back(format(error));
    out["problems"] = problems;
    out["refused"] = report.in->errors.size();  // the last of the problems: files that were not compared
    return out;
}

}  // namespace pipeline::foreign
