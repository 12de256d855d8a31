#include "app/web/core/core.h"
#include "pipeline/export/html/formula_mathml.h"
#include "pipeline/export/json/algorithm_json.h"
#include "pipeline/export/json/frame_json.h"

// Why a pixel has its colour; steps inside the frame; the mesh.

namespace web {

namespace {

Json lastStep(int level) {
    const ShownScene& own = core().own;
    const pipeline::Steps& steps = *own.steps;
    const pipeline::Moment at = own.moment;
    const auto pixel = steps.pixelOf(at);
    const auto progress = steps.progress(at);
    return {{"stage", pipeline::stageInfo(at.stage).name},
            {"label", pipeline::stageInfo(at.stage).label},
            {"done", at.done},
            {"of", steps.total(at.stage)},
            {"progress", {{"done", progress.done}, {"of", progress.of}, {"unit", progress.unit}}},
            {"words", steps.words(at, pipeline::StepLevel(level))},
            {"place", pipeline::text(steps.placeOf(at))},
            {"first", at == steps.first()},
            {"last", at == steps.last()},
            {"pixel", pixel ? Json{pixel->x, pixel->y} : Json()}};
}

}  // namespace

// As `inspect --json`, but of the equation one channel alone, its lines with the parts that they have as MathML.
WEB_CALL(inspect) int webInspect(int x, int y, int channel) {
    const pipeline::Frame& frame = core().own.now();
    const pipeline::Settings& settings = frame.scene().settings;
    if (x < 0 || y < 0 || x >= settings.width || y >= settings.height || channel < 0 || channel > 2)
        return refuse("no such pixel");
    const pipeline::PixelReport report = inspectPixel(frame, {x, y});
    Json json = toJson(frame, report);
    if (json.find("equation")) {
        const auto lines = equation(frame.scene(), report, channel);
        json["equation"] = toJson(lines);
        for (std::size_t i = 0; i < lines.size(); ++i) json["equation"][i]["mathml"] = mathmlParts(lines[i].formula);
    }
    return give(json);
}

// level: 0 stage, 1 object, 2 polygon, 3 scanline, 4 pixel, 5 line. way: 1 forth, −1 back, 0 to the place that the text
// names.
WEB_CALL(step) int webStep(int level, int way, const char* text, int size) {
    ShownScene& own = core().own;
    if (level < 0 || level >= int(pipeline::kStepLevelCount)) return refuse("no such level");
    if (!own.steps) {
        own.steps = std::make_unique<pipeline::Steps>(own.frame);
        own.moment = own.steps->last();
    }
    const auto stepLevel = pipeline::StepLevel(level);
    if (way == 0) {
        const auto place = pipeline::parsePlace(textAt(text, size), *own.scene);
        if (!place) return refuse(place.errors());
        own.moment = own.steps->fitting(own.steps->momentOf(*place));
    } else if (const auto to =
                   way > 0 ? own.steps->next(own.moment, stepLevel) : own.steps->previous(own.moment, stepLevel)) {
        own.moment = *to;
    }
    own.atMoment = own.moment == own.steps->last() ? nullptr : own.steps->frameAt(own.moment, 1);
    return give(lastStep(level));
}

// The algorithm of the stage, with its line and values at the step; at the end of the frame the text alone. stage: from 0.
WEB_CALL(algorithm) int webAlgorithm(int stage) {
    ShownScene& own = core().own;
    if (stage < 0 || stage >= int(pipeline::kStageCount)) return refuse("no such stage");
    if (!own.steps) {
        own.steps = std::make_unique<pipeline::Steps>(own.frame);
        own.moment = own.steps->last();
    }
    const auto state =
        own.steps->algorithmAt(own.atMoment ? own.moment : pipeline::Moment{pipeline::StageId(stage), 0});
    return state ? give(toJson(*state)) : give(nullptr);
}

WEB_CALL(mesh) int webMesh() { return give(meshToJson(*core().own.frame)); }

}  // namespace web
