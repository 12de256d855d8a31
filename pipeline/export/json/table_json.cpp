#include "pipeline/export/json/table_json.h"

#include <fmt/format.h>

#include <cmath>
#include <type_traits>

#include "pipeline/export/json/json_value.h"

namespace pipeline {
namespace {

std::string textOf(const Json& json) { return json.dump(); }

// A float keeps its own few digits: as a double it would get those of its error.
std::string textOf(const Cell& cell) {
    if (std::holds_alternative<std::monostate>(cell)) return "null";
    if (const auto* words = std::get_if<std::string>(&cell)) return textOf(Json(*words));
    const bool isFinite = std::visit(
        [](const auto& value) {
            if constexpr (std::is_floating_point_v<std::decay_t<decltype(value)>>) return std::isfinite(value);
            return true;
        },
        cell);
    return isFinite ? exactText(cell) : "null";
}

}  // namespace

void writeTableJson(const SceneTable& table, std::span<const std::uint32_t> rows, const TextSink& sink) {
    sink(fmt::format("{{\n\"table\": \"{}\",\n\"meaning\": {},\n\"facts\": [", name(table.id),
                     textOf(Json(table.meaning))));
    const char* between = "\n";
    for (const TableFact& fact : table.facts) {
        std::string text = textOf(Json{{"lecture", fact.lecture}, {"name", fact.name}, {"unit", fact.unit}});
        text.back() = ',';  // the value goes on where the object closed
        sink(fmt::format("{}{}\"value\":{}}}", between, text, textOf(fact.value)));
        between = ",\n";
    }
    sink("\n],\n\"columns\": [");
    between = "\n";
    for (const TableColumn& column : table.columns) {
        sink(fmt::format("{}{}", between,
                         textOf(Json{{"lecture", column.lecture},
                                     {"name", column.name},
                                     {"unit", column.unit},
                                     {"meaning", column.meaning},
                                     {"why_empty", column.whyEmpty}})));
        between = ",\n";
    }
    sink("\n],\n\"rows\": [");
    between = "\n";
    for (const std::uint32_t row : rows) {
        std::string line = between;
        for (std::size_t c = 0; c < table.columns.size(); ++c)
            line.append(c == 0 ? "[" : ",").append(textOf(table.columns[c].cell(row)));
        sink(line.append("]"));
        between = ",\n";
    }
    sink("\n]\n}\n");
}

}  // namespace pipeline
