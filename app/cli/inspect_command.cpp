#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/cli/commands.h"
#include "app/cli/derived_argument.h"
#include "app/cli/frame_argument.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/scene_argument.h"
#include "lessons/expression/condition.h"
#include "pipeline/contracts/contract.h"
#include "pipeline/core/text.h"
#include "pipeline/export/algorithm_json.h"
#include "pipeline/export/contracts_json.h"
#include "pipeline/export/json.h"
#include "pipeline/export/plot_file.h"
#include "pipeline/export/table_json.h"
#include "pipeline/inspect/equation_text.h"
#include "pipeline/run/runner.h"
#include "pipeline/steps/steps.h"
#include "pipeline/study/scanline_plot.h"
#include "pipeline/study/shadow_verdict.h"

namespace app {

namespace {

struct InspectOptions {
    std::stop_token stop{};  // asked for by Ctrl+C
    SceneArgument scene;
    std::string pixel, table, where, step;
    bool hasWhere = false;  // which may be empty by mistake
    std::string format = "text";
    std::optional<int> row;
    int threads = 0;
    bool json = false, shadowVerdicts = false, contracts = false;
};

pipeline::FrameRequest requestFor(const InspectOptions& options, pipeline::BufferSet wanted) {
    pipeline::FrameRequest request;
    request.wanted = wanted;
    request.threads = options.threads;
    request.stop = options.stop;
    return request;
}

pipeline::FramePtr frameOf(std::shared_ptr<const pipeline::Scene> scene, const InspectOptions& options,
                           pipeline::BufferSet wanted = {}) {
    pipeline::FramePtr frame = runFrame(std::move(scene), requestFor(options, wanted), nullptr);
    if (frame) tellRemarks(*frame);
    return frame;
}

int cancelled() {
    tell("Cancelled.\n");
    return kInterrupted;
}

// Says what the format should be, unless it is one of `known`.
bool knowsFormat(const InspectOptions& options, std::span<const std::string_view> known, const char* expected) {
    if (std::ranges::find(known, options.format) != known.end()) return true;
    printErrors({{{}, fmt::format("--format is \"{}\"", options.format), expected}});
    return false;
}

int inspectTable(std::shared_ptr<const pipeline::Scene> scene, const InspectOptions& options) {
    if (!knowsFormat(options, pipeline::kTableFormats, "text, csv, markdown, latex or numpy for a table"))
        return kWrongUsage;
    const auto id = pipeline::findTable(options.table).value();  // CLI11 has checked both words
    const auto format = std::ranges::find(pipeline::kTableFormats, options.format);
    const auto write = [](std::string_view text) { say("{}", text); };
    const pipeline::BufferSet shown = pipeline::tableBuffers(*scene, id);
    const pipeline::FramePtr frame = frameOf(std::move(scene), options, shown);
    if (!frame) return cancelled();
    const pipeline::SceneTable table = sceneTable(frame, id);
    const std::vector<std::uint32_t> rows = allRows(table);
    if (options.json)
        writeTableJson(table, rows, write);
    else
        writeTable(table, rows, pipeline::TableFormat(format - pipeline::kTableFormats.begin()), write);
    return kDone;
}

// The pixels that a condition holds for, in reading order: the first of them as text, all as JSON.
int printWhere(const std::shared_ptr<const pipeline::Scene>& scene, const InspectOptions& options) {
    const auto condition = lessons::parseCondition(options.where, {"--where", 1, 1}, {*scene});
    if (!condition) {
        printErrors(condition.errors());
        return kWrongUsage;
    }
    int status = kDone;
    if (!fits(*scene, requestFor(options, condition->buffers), options.scene, status)) return status;
    const pipeline::FramePtr frame = frameOf(scene, options, condition->buffers);
    if (!frame) return cancelled();
    const auto mask = maskOf(*condition, {.frame = *frame, .stop = options.stop});
    if (options.stop.stop_requested()) return cancelled();
    if (!mask) {
        printErrors(mask.errors());
        return kBadInput;
    }
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
        say("{}\n", all.dump(2));
        return kDone;
    }
    say("{} of {} pixels where something was drawn\n", mask->count, mask->drawn);
    for (const glm::ivec2 pixel : pixels) say("{},{}\n", pixel.x, pixel.y);
    if (mask->count > most) say("and {} more; --json lists all\n", mask->count - most);
    return kDone;
}

int printRow(const std::shared_ptr<const pipeline::Scene>& scene, const InspectOptions& options) {
    constexpr std::array<std::string_view, 3> kFormats{"text", "csv", "svg"};
    if (!knowsFormat(options, kFormats, "csv or svg for a row")) return kWrongUsage;
    const int row = *options.row;
    if (row < 0 || row >= scene->settings.height) {
        printErrors(
            {{{}, fmt::format("--row is {}", row), fmt::format("a row from 0 to {}", scene->settings.height - 1)}});
        return kWrongUsage;
    }
    const pipeline::FramePtr frame = frameOf(scene, options, pipeline::sectionBuffers());
    if (!frame) return cancelled();
    const auto section = shadedSection(frame, row, options.threads, options.stop);
    if (!section) return cancelled();
    if (options.json)
        say("{}\n", toJson(*section).dump(2));
    else if (options.format == "svg")
        say("{}", plotSvg(layOut(pipeline::ScanlinePlot{&*section}, {1200, 600, 16}), pipeline::PlotTheme::Light));
    else
        say("{}", sectionCsv(*section));
    return kDone;
}

// Per light how many pixels are lit, shadowed, and wrong in either way.
int printShadows(const std::shared_ptr<const pipeline::Scene>& scene, const InspectOptions& options) {
    if (const pipeline::Errors none = noShadowVerdicts(*scene); !none.empty()) {
        printErrors(none);
        return kWrongUsage;
    }
    const pipeline::FramePtr frame = frameOf(scene, options, pipeline::setOf({pipeline::BufferId::Shadow}));
    if (!frame) return cancelled();
    pipeline::Json lights = pipeline::Json::array();
    for (std::size_t k = 0; k < scene->lights.size(); ++k) {
        pipeline::Json light{{"light", k}};
        if (const std::string why = whyNoShadowVerdicts(*scene, k); !why.empty()) {
            light["why"] = why;
            if (!options.json) say("light {}: {}\n", k, why);
            lights.push_back(light);
            continue;
        }
        const auto exact = exactShadows(*scene, k, options.threads, options.stop);
        if (!exact) return cancelled();
        const auto verdicts = judgeShadows(*frame, *exact).value();
        light["judged"] = verdicts.judged();
        light["elsewhere"] = verdicts.elsewhere;
        if (!options.json)
            say("light {}: {} against exact rays\n", k, pipeline::plural(std::int64_t(verdicts.judged()), "pixel"));
        for (std::size_t v = 0; v < pipeline::kShadowVerdictCount; ++v) {
            const pipeline::ShadowVerdictInfo& info = pipeline::shadowVerdictTable()[v];
            light[std::string(info.name)] = verdicts.counts[v];
            if (options.json) continue;
            say("  {:<9}{:>8} {:>7.2f} %  {}\n", info.name, verdicts.counts[v],
                verdicts.percent(pipeline::ShadowVerdict(v)), info.meaning);
        }
        if (verdicts.elsewhere > 0 && !options.json)
            say("  {} at outlines, where the ray meets another object\n",
                pipeline::plural(std::int64_t(verdicts.elsewhere), "pixel"));
        lights.push_back(light);
    }
    if (options.json) say("{}\n", lights.dump(2));
    return kDone;
}

// What must hold of every stage's output, and how often it does.
int printContracts(const std::shared_ptr<const pipeline::Scene>& scene, const InspectOptions& options) {
    const pipeline::FramePtr frame = frameOf(scene, options, pipeline::contractBuffers());
    if (!frame) return cancelled();
    const pipeline::ContractInput input = contractInput(*frame);
    const auto results = checkContracts(input, pipeline::Stop(options.stop));
    if (options.stop.stop_requested()) return cancelled();
    if (options.json)
        say("{}\n", toJson(results, input, true).dump(2));
    else
        say("{}", contractsText(results, input));
    const bool hold = std::ranges::all_of(results, [](const auto& result) { return result.holds(); });
    return hold ? kDone : kAnswerIsNo;
}

// The algorithm of the stage that the place is in, with the line and the values there.
int printStep(const std::shared_ptr<const pipeline::Scene>& scene, const InspectOptions& options) {
    if (!knowsFormat(options, pipeline::kAlgorithmFormats, "text or latex for a step")) return kWrongUsage;
    const auto place = pipeline::parsePlace(options.step, *scene);
    if (!place) {
        printErrors(place.errors());
        return kWrongUsage;
    }
    const pipeline::FramePtr frame = frameOf(scene, options);
    if (!frame) return cancelled();
    const pipeline::Steps steps(frame);
    const pipeline::Moment moment = steps.momentOf(*place);
    if (!steps.comesTo(*place))
        tell("{} is not a step of this scene: showing {}\n", options.step, text(steps.placeOf(moment)));
    const auto state = steps.algorithmAt(moment);
    const std::string there = text(steps.placeOf(moment));
    if (!state) {
        tell("The stage of {} has no algorithm.\n", there);
        return kDone;
    }
    if (options.json) {
        pipeline::Json json{{"place", there}, {"words", steps.words(moment, pipeline::StepLevel::Line)}};
        update(json, toJson(*state));
        say("{}\n", json.dump(2));
        return kDone;
    }
    const auto format = std::ranges::find(pipeline::kAlgorithmFormats, options.format);
    say("{}", algorithmText(*state, pipeline::AlgorithmFormat(format - pipeline::kAlgorithmFormats.begin())));
    return kDone;
}

int runInspect(InspectOptions options) {
    const Interrupt interrupt;
    options.stop = interrupt.token();
    int status = kDone;
    const auto scene = loadScene(options.scene, interrupt.token(), status);
    if (!scene) return status;
    pipeline::BufferSet wanted;  // beside what a condition reads
    if (options.row) wanted = pipeline::sectionBuffers();
    if (options.shadowVerdicts) wanted = pipeline::setOf({pipeline::BufferId::Shadow});
    if (options.contracts) wanted = pipeline::contractBuffers();
    if (!fits(*scene, requestFor(options, wanted), options.scene, status)) return status;
    if (!options.table.empty()) return inspectTable(scene, options);
    if (options.hasWhere) return printWhere(scene, options);
    if (options.shadowVerdicts) return printShadows(scene, options);
    if (options.contracts) return printContracts(scene, options);
    if (options.row) return printRow(scene, options);
    if (!options.step.empty()) return printStep(scene, options);
    const auto pixel = pixelIn(*scene, options.pixel);
    if (!pixel) return kWrongUsage;
    if (!knowsFormat(options, pipeline::kEquationFormats, "text, markdown or latex for a pixel")) return kWrongUsage;
    const auto format = std::ranges::find(pipeline::kEquationFormats, options.format);
    const pipeline::FramePtr frame = frameOf(scene, options);
    if (!frame) return cancelled();
    const pipeline::PixelReport report = inspectPixel(*frame, *pixel);
    if (format != pipeline::kEquationFormats.begin()) {  // text is all that is known
        if (!report.covered) tell("pixel {}, {} shows the background: it has no equation\n", pixel->x, pixel->y);
        for (int channel = 0; channel < 3; ++channel)
            say("{}", equationText(equation(frame->scene(), report, channel),
                                   pipeline::EquationFormat(format - pipeline::kEquationFormats.begin())));
        return kDone;
    }
    if (options.json)
        say("{}\n", toJson(*frame, report).dump(2));
    else
        say("{}", toText(*frame, report));
    return kDone;
}

}  // namespace

