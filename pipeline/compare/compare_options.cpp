#include "pipeline/compare/compare_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/core/text.h"
#include "pipeline/formats/text/text_scanner.h"

namespace pipeline::foreign {

std::optional<std::string> readTolerance(const std::string& text, std::map<std::string, double>& into) {
    const auto equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const auto value = equals == text.npos ? std::nullopt : parseNumber(std::string_view(text).substr(equals + 1));
    if (!value || *value < 0) return fmt::format("--tolerance is {}, expected BUFFER=NUMBER", inQuotes(text));
    const std::string buffer = name == "depth" ? "z_view" : name;
    std::vector<std::string> names;
    for (const Tolerance& row : toleranceTable()) {
        names.emplace_back(bufferInfo(row.buffer).name);
        if (names.back() == buffer) {
            into[buffer] = *value;
            return {};
        }
    }
    return fmt::format("--tolerance: no buffer is called {}; the nearest name is {}", inQuotes(name),
                       nearest(name, names));
}

std::optional<std::string> readUntil(const std::string& text, StageId& until) {
    if (const auto stage = findStage(text)) {
        until = *stage;
        return {};
    }
    std::string names;
    for (const StageId stage : kStages) names += (names.empty() ? "" : ", ") + std::string(stageInfo(stage).name);
    return fmt::format("--stage: no stage is called {}; the stages are {}", inQuotes(text), names);
}

std::optional<std::string> readWithout(const std::string& id, const Scene& scene, std::vector<std::string>& into) {
    std::vector<std::string> ids;
    for (const KnownError& error : knownErrors(scene)) ids.push_back(error.id);
    if (std::ranges::find(ids, id) == ids.end())
        return fmt::format("--without: no known error of this scene is called {}; the nearest is {}", inQuotes(id),
                           nearest(id, ids));
    into.push_back(id);
    return {};
}

int exitStatus(const Report& report) {
    if (!report.agrees() || (report.options.strict && report.conventionsDiffer())) return 1;
    return report.in->errors.empty() ? 0 : 3;
}

}  // namespace pipeline::foreign
