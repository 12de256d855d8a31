#include "app/headless/inspect.h"

#include <algorithm>
#include <array>
#include <span>

#include "app/headless/pixel_text.h"
#include "app/headless/read_buffers.h"
#include "app/headless/wanted_frame.h"
#include "lessons/expression/condition.h"
#include "pipeline/contracts/contract.h"
#include "pipeline/core/text.h"
#include "pipeline/export/json/algorithm_json.h"
#include "pipeline/export/json/contracts_json.h"
#include "pipeline/export/json/json.h"
#include "pipeline/export/json/table_json.h"
#include "pipeline/inspect/equation_text.h"
#include "pipeline/run/runner.h"
#include "pipeline/steps/steps.h"

namespace app {

namespace {

pipeline::FrameRequest requestFor(const InspectOptions& options, const CommandHost& host, pipeline::BufferSet wanted) {
    pipeline::FrameRequest request;
    request.wanted = wanted;
    request.threads = options.threads;
    request.stop = host.stop;
    return request;
}

pipeline::FramePtr frameOf(std::shared_ptr<const pipeline::Scene> scene, const InspectOptions& options,
                           const CommandHost& host, pipeline::BufferSet wanted = {}) {
    pipeline::FramePtr frame = runFrame(std::move(scene), requestFor(options, host, wanted), nullptr);
    if (frame) host.messages(remarksText(*frame));
    return frame;
}

// Says what the format should be, unless it is one of `known`.
bool knowsFormat(const InspectOptions& options, const CommandHost& host, std::span<const std::string_view> known,
                 const char* expected) {
    if (std::ranges::find(known, options.format) != known.end()) return true;
    host.tellErrors({{{}, fmt::format("--format is \"{}\"", options.format), expected}});
    return false;
}

int inspectTable(std::shared_ptr<const pipeline::Scene> scene, const InspectOptions& options, const CommandHost& host) {
    if (!knowsFormat(options, host, pipeline::kTableFormats, "text, csv, markdown, latex or numpy for a table"))
        return kWrongUsage;
    const auto id = pipeline::findTable(options.table);
    if (!id) return host.refuse({{{}, "no table " + pipeline::inQuotes(options.table), {}}}, kWrongUsage);
    const auto format = std::ranges::find(pipeline::kTableFormats, options.format);
    const pipeline::BufferSet shown = pipeline::tableBuffers(*scene, *id);
    const pipeline::FramePtr frame = frameOf(std::move(scene), options, host, shown);
    if (!frame) return host.cancelled();
    const pipeline::SceneTable table = sceneTable(frame, *id);
    const std::vector<std::uint32_t> rows = allRows(table);
    if (options.json)
        writeTableJson(table, rows, host.out);
    else
        writeTable(table, rows, pipeline::TableFormat(format - pipeline::kTableFormats.begin()), host.out);
    return kDone;
}

// The pixels that a condition holds for, in reading order: the first of them as text, all as JSON.
int printWhere(const std::shared_ptr<const pipeline::Scene>& scene, const InspectOptions& options,
               const CommandHost& host) {
    const auto condition = lessons::parseCondition(*options.where, {"--where", 1, 1}, {*scene});
    if (!condition) return host.refuse(condition.errors(), kWrongUsage);
    int status = kDone;
    if (!host.fits(*scene, requestFor(options, host, condition->buffers), status)) return status;
    const pipeline::FramePtr frame = frameOf(scene, options, host, condition->buffers);
    if (!frame) return host.cancelled();
    const auto mask = maskOf(*condition, {.frame = *frame, .stop = host.stop});
    if (host.stop.stop_requested()) return host.cancelled();
    if (!mask) return host.refuse(mask.errors(), kBadInput);
    constexpr std::size_t kShown = 20;
    const std::size_t most = options.json ? mask->count : std::min(mask->count, kShown);
    std::vector<glm::ivec2> pixels;
    std::optional<glm::ivec2> at;
    while (pixels.size() < most) pixels.push_back(*(at = nextHolding(*mask, at)));
    if (options.json) {
        pipeline::Json list = pipeline::Json::array();
        for (const glm::ivec2 pixel : pixels) list.push_back({pixel.x, pixel.y});
        const pipeline::Json all{
            {"condition", condition->text}, {"count", mask->count}, {"drawn", mask->drawn}, {"pixels", list}};
        host.say("{}\n", all.dump(2));
        return kDone;
    }
    host.say("{} of {} pixels where something was drawn\n", mask->count, mask->drawn);
    for (const glm::ivec2 pixel : pixels) host.say("{},{}\n", pixel.x, pixel.y);
    if (mask->count > most) host.say("and {} more; --json lists all\n", mask->count - most);
    return kDone;
}

int printRow(const std::shared_ptr<const pipeline::Scene>& scene, const InspectOptions& options,
             const CommandHost& host) {
    constexpr std::array<std::string_view, 3> kFormats{"text", "csv", "svg"};
    const auto formats = std::span(kFormats).first(options.plot ? 3 : 2);
    if (!knowsFormat(options, host, formats, options.plot ? "csv or svg for a row" : "csv for a row"))
        return kWrongUsage;
    const int row = *options.row;
    if (row < 0 || row >= scene->settings.height)
        return host.refuse(
            {{{}, fmt::format("--row is {}", row), fmt::format("a row from 0 to {}", scene->settings.height - 1)}},
            kWrongUsage);
    const pipeline::FramePtr frame = frameOf(scene, options, host, pipeline::sectionBuffers());
    if (!frame) return host.cancelled();
    const auto section = shadedSection(frame, row, options.threads, host.stop);
    if (!section) return host.cancelled();
    if (options.json)
        host.say("{}\n", toJson(*section).dump(2));
    else if (options.format == "svg")
        host.out(options.plot(*section));
    else
        host.out(sectionCsv(*section));
    return kDone;
}

// What must hold of every stage's output, and how often it does.
int printContracts(const std::shared_ptr<const pipeline::Scene>& scene, const InspectOptions& options,
                   const CommandHost& host) {
    const pipeline::FramePtr frame = frameOf(scene, options, host, pipeline::contractBuffers());
    if (!frame || !readBuffers(*frame, {}, host.stop)) return host.cancelled();
    const pipeline::ContractInput input = contractInput(*frame);
    const auto results = checkContracts(input, pipeline::Stop(host.stop));
    if (host.stop.stop_requested()) return host.cancelled();
    if (options.json)
        host.say("{}\n", toJson(results, input, true).dump(2));
    else
        host.out(contractsText(results, input));
    const bool hold = std::ranges::all_of(results, [](const auto& result) { return result.holds(); });
    return hold ? kDone : kAnswerIsNo;
}

// The algorithm of the stage that the place is in, with the line and the values there.
int printStep(const std::shared_ptr<const pipeline::Scene>& scene, const InspectOptions& options,
              const CommandHost& host) {
    if (!knowsFormat(options, host, pipeline::kAlgorithmFormats, "text or latex for a step")) return kWrongUsage;
    const auto place = pipeline::parsePlace(options.step, *scene);
    if (!place) return host.refuse(place.errors(), kWrongUsage);
    const pipeline::FramePtr frame = frameOf(scene, options, host);
    if (!frame) return host.cancelled();
    const pipeline::Steps steps(frame);
    const pipeline::Moment moment = steps.momentOf(*place);
    if (!steps.comesTo(*place))
        host.tell("{} is not a step of this scene: showing {}\n", options.step, text(steps.placeOf(moment)));
    const auto state = steps.algorithmAt(moment);
    const std::string there = text(steps.placeOf(moment));
    if (!state) {
        host.tell("The stage of {} has no algorithm.\n", there);
        return kDone;
    }
    if (options.json) {
        pipeline::Json json{{"place", there}, {"words", steps.words(moment, pipeline::StepLevel::Line)}};
        update(json, toJson(*state));
        host.say("{}\n", json.dump(2));
        return kDone;
    }
    const auto format = std::ranges::find(pipeline::kAlgorithmFormats, options.format);
    host.out(algorithmText(*state, pipeline::AlgorithmFormat(format - pipeline::kAlgorithmFormats.begin())));
    return kDone;
}

}  // namespace

int inspect(const std::shared_ptr<const pipeline::Scene>& scene, const InspectOptions& options,
            const CommandHost& host) {
    pipeline::BufferSet wanted;  // beside what a condition reads
    if (options.row) wanted = pipeline::sectionBuffers();
    if (options.contracts) wanted = pipeline::contractBuffers();
    if (int status = kDone; !host.fits(*scene, requestFor(options, host, wanted), status)) return status;
    if (!options.table.empty()) return inspectTable(scene, options, host);
    if (options.where) return printWhere(scene, options, host);
    if (options.contracts) return printContracts(scene, options, host);
    if (options.row) return printRow(scene, options, host);
    if (!options.step.empty()) return printStep(scene, options, host);
    const auto pixel = pixelIn(*scene, options.pixel);
    if (!pixel) return host.refuse(pixel.errors(), kWrongUsage);
    if (!knowsFormat(options, host, pipeline::kEquationFormats, "text, markdown or latex for a pixel"))
        return kWrongUsage;
    const auto format = std::ranges::find(pipeline::kEquationFormats, options.format);
    const pipeline::FramePtr frame = frameOf(scene, options, host);
    if (!frame) return host.cancelled();
    const pipeline::PixelReport report = inspectPixel(*frame, *pixel);
    if (format != pipeline::kEquationFormats.begin()) {  // text is all that is known
        if (!report.covered) host.tell("pixel {}, {} shows the background: it has no equation\n", pixel->x, pixel->y);
        for (int channel = 0; channel < 3; ++channel)
            host.out(equationText(equation(frame->scene(), report, channel),
                                  pipeline::EquationFormat(format - pipeline::kEquationFormats.begin())));
        return kDone;
    }
    if (options.json)
        host.say("{}\n", toJson(*frame, report).dump(2));
    else
        host.out(toText(*frame, report));
    return kDone;
}

}  // namespace app
