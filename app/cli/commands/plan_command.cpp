#include <CLI/CLI.hpp>

#include "app/cli/arguments/frame_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/headless/plan.h"

namespace app {

void declarePlan(CLI::App& program, const CliHost&, int& status) {
    struct Declared {
        SceneArgument scene;
        PlanOptions what;
    };
    const auto declared = std::make_shared<Declared>();
    PlanOptions* const options = &declared->what;
    CLI::App* command = program.add_subcommand("plan", "Print what will run, what is left out, and why");
    declareSceneArgument(*command, declared->scene);
    declareFrameArgument(*command, options->frame);
    auto* counts =
        command->add_flag("--counts", options->counts, "Run the frame, and print what it did and left out in counts");
    command->get_option("--threads")->needs(counts);
    command->add_flag("--json", options->json, "Print JSON, also all settings and the names of all buffers");
    command->callback([declared, &status] {
        const Interrupt interrupt;
        if (const auto scene = loadScene(declared->scene, interrupt.token(), status))
            status = plan(scene, declared->what, commandHost(declared->scene, interrupt.token()));
    });
}

}  // namespace app
