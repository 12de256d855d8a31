#include "pipeline/export/json/algorithm_json.h"

#include <array>
#include <cmath>

namespace pipeline {
namespace {

// In the order of the enumerators.
constexpr std::array<const char*, 7> kStatus{"now", "passed", "next", "ahead", "not taken", "left out", "elsewhere"};

Json toJson(const AlgorithmValue& value) {
    Json numbers = Json::array();
    for (const double number : value.numbers) numbers.push_back(std::isfinite(number) ? Json(number) : Json());
    Json json{{"name", value.name}, {"shown", value.shown}, {"text", value.text}, {"numbers", numbers}};
    if (!value.from.empty()) json["from"] = value.from;
    if (value.range)
        json["range"] = {{"of", value.range->name},
                         {"first", value.range->first},
                         {"last", value.range->last},
                         {"at", value.range->at}};
    return json;
}

}  // namespace

Json toJson(const AlgorithmState& state) {
    const AlgorithmText& text = *state.walk.algorithm.row;
    Json json{{"algorithm", text.name}, {"title", text.title}, {"line", nullptr}, {"over", state.over}};
    if (state.visit) json["line"] = state.walk.visits[*state.visit].line + 1;
    Json lines = Json::array();
    for (const AlgorithmRow& row : rowsOf(state)) {
        Json values = Json::array();
        for (const AlgorithmValue& value : row.values) values.push_back(toJson(value));
        Json line{{"line", row.number}, {"indent", row.indent},
                  {"text", row.text},   {"status", kStatus[std::size_t(row.status)]},
                  {"values", values},   {"with_values", row.named}};
        if (row.taken) line["taken"] = *row.taken;
        if (!row.remark.empty()) line["remark"] = row.remark;
        lines.push_back(std::move(line));
    }
    json["lines"] = std::move(lines);
    json["left_out"] = state.leftOut();
    if (!text.note.empty()) json["note"] = text.note;
    return json;
}

}  // namespace pipeline
