#include <CLI/CLI.hpp>

#include "app/cli/arguments/frame_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/headless/check.h"

namespace app {

void declareCheck(CLI::App& program, const CliHost&, int& status) {
    const auto options = std::make_shared<CheckOptions>();
    CLI::App* command = program.add_subcommand(
        "check", "Run the stiff and extreme cases: what a naive formula gives, what this program gives, and the bound");
    command->add_option("--case", options->cases, "This case alone; can be given more than once")->type_name("ID");
    command
        ->add_option("--group", options->groups,
                     "The cases of a group: geometry, camera, raster, depth, shading, shadow or limits")
        ->type_name("GROUP");
    command->add_flag("--list", options->list, "List the cases and run none");
    command->add_flag("--json", options->json, "Print JSON");
    declareThreads(*command, options->threads);
    command->callback([options, &status] {
        const Interrupt interrupt;
        const SceneArgument none;
        status = check(*options, commandHost(none, interrupt.token()));
    });
}

}  // namespace app
