#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/cli/arguments/derived_argument.h"
#include "app/cli/arguments/frame_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/headless/inspect.h"
#include "pipeline/core/text.h"
#include "pipeline/export/figure/plot_file.h"
#include "pipeline/export/json/json.h"
#include "pipeline/inspect/scene_tables.h"
#include "pipeline/inspect/table_text.h"
#include "pipeline/run/runner.h"
#include "pipeline/study/scanline_plot.h"
#include "pipeline/study/shadow_verdict.h"

namespace app {

namespace {

// Per light how many pixels are lit, shadowed, and wrong in either way.
int printShadows(const std::shared_ptr<const pipeline::Scene>& scene, const InspectOptions& options,
                 const CommandHost& host) {
    if (const pipeline::Errors none = noShadowVerdicts(*scene); !none.empty()) {
        printErrors(none);
        return kWrongUsage;
    }
    pipeline::FrameRequest request;
    request.wanted = pipeline::setOf({pipeline::BufferId::Shadow});
    request.threads = options.threads, request.stop = host.stop;
    if (int status = kDone; !host.fits(*scene, request, status)) return status;
    const pipeline::FramePtr frame = runFrame(scene, request, nullptr);
    if (!frame) return host.cancelled();
    tellRemarks(*frame);
    pipeline::Json lights = pipeline::Json::array();
    for (std::size_t k = 0; k < scene->lights.size(); ++k) {
        pipeline::Json light{{"light", k}};
        if (const std::string why = whyNoShadowVerdicts(*scene, k); !why.empty()) {
            light["why"] = why;
            if (!options.json) say("light {}: {}\n", k, why);
            lights.push_back(light);
            continue;
        }
        const auto exact = exactShadows(*scene, k, options.threads, host.stop);
        if (!exact) return host.cancelled();
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

}  // namespace

void declareInspect(CLI::App& program, const CliHost&, int& status) {
    struct Declared {
        SceneArgument scene;
        InspectOptions what;
        bool shadowVerdicts = false;
    };
    const auto declared = std::make_shared<Declared>();
    InspectOptions* const options = &declared->what;
    options->plot = [](const pipeline::ScanlineSection& section) {
        return plotSvg(layOut(pipeline::ScanlinePlot{&section}, {1200, 600, 16}), pipeline::PlotTheme::Light);
    };
    CLI::App* command = program.add_subcommand("inspect",
                                               "Print everything known about a pixel, its equation included, a table, "
                                               "a step's algorithm, or where a condition holds");
    declareSceneArgument(*command, declared->scene);
    CLI::Option_group* what = command->add_option_group("what");
    what->add_option("--pixel", options->pixel, "Column and row, from 0 at the top left")->type_name("X,Y");
    std::vector<std::string> tables;
    for (std::size_t i = 0; i < pipeline::kTableCount; ++i) tables.emplace_back(name(pipeline::TableId(i)));
    what->add_option("--table", options->table, "An array of the scene: " + CLI::detail::join(tables, ", "))
        ->type_name("TABLE")
        ->check(CLI::IsMember(tables));
    CLI::Option* where = what->add_option_function<std::string>(
                                 "--where", [options](const std::string& text) { options->where = text; },
                                 "The pixels that a condition holds for: \"n_dot_l.0 < 0.5\"")
                             ->type_name("CONDITION");
    CLI::Option* verdicts = what->add_flag("--shadow-verdicts", declared->shadowVerdicts,
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
    command->callback([declared, &status] {
        const Interrupt interrupt;
        const auto scene = loadScene(declared->scene, interrupt.token(), status);
        if (!scene) return;
        const CommandHost host = commandHost(declared->scene, interrupt.token());
        status = (declared->shadowVerdicts ? printShadows : inspect)(scene, declared->what, host);
    });
}

}  // namespace app
