#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/cli/commands.h"
#include "app/cli/derived_argument.h"
#include "app/cli/frame_argument.h"
#include "app/cli/interrupt.h"
#include "app/cli/live_argument.h"
#include "app/cli/message.h"
#include "app/cli/output_argument.h"
#include "app/cli/scene_argument.h"
#include "lessons/state/cue_list.h"
#include "pipeline/core/text.h"
#include "pipeline/export/export_frame.h"
#include "pipeline/export/exporter.h"
#include "pipeline/export/size_text.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/plan/needs.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/key_places.h"
#include "pipeline/steps/steps.h"

namespace app {

namespace {

struct ExportOptions {
    SceneArgument scene;
    FrameArgument frame;
    DerivedArgument derived;
    std::string folder;
    std::vector<std::string> formats{"npy", "png"};
    bool views = false;
    std::string pixel;
    std::string cue;  // FILE:NAME; empty: the scene argument
    std::string at;   // a place inside a stage; empty: all stages
    bool live = false, force = false;
};

std::vector<std::string> formatNames() {
    std::vector<std::string> names;
    for (const pipeline::Exporter& exporter : pipeline::exporterTable()) names.emplace_back(exporter.name);
    for (const pipeline::FrameExporter& exporter : pipeline::frameExporterTable()) names.emplace_back(exporter.name);
    return names;
}

// Says what is wrong with the options, if anything.
std::string wrongUsage(const ExportOptions& options, const CliHost& host) {
    if (!options.at.empty() && !options.frame.until.empty()) return "--at names the stage; --until cannot go with it";
    if (options.cue.empty() && options.scene.scene.empty()) return "SCENE or --cue is required";
    if (!options.cue.empty() && !options.scene.scene.empty()) return "one SCENE or one --cue, not both";
    if (options.folder.empty()) return "-o needs the name of a folder";
    if (options.folder == kStandardOutput) return fmt::format("-o: {}", kNoStandardOutput);
    const std::vector<std::string> known = formatNames();
    for (const std::string& format : options.formats)
        if (std::ranges::find(known, format) == known.end())
            return fmt::format("no format {}, expected {}", pipeline::inQuotes(format), fmt::join(known, ", "));
    if (options.views && !host.writeViews) return "--views: this build has no 3D views";
    if (!options.views && !options.pixel.empty()) return "--pixel goes with --views";
    return {};
}

// Takes out the formats that cannot hold this scene. One line for each: the format and the reason.
std::vector<std::string> takeRefused(const pipeline::Scene& scene, std::vector<std::string>& formats) {
    std::vector<std::string> reasons;
    std::erase_if(formats, [&](const std::string& format) {
        const pipeline::FrameExporter* exporter = pipeline::findFrameExporter(format);
        const std::string why = exporter ? exporter->refuses(scene) : std::string();
        if (!why.empty()) reasons.push_back(fmt::format("--format {}: {}", format, why));
        return !why.empty();
    });
    return reasons;
}

// Buffers asked for by name that no chosen format can hold; the manifest alone would not be read.
void tellLeftOut(const pipeline::Frame& frame, const pipeline::ExportRequest& request) {
    if (request.buffers.empty()) return;
    const auto files = plannedFiles(frame, request);
    for (const pipeline::BufferName& buffer : request.buffers) {
        const auto of = [&](const pipeline::PlannedFile& file) { return file.buffer == buffer; };
        const auto written = [&](const pipeline::PlannedFile& file) { return of(file) && !file.file.empty(); };
        const auto why = std::ranges::find_if(files, of);
        if (why == files.end() || std::ranges::any_of(files, written)) continue;  // no format for buffers
        tell("{}: no file. {}\n", buffer.text(), why->whyNot);
    }
}

// Whether an export would write its manifest alone, and with that remove the export before.
bool isWithoutFiles(const pipeline::Frame& frame, const pipeline::ExportRequest& request) {
    const auto isWhole = [](const std::string& format) { return pipeline::findFrameExporter(format) != nullptr; };
    if (request.writeMore || std::ranges::any_of(request.formats, isWhole)) return false;
    return std::ranges::all_of(plannedFiles(frame, request), [](const auto& file) { return file.file.empty(); });
}

// The derived ones of buffers by name, which leave the others behind.
std::vector<pipeline::BufferName> takeDerived(std::vector<std::string>& names) {
    std::vector<pipeline::BufferName> derived;
    std::erase_if(names, [&](const std::string& text) {
        const auto name = pipeline::findDerived(text);
        if (name) derived.push_back(*name);
        return name.has_value();
    });
    return derived;
}

// The cue's scene, place and pixel, where the other options do not say otherwise. False: the reasons went to standard
// error.
bool takeCue(ExportOptions& options, const pipeline::Stop& stop, int& status) {
    const auto refuse = [&](const pipeline::Errors& errors, int why) {
        printErrors(errors);
        status = why;
        return false;
    };
    const auto named = lessons::parseCueName(options.cue);
    if (!named) return refuse(named.errors(), kWrongUsage);
    const auto list = lessons::readCueFile(named->file, stop);
    if (stop.stop_requested()) {
        status = tellCancelled();
        return false;
    }
    if (!list) return refuse(list.errors(), kBadInput);
    const auto found = findCue(*list, named->name);
    if (!found) return refuse(found.errors(), kWrongUsage);
    const lessons::WindowState& state = list->cues[*found].state;
    options.scene.state = state;
    options.scene.folder = named->file.parent_path();
    if (options.at.empty() && options.frame.until.empty() && state.place) options.at = text(*state.place);
    if (options.views && options.pixel.empty() && state.pixel)
        options.pixel = fmt::format("{},{}", (*state.pixel)[0], (*state.pixel)[1]);
    return true;
}

// What a cue looks at, where the options name nothing else. It was not asked for here: what comes after the end of the
// run is left out, and where nothing else is looked at, all that the run holds is meant. Errors: a view shows what
// cannot be made.
pipeline::Errors takeViews(ExportOptions& options, const pipeline::Scene& scene,
                           std::optional<pipeline::StageId> until) {
    using B = pipeline::BufferId;
    const lessons::WindowState& state = *options.scene.state;
    const lessons::DerivedRecipe recipe{options.derived.where.empty() ? state.condition : options.derived.where, {}};
    const auto whyNot = [&](const pipeline::BufferName& name) -> std::optional<pipeline::Error> {
        if (!until) return std::nullopt;
        if (!isDerived(name.id)) return comesTooLate(name, bufferInfo(name.id).stage, *until);
        const auto buffers = buffersFor(name, recipe, scene);
        return buffers ? comesTooLate(name, lastStageOf(*buffers), *until) : std::nullopt;
    };
    if (options.derived.mix.empty() && !whyNot({B::Mix})) options.derived.mix = state.mix;
    if (options.frame.buffers == FrameArgument().buffers) {
        std::vector<std::string> shown;
        for (std::size_t i = 0; i < state.views.size(); ++i) {
            const auto name = pipeline::findAnyBuffer(state.views[i].buffer).value();  // the reader knows the name
            if (const auto why = whyNot(name)) {
                tell("left out: {}\n", format(*why));
                continue;
            }
            const bool isOption =
                (name.id == B::Condition || name.id == B::Expression) && !options.derived.where.empty();
            if (isDerived(name.id) && !isOption)
                if (const auto buffers = buffersFor(name, recipe, scene); !buffers)
                    return namedAt(state.places.of(fmt::format("view.{}.buffer", i)), buffers.errors());
            shown.push_back(state.views[i].buffer);
        }
        if (!shown.empty()) options.frame.buffers = std::move(shown);
    }
    if (!options.derived.where.empty()) return {};
    // Text that gives numbers is no condition.
    const bool isNumbers = std::ranges::find(options.frame.buffers, "expression") != options.frame.buffers.end();
    if (isNumbers || (buffersFor({B::Condition}, recipe, scene) && !whyNot({B::Condition})))
        options.derived.where = state.condition;
    return {};
}

// What a picture opens again beside its scene: the cue, or place and pixel.
std::string stateToCarry(const ExportOptions& options, const std::optional<pipeline::Place>& at,
                         const std::optional<glm::ivec2>& pixel) {
    lessons::WindowState state = options.scene.state.value_or(lessons::WindowState());
    state.scene.clear(), state.set.clear(), state.sceneText.clear();
    if (!options.derived.where.empty()) state.condition = options.derived.where;
    if (!options.derived.mix.empty()) state.mix = options.derived.mix;
    if (!options.scene.state && !at && !pixel && state.condition.empty() && state.mix.empty()) return {};
    if (at) state.place = at, state.stage = at->stage;
    if (pixel) state.pixel = {pixel->x, pixel->y};
    return toToml(state);
}

// What is shown of a scene that comes with the program: the title and what to look at.
pipeline::BuiltInScene titled(const SceneArgument& argument) {
    for (pipeline::BuiltInScene& scene : pipeline::builtInScenes())
        if (scene.name == argument.scene) return scene;
    return {};
}

int runLive(ExportOptions options) {
    if (options.cue.empty() == options.scene.scene.empty()) {
        tell("shadescope export: --live takes one SCENE or one --cue\n");
        return kWrongUsage;
    }
    const auto found = livePartsOrTell(options.folder, "export");
    if (!found) return found.status;
    const Interrupt interrupt;
    int status = kDone;
    if (!options.cue.empty() && !takeCue(options, interrupt.token(), status)) return status;
    const auto scene = loadScene(options.scene, interrupt.token(), status);
    if (!scene) return status;
    const pipeline::BuiltInScene known = titled(options.scene);
    return writeLivePage(
        makeLivePage(*scene, known.title, known.look, options.scene.state, *found.parts, interrupt.token()),
        options.folder, interrupt);
}

int runExport(ExportOptions options, const CliHost& host) {
    if (const std::string wrong = wrongUsage(options, host); !wrong.empty()) {
        tell("shadescope export: {}\n", wrong);
        return kWrongUsage;
    }
    const Interrupt interrupt;
    int status = kDone;
    if (!options.cue.empty() && !takeCue(options, interrupt.token(), status)) return status;
    const auto scene = loadScene(options.scene, interrupt.token(), status);
    if (!scene) return status;
    for (const std::string& why : takeRefused(*scene, options.formats))
        tell("{}{}\n", options.formats.empty() ? "shadescope export: " : "left out: ", why);
    if (options.formats.empty()) return kWrongUsage;
    std::optional<pipeline::Place> at;
    std::optional<pipeline::StageId> until = pipeline::findStage(options.frame.until);
    if (!options.at.empty()) {
        const auto place = pipeline::parsePlace(options.at, *scene);
        if (!place) {
            printErrors(place.errors());
            return kWrongUsage;
        }
        at = *place;
        until = at->stage;  // nothing later is looked at
    }
    if (!options.cue.empty())
        if (const auto errors = takeViews(options, *scene, until); !errors.empty()) {
            printErrors(errors);
            return kBadInput;
        }
    FrameArgument argument = options.frame;
    argument.makesDerived = true;
    if (at) argument.until = pipeline::stageInfo(at->stage).name;
    const std::vector<pipeline::BufferName> named = takeDerived(argument.buffers);
    const auto wanted = wantedFrame(*scene, argument);
    if (!wanted) {
        printErrors(wanted.errors());
        return kWrongUsage;
    }
    const auto derivedOnes = derivedWanted(options.derived, named, *scene, until);
    if (!derivedOnes) {
        printErrors(derivedOnes.errors());
        return kWrongUsage;
    }
    std::optional<glm::ivec2> pixel;
    if (!options.pixel.empty() && !(pixel = pixelIn(*scene, options.pixel))) return kWrongUsage;

    pipeline::FrameRequest frameRequest = wanted->request;
    if (argument.until.empty()) frameRequest.until = std::max(frameRequest.until, lastStageOf(derivedOnes->buffers));
    frameRequest.stop = interrupt.token();
    frameRequest.wanted |= derivedOnes->buffers;
    // The calls hold normals, also where the run ends before anybody shades with them.
    if (std::ranges::find(options.formats, "opengl") != options.formats.end())
        frameRequest.wanted |= pipeline::normalsOfShading(*scene);
    if (!fits(*scene, frameRequest, options.scene, status)) return status;
    // Buffers without a file are known only by the frame: exportFrame() looks at all names.
    if (!mayWriteInto(options.folder, pipeline::wholeFiles(*scene, options.formats), pipeline::kManifest,
                      options.force))
        return kCouldNotWrite;
    pipeline::FramePtr frame = runFrame(scene, frameRequest, nullptr);
    if (frame) tellRemarks(*frame);
    // Derived ones alone: and no other.
    const auto& buffers = argument.buffers.empty() ? derivedOnes->names : wanted->buffers;
    pipeline::ExportRequest request{options.folder, buffers, options.formats, {}, {}, {}};
    if (at && frame) {
        const pipeline::Steps steps(frame);
        const pipeline::Moment moment = steps.momentOf(*at);
        request.at = text(steps.placeOf(moment));
        if (!steps.comesTo(*at))
            tell("This frame does not come to {}; what is written is {}.\n", options.at, request.at);
        frame = steps.frameAt(moment, options.frame.threads, interrupt.token());
    }
    request.replacesAny = options.force;
    request.state = stateToCarry(options, at, pixel);
    if (options.views)
        request.writeMore = [&](const std::filesystem::path& folder) { return host.writeViews(*frame, pixel, folder); };
    const auto goOn = [&](double, std::string_view) { return !interrupt.asked(); };
    if (!frame) return tellCancelled();
    auto derived = derivedOf(*derivedOnes, *frame, options.frame.threads, interrupt.token());
    if (!derived) {
        printErrors(derived.errors());
        return kBadInput;
    }
    if (interrupt.asked()) return tellCancelled();
    request.derived = std::move(derived).value();
    if (isWithoutFiles(*frame, request)) {
        tellLeftOut(*frame, request);
        tell("shadescope export: no buffer has a file in {}. Nothing was written.\n", fmt::join(options.formats, ", "));
        return kWrongUsage;
    }
    const auto summary = exportFrame(*frame, request, goOn);
    if (!summary) {
        printErrors(summary.errors());
        return kCouldNotWrite;
    }
    if (summary->cancelled) return tellCancelled();
    tellLeftOut(*frame, request);
    if (!summary->inDoubt.empty()) tell("{}: {}; the export there was replaced\n", options.folder, summary->inDoubt);
    const std::size_t removed = summary->removed.size();
    // With the manifest two at least.
    tell("{} files, {}, in {}{}\n", summary->files.size(), pipeline::sizeText(summary->bytes), options.folder,
         removed == 0 ? "" : fmt::format("; {} of the export before removed", removed));
    return kDone;
}

}  // namespace

void declareExport(CLI::App& program, const CliHost& host, int& status) {
    const auto options = std::make_shared<ExportOptions>();
    CLI::App* command = program.add_subcommand("export", "Run the pipeline, write the buffers and manifest.json");
    declareSceneArgument(*command, options->scene, SceneArgument::Need::Maybe);
    command->add_option("--cue", options->cue, "A cue of a talk in place of SCENE: its scene, place and buffers")
        ->type_name("FILE:NAME");
    command
        ->add_option("-o,--output", options->folder,
                     "The folder to write into, made when it is missing; with --live the file")
        ->required()
        ->type_name("DIR");
    CLI::Option* force = declareForce(*command, options->force);
    declareFrameArgument(*command, options->frame);
    declareDerived(*command, options->derived);
    command
        ->add_option(
            "--at", options->at,
            "The state inside a stage, right after a step: z-buffer/polygon=2, z-buffer/polygon=2/row=270/x=258")
        ->type_name("PLACE");
    declareNames(*command, "--format", options->formats, "NAME,...",
                 fmt::format("Any of {}", fmt::join(formatNames(), ", ")));
    if (host.writeViews) {
        command->add_flag("--views", options->views, "Write the 3D views as PNG too");
        command->add_option("--pixel", options->pixel, "With --views: show the vectors at this pixel")
            ->type_name("X,Y");
    } else {
        command->add_flag("--views", options->views)->group("");  // known, so that it can be refused by name
        command->add_option("--pixel", options->pixel)->group("");
    }
    auto* live = command->add_flag("--live", options->live,
                                   "Write one HTML file with the scene and the pipeline in it; -o names the file");
    for (const char* other : {"--format", "--buffers", "--until", "--at", "--views", "--pixel", "--where", "--mix"})
        live->excludes(other);
    live->excludes(force);
    command->callback(
        [options, &host, &status] { status = options->live ? runLive(*options) : runExport(*options, host); });
}

}  // namespace app
