#include "app/cli/arguments/scene_argument.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>

#include "app/cli/arguments/cue_check.h"
#include "app/cli/cli.h"
#include "app/cli/message.h"
#include "app/cli/out_of_memory.h"
#include "lessons/state/state_scene.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/text/no_memory.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/plan/memory_limit.h"
#include "pipeline/scene/key_places.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/scene/shape_stop.h"

namespace app {

using pipeline::Errors;
using pipeline::Scene;

namespace {

// Where a setting was given on the command line; the last option for it counts.
pipeline::KeyPlaces optionsOf(const SceneArgument& argument) {
    pipeline::KeyPlaces places;
    if (!argument.size.empty())
        for (const char* key : {"width", "height"}) places.add(key, {"--size " + argument.size, 0, 0});
    for (const std::string& assignment : argument.set)
        places.add(std::string(pipeline::assignedKey(assignment)), {"--set " + assignment, 0, 0});
    return places;
}

// Of a scene in TOML; in standard input there is no folder for files beside it.
pipeline::Result<Scene> readStandardInput(const pipeline::ReadProgress& progress) {
    std::string text;
    std::array<char, 1 << 16> part;
    while (text.size() <= pipeline::kMaxTomlBytes && !progress.stop.stop_requested()) {
        const std::size_t count = std::fread(part.data(), 1, part.size(), stdin);
        if (count == 0) break;
        text.append(part.data(), count);
    }
    const pipeline::FileLoader none = [](std::string_view) -> pipeline::Result<pipeline::NamedFile> {
        return pipeline::Error{{}, "the scene names a file", "a scene that needs none, or the scene as a file"};
    };
    return readTomlScene({text, "standard input", progress}, none);
}

pipeline::Result<Scene> applySettings(Scene scene, const SceneArgument& argument) {
    if (!argument.size.empty()) {
        const auto size = parsePair(argument.size, 'x');
        if (!size) return pipeline::Error{{}, "--size is " + pipeline::inQuotes(argument.size), "WxH, as in 640x480"};
        for (const auto& [key, value] : {std::pair{"width", size->x}, std::pair{"height", size->y}}) {
            auto sized = withSetting(std::move(scene), fmt::format("{}={}", key, value));
            if (!sized) return namedAt({"--size " + argument.size}, sized.errors());
            scene = std::move(sized).value();
        }
    }
    for (const std::string& assignment : argument.set) {
        auto changed = withSetting(std::move(scene), assignment);
        if (!changed) return changed.errors();
        scene = std::move(changed).value();
    }
    if (argument.noLeaveOut) scene.settings.leaveOut = false;
    return scene;
}

}  // namespace

void declareSceneArgument(CLI::App& command, SceneArgument& argument, SceneArgument::Need need) {
    command
        .add_option("SCENE", argument.scene,
                    "A scene file, or the name of a built-in scene; - reads a scene in TOML from standard input")
        ->required(need == SceneArgument::Need::Always);
    command.add_option("--size", argument.size, "Size of the picture in pixels")->type_name("WxH");
    command.add_option("--set", argument.set, "Change a setting of the scene; may be repeated; plan --json lists them")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command
        .add_option("--camera", argument.views.camera,
                    "Of a glTF file: its N-th camera, from 0, in place of the one added")
        ->type_name("N");
    command
        .add_option_function<std::string>(
            "--lights", [&argument](const std::string&) { argument.views.lights = true; },
            "Of a glTF file: its own lights in place of the one added")
        ->type_name("file")
        ->check(CLI::IsMember({"file"}));
    command.add_flag("--no-leave-out", argument.noLeaveOut, "Run everything, also what the scene does not need");
}

std::shared_ptr<const Scene> loadScene(const SceneArgument& argument, const pipeline::Stop& stop, int& status) {
    const auto refuse = [&](const Errors& errors, int why) {
        printErrors(errors);
        status = why;
        return nullptr;
    };
    const auto cancelled = [&] {
        tell("Cancelled.\n");
        status = kInterrupted;
        return nullptr;
    };
    const pipeline::ReadProgress progress{{}, stop};
    auto read = argument.state          ? sceneOf(*argument.state, argument.folder, progress)
                : argument.scene == "-" ? readStandardInput(progress)
                                        : lessons::readNamedScene(argument.scene, {}, progress);
    if (stop.stop_requested()) return cancelled();
    if (!read) return refuse(read.errors(), kBadInput);
    if (argument.state)
        if (const Errors errors = checkCue(*argument.state, *read, argument.folder); !errors.empty())
            return refuse(errors, kBadInput);
    if (argument.views.any()) {
        read = withGltfViews(std::move(read).value(), argument.scene, argument.views, progress);
        if (!read) return refuse(read.errors(), kWrongUsage);
    }
    const pipeline::ShapeStop shapes(stop);
    auto changed = applySettings(std::move(read).value(), argument);
    if (stop.stop_requested()) return cancelled();
    if (!changed) return refuse(changed.errors(), kWrongUsage);
    if (const Errors errors = checkScene(*changed); !errors.empty())
        return refuse(optionsOf(argument).placed(errors), kWrongUsage);
    return std::make_shared<const Scene>(std::move(changed).value());
}

bool fits(const Scene& scene, const pipeline::FrameRequest& request, const SceneArgument& argument, int& status) {
    Errors errors = checkMemory(scene, request.wanted, request.until);
    if (errors.empty()) return true;
    errors = optionsOf(argument).placed(errors);
    status = errors[0].where.file.empty() ? kBadInput : kWrongUsage;
    if (errors[0].where.file.empty()) errors[0].where.file = argument.scene;
    printErrors(errors);
    return false;
}

CommandHost commandHost(const SceneArgument& argument, pipeline::Stop stop) {
    return {.out = sayText,
            .messages = [](std::string_view text) { tell("{}", text); },
            .tellErrors = printErrors,
            .fits = [&argument](const Scene& scene, const pipeline::FrameRequest& request,
                                int& status) { return fits(scene, request, argument, status); },
            .stop = std::move(stop)};
}

void printErrors(const Errors& errors) {
    const bool isOfMemory = std::ranges::any_of(errors, pipeline::isOfMemory);
    if (!isOfMemory && hasThrownOutOfMemory()) throw std::bad_alloc();
    tell("{}", format(errors));
    if (isOfMemory) throw OutOfMemorySaid();
}

}  // namespace app
