#include "pipeline/check/readings.h"

#include <fmt/format.h>

#include "pipeline/check/scenes.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/lecture/lecture_formats.h"
#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/scene/settings_table.h"

namespace pipeline::check {
namespace {

Result<NamedFile> noFile(std::string_view name) {
    return Error{{}, fmt::format("{}: no such file", inQuotes(name)), {}};
}

// Texts that are read without an error, or with one that does not say where.
double notRefused(Trial& trial, const std::vector<Text>& texts, std::string& first) {
    double count = 0;
    for (const Text& t : texts) {
        const Reading reading = read(t.name, t.text);
        const bool placed = !reading.errors.empty() && !reading.errors[0].where.file.empty() &&
                            (!t.placed || (reading.errors[0].where.line > 0 && reading.errors[0].where.column > 0));
        count += !placed;
        if (!placed && !reading.errors.empty())
            trial.demand(false, fmt::format("no place in {}", format(reading.errors[0])));
        if (placed && t.placed && first.empty())
            first = fmt::format("{}:{} refused", reading.errors[0].where.line, reading.errors[0].where.column);
    }
    return count;
}

}  // namespace

Reading read(const std::string& name, const std::string& text) {
    const SourceText source{text, name};
    const std::string ending = name.substr(name.rfind('.'));
    if (ending == ".des") {
        Reading reading;
        ObjectDescription object = readObjectDescription(source, reading.errors);
        if (reading.errors.empty())
            reading.objects.push_back(objectOf(makeMesh(std::move(object.mesh)), object.material));
        return reading;
    }
    if (ending == ".scene" || ending == ".toml") {
        const Result<Scene> scene =
            ending == ".toml" ? readTomlScene(source, noFile) : readLectureScene(source, noFile);
        if (!scene) return {scene.errors(), {}};
        return {{}, scene->objects};
    }
    const Result<LoadedModel> model = readModel(source, ending, noFile);
    if (!model) return {model.errors(), {}};
    return {{}, model->objects};
}

Finding refusing(Trial& trial, double naive, const std::vector<Text>& texts, std::string naiveText) {
    std::string first;
    const double ours = notRefused(trial, texts, first);
    return {naive, ours, std::move(naiveText), ours == 0 ? first : std::string()};
}

}  // namespace pipeline::check
