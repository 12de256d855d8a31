#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/cli/arguments/frame_argument.h"
#include "app/cli/arguments/output_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/library_guard.h"
#include "app/cli/message.h"
#include "app/cli/progress_printer.h"
#include "pipeline/core/text.h"
#include "pipeline/export/film/film.h"
#include "pipeline/export/folder/size_text.h"
#include "pipeline/run/runner.h"

namespace app {
namespace {

struct FilmOptions {
    SceneArgument scene;
    std::string target, buffer = "color", level = "polygon", from, to;
    int pictures = 120, milliseconds = 100, threads = 0;
    bool noCaptions = false, algorithm = false, force = false;
};

// A place from the command line, or nothing after the reason went to standard error.
std::optional<pipeline::Place> placeNamed(const std::string& option, const std::string& text,
                                          const pipeline::Scene& scene) {
    const auto place = pipeline::parsePlace(text, scene);
    if (place) return *place;
    tell("shadescope film: {}: {}\n", option, format(place.errors()));
    return std::nullopt;
}

int runFilm(const FilmOptions& options) {
    if (options.target.empty()) {
        tell("shadescope film: -o needs the name of a file or a folder\n");
        return kWrongUsage;
    }
    const Interrupt interrupt;
    int status = kDone;
    const auto scene = loadScene(options.scene, interrupt.token(), status);
    if (!scene) return status;
    if (pipeline::findDerived(options.buffer)) {
        tell("shadescope film: {} is derived from a finished frame and cannot be filmed\n", options.buffer);
        return kWrongUsage;
    }
    const auto wanted = wantedFrame(*scene, {{options.buffer}, {}, options.threads});
    if (!wanted || wanted->buffers.size() != 1) {
        printErrors(wanted ? pipeline::Errors{{{}, "a film shows one buffer", "its name"}} : wanted.errors());
        return kWrongUsage;
    }
    const pipeline::BufferName buffer = wanted->buffers[0];
    const pipeline::BufferInfo& info = bufferInfo(buffer.id);
    if (info.domain != pipeline::Domain::Pixel && info.domain != pipeline::Domain::Texel) {
        tell("shadescope film: {} has no pixels, so that there is nothing to film\n", buffer.text());
        return kWrongUsage;
    }
    pipeline::Place from{info.stage}, to{info.stage};
    from.what = pipeline::Place::What::Start;
    for (auto [text, place, option] : {std::tuple{&options.from, &from, "--from"}, {&options.to, &to, "--to"}}) {
        if (text->empty()) continue;
        const auto named = placeNamed(option, *text, *scene);
        if (!named) return kWrongUsage;
        *place = *named;
    }
    pipeline::FrameRequest frameRequest = wanted->request;
    frameRequest.until = std::max({info.stage, from.stage, to.stage});
    // A film that passes through that stage shows its steps, whatever stage it ends in.
    if (from.stage <= pipeline::StageId::Normals) frameRequest.wanted |= pipeline::normalsOfShading(*scene);
    frameRequest.stop = interrupt.token();
    if (!fits(*scene, frameRequest, options.scene, status)) return status;
    const pipeline::FramePtr frame = runFrame(scene, frameRequest, nullptr);
    if (!frame) return tellCancelled();
    if (!frame->buffer(buffer)) {
        tell("shadescope film: no {}. {}\n", buffer.text(), frame->whyAbsent(buffer));
        return kWrongUsage;
    }
    const pipeline::Steps steps(frame);
    const pipeline::FilmRequest request{buffer,
                                        *pipeline::findStepLevel(options.level),
                                        steps.momentOf(from),
                                        steps.momentOf(to),
                                        std::size_t(options.pictures),
                                        options.milliseconds,
                                        !options.noCaptions,
                                        options.algorithm};
    for (const pipeline::Place& place : {from, to})
        if (!steps.comesTo(place))
            tell("This frame does not come to {}; the film has {} in its place.\n", text(place),
                 text(steps.placeOf(steps.momentOf(place))));
    if (request.to < request.from) {
        tell("shadescope film: --to comes before --from\n");
        return kWrongUsage;
    }
    if (pipeline::isGif(options.target)) {
        if (!mayWriteTo(options.target)) return kCouldNotWrite;
    } else if (const auto files = filmFiles(steps, request);
               !mayWriteInto(options.target, files, files.back(), options.force)) {
        return kCouldNotWrite;
    }
    ProgressPrinter line("film");
    const LibraryGuard guard(LibraryGuard::kNoLimit);  // it may have any number of pictures
    const auto summary = writeFilm(steps, request, options.target, [&](std::size_t done, std::size_t all) {
        line.show(done, all);
        return !interrupt.asked();
    });
    line.end();
    if (!summary) {
        printErrors(summary.errors());
        return kCouldNotWrite;
    }
    if (summary->cancelled) return tellCancelled();
    if (!summary->inDoubt.empty()) tell("{}: {}; the film there was replaced\n", options.target, summary->inDoubt);
    const std::size_t removed = summary->removed.size();
    tell("{}, {}, in {}{}{}\n", pipeline::plural(std::int64_t(summary->pictures), "picture"),
         pipeline::sizeText(summary->bytes), options.target,
         removed == 0 ? "" : fmt::format("; {} of the film before removed", removed),
         summary->behind == 0 ? "" : fmt::format("; {} not of this film behind them", summary->behind));
    return kDone;
}

}  // namespace

void declareFilm(CLI::App& program, const CliHost&, int& status) {
    const auto options = std::make_shared<FilmOptions>();
    CLI::App* command = program.add_subcommand("film", "Write a buffer's build-up, step by step, as a GIF or as PNGs");
    declareSceneArgument(*command, options->scene);
    declareFolder(*command, options->target, "A file that ends in .gif, or a folder for PNG files")
        ->required()
        ->type_name("FILE.gif|DIR");
    declareForce(*command, options->force);
    command->add_option("--buffer", options->buffer, "Which buffer the film shows")
        ->type_name("NAME")
        ->capture_default_str();
    std::vector<std::string> levels;
    for (std::size_t level = 0; level < pipeline::kStepLevelCount; ++level)
        levels.emplace_back(name(pipeline::StepLevel(level)));
    command->add_option("--by", options->level, fmt::format("A picture for each {}", fmt::join(levels, ", ")))
        ->type_name("LEVEL")
        ->check(CLI::IsMember(levels))
        ->capture_default_str();
    command->add_option("--from", options->from, "The first picture; the beginning of the buffer's stage unless given")
        ->type_name("PLACE");
    command->add_option("--to", options->to, "The last picture; the end of the buffer's stage unless given")
        ->type_name("PLACE");
    command->add_option("--pictures", options->pictures, "At most so many, evenly spread")
        ->type_name("N")
        ->check(CLI::Range(2, 10000))
        ->capture_default_str();
    command->add_option("--milliseconds", options->milliseconds, "How long a picture stays, in a GIF")
        ->type_name("N")
        ->check(CLI::Range(10, 60000))
        ->capture_default_str();
    command->add_flag("--algorithm", options->algorithm, "Show the stage's algorithm below the picture, at its line");
    command->add_flag("--no-captions", options->noCaptions, "Leave out the line below the picture");
    declareThreads(*command, options->threads);
    command->callback([options, &status] { status = runFilm(*options); });
}

}  // namespace app
