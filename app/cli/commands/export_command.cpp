#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/cli/arguments/derived_argument.h"
#include "app/cli/arguments/frame_argument.h"
#include "app/cli/arguments/live_argument.h"
#include "app/cli/arguments/output_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/headless/export.h"
#include "lessons/state/cue_list.h"
#include "pipeline/export/export_frame.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/scene/key_places.h"
#include "pipeline/steps/steps.h"

namespace app {

namespace {

struct DeclaredExport {
    SceneArgument scene;
    ExportOptions what;
    bool views = false;
    std::string cue;  // FILE:NAME; empty: the scene argument
    bool live = false;
};

// Says what is wrong with the options, if anything.
std::string wrongUsage(const DeclaredExport& options, const CliHost& host) {
    if (!options.what.at.empty() && !options.what.frame.until.empty())
        return "--at names the stage; --until cannot go with it";
    if (options.cue.empty() && options.scene.scene.empty()) return "SCENE or --cue is required";
    if (!options.cue.empty() && !options.scene.scene.empty()) return "one SCENE or one --cue, not both";
    if (options.what.folder.empty()) return "-o needs the name of a folder";
    if (options.what.folder == kStandardOutput) return fmt::format("-o: {}", kNoStandardOutput);
    if (const std::string wrong = wrongFormats(options.what.formats); !wrong.empty()) return wrong;
    if (options.views && !host.writeViews) return "--views: this build has no 3D views";
    if (!options.views && !options.what.pixel.empty()) return "--pixel goes with --views";
    return {};
}

// The cue's scene, place and pixel, where the other options do not say otherwise. False: the reasons went to standard
// error.
bool takeCue(DeclaredExport& options, const pipeline::Stop& stop, int& status) {
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
    if (options.what.at.empty() && options.what.frame.until.empty() && state.place)
        options.what.at = text(*state.place);
    if (options.views && options.what.pixel.empty() && state.pixel)
        options.what.pixel = fmt::format("{},{}", (*state.pixel)[0], (*state.pixel)[1]);
    return true;
}

// What a cue looks at, where the options name nothing else. It was not asked for here: what comes after the end of the
// run is left out, and where nothing else is looked at, all that the run holds is meant. Errors: a view shows what
// cannot be made.
pipeline::Errors takeViews(const SceneArgument& argument, ExportOptions& options, const pipeline::Scene& scene,
                           std::optional<pipeline::StageId> until) {
    using B = pipeline::BufferId;
    const lessons::WindowState& state = *argument.state;
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
std::string stateToCarry(const SceneArgument& argument, const ExportOptions& options,
                         const std::optional<pipeline::Place>& at, const std::optional<glm::ivec2>& pixel) {
    lessons::WindowState state = argument.state.value_or(lessons::WindowState());
    state.scene.clear(), state.set.clear(), state.sceneText.clear();
    if (!options.derived.where.empty()) state.condition = options.derived.where;
    if (!options.derived.mix.empty()) state.mix = options.derived.mix;
    if (!argument.state && !at && !pixel && state.condition.empty() && state.mix.empty()) return {};
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

int runLive(DeclaredExport options) {
    if (options.cue.empty() == options.scene.scene.empty()) {
        tell("shadescope export: --live takes one SCENE or one --cue\n");
        return kWrongUsage;
    }
    const auto found = livePartsOrTell(options.what.folder, "export");
    if (!found) return found.status;
    const Interrupt interrupt;
    int status = kDone;
    if (!options.cue.empty() && !takeCue(options, interrupt.token(), status)) return status;
    const auto scene = loadScene(options.scene, interrupt.token(), status);
    if (!scene) return status;
    const pipeline::BuiltInScene known = titled(options.scene);
    return writeLivePage(
        makeLivePage(*scene, known.title, known.look, options.scene.state, *found.parts, interrupt.token()),
        options.what.folder, interrupt);
}

int runExport(DeclaredExport options, const CliHost& host) {
    if (const std::string wrong = wrongUsage(options, host); !wrong.empty()) {
        tell("shadescope export: {}\n", wrong);
        return kWrongUsage;
    }
    const Interrupt interrupt;
    int status = kDone;
    if (!options.cue.empty() && !takeCue(options, interrupt.token(), status)) return status;
    const auto scene = loadScene(options.scene, interrupt.token(), status);
    if (!scene) return status;
    const ExportPlace place{
        .prepare = [&](ExportOptions& what, std::optional<pipeline::StageId> until) -> pipeline::Errors {
            if (options.cue.empty()) return {};
            return takeViews(options.scene, what, *scene, until);
        },
        // Buffers without a file are known only by the frame: exportFrame() looks at all names.
        .mayWrite =
            [&](const std::vector<std::string>& names) {
                return mayWriteInto(options.what.folder, names, pipeline::kManifest, options.what.force);
            },
        .write =
            [&](const pipeline::Frame& frame, pipeline::ExportRequest request, const ExportOptions& what,
                const std::optional<pipeline::Place>& at, const std::optional<glm::ivec2>& pixel) {
                request.state = stateToCarry(options.scene, what, at, pixel);
                if (options.views)
                    request.writeMore = [&](const std::filesystem::path& folder) {
                        return host.writeViews(frame, pixel, folder);
                    };
                return exportFrame(frame, request, [&](double, std::string_view) { return !interrupt.asked(); });
            },
        .writesViews = options.views};
    return exportBuffers(scene, options.what, place, commandHost(options.scene, interrupt.token()));
}

}  // namespace

void declareExport(CLI::App& program, const CliHost& host, int& status) {
    const auto options = std::make_shared<DeclaredExport>();
    CLI::App* command = program.add_subcommand("export", "Run the pipeline, write the buffers and manifest.json");
    declareSceneArgument(*command, options->scene, SceneArgument::Need::Maybe);
    command->add_option("--cue", options->cue, "A cue of a talk in place of SCENE: its scene, place and buffers")
        ->type_name("FILE:NAME");
    command
        ->add_option("-o,--output", options->what.folder,
                     "The folder to write into, made when it is missing; with --live the file")
        ->required()
        ->type_name("DIR");
    CLI::Option* force = declareForce(*command, options->what.force);
    declareFrameArgument(*command, options->what.frame);
    declareDerived(*command, options->what.derived);
    command
        ->add_option(
            "--at", options->what.at,
            "The state inside a stage, right after a step: z-buffer/polygon=2, z-buffer/polygon=2/row=270/x=258")
        ->type_name("PLACE");
    declareNames(*command, "--format", options->what.formats, "NAME,...",
                 fmt::format("Any of {}", fmt::join(formatNames(), ", ")));
    if (host.writeViews) {
        command->add_flag("--views", options->views, "Write the 3D views as PNG too");
        command->add_option("--pixel", options->what.pixel, "With --views: show the vectors at this pixel")
            ->type_name("X,Y");
    } else {
        command->add_flag("--views", options->views)->group("");  // known, so that it can be refused by name
        command->add_option("--pixel", options->what.pixel)->group("");
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