void declareInspect(CLI::App& program, const CliHost&, int& status) {
    const auto options = std::make_shared<InspectOptions>();
    CLI::App* command = program.add_subcommand("inspect",
                                               "Print everything known about a pixel, its equation included, a table, "
                                               "a step's algorithm, or where a condition holds");
    declareSceneArgument(*command, options->scene);
    CLI::Option_group* what = command->add_option_group("what");
    what->add_option("--pixel", options->pixel, "Column and row, from 0 at the top left")->type_name("X,Y");
    std::vector<std::string> tables;
    for (std::size_t i = 0; i < pipeline::kTableCount; ++i) tables.emplace_back(name(pipeline::TableId(i)));
    what->add_option("--table", options->table, "An array of the scene: " + CLI::detail::join(tables, ", "))
        ->type_name("TABLE")
        ->check(CLI::IsMember(tables));
    CLI::Option* where =
        what->add_option("--where", options->where, "The pixels that a condition holds for: \"n_dot_l.0 < 0.5\"")
            ->type_name("CONDITION");
    CLI::Option* verdicts = what->add_flag("--shadow-verdicts", options->shadowVerdicts,
                                           "Per light the pixels lit, shadowed, acne and leak, against exact rays");
    CLI::Option* contracts = what->add_flag("--contracts", options->contracts,
                                            "What must hold of every stage's output, how often it does, and where not");
    what->add_option("--row", options->row, "The section along a row: depths and intensities, as CSV, SVG or JSON")
        ->type_name("Y");
    what->add_option(
            "--step", options->step,
            "The algorithm of a stage at a step, with its line and values: z-buffer/polygon=1/row=270/x=250/line=5")
        ->type_name("PLACE");
    what->require_option(1);
    std::vector<std::string> formats(pipeline::kTableFormats.begin(), pipeline::kTableFormats.end());
    formats.emplace_back("svg");
    CLI::Option* format =
        command
            ->add_option("--format", options->format,
                         "Of a table text, csv, markdown, latex or numpy; of a pixel its equation alone, "
                         "markdown or latex; of a row csv or svg; of a step text or latex")
            ->type_name("FORMAT")
            ->check(CLI::IsMember(formats));
    declareThreads(*command, options->threads);
    format->excludes(where)->excludes(verdicts)->excludes(contracts);
    command->add_flag("--json", options->json, "Print JSON")->excludes(format);
    command->callback([options, where, &status] {
        options->hasWhere = where->count() > 0;
        status = runInspect(*options);
    });
}

}  // namespace app
