#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/arguments/output_argument.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/progress_printer.h"
#include "lessons/games/drill.h"

namespace app {

namespace {

struct DrillRequest {
    std::uint64_t seed = 1;
    std::size_t rounds = 10;
    std::vector<std::string> kinds;
    std::string folder;
    bool force = false;
};

int runDrill(const DrillRequest& request) {
    if (request.folder.empty()) {
        tell("shadescope drill: -o needs the name of a folder\n");
        return kWrongUsage;
    }
    const std::vector<std::string> names = lessons::drillFiles();
    if (!mayWriteInto(request.folder, names, names.back(), request.force)) return kCouldNotWrite;
    const Interrupt interrupt;
    const auto rounds = [&] {
        ProgressPrinter progress("drill");
        return lessons::makeDrill(request.seed, request.rounds, request.kinds, interrupt.token(),
                                  [&](std::size_t round) { progress.show(round, request.rounds, "rounds"); });
    }();
    if (interrupt.asked()) return tellCancelled();
    if (!rounds) {
        printErrors(rounds.errors());
        return kWrongUsage;
    }
    const auto written = writeDrill(lessons::drillPages(request.seed, *rounds), request.folder);
    if (!written) {
        printErrors(written.errors());
        return kCouldNotWrite;
    }
    tell("{} in {}, seed {}\n", fmt::join(*written, " and "), request.folder, request.seed);
    return kDone;
}

}  // namespace

void declareDrill(CLI::App& program, const CliHost&, int& status) {
    CLI::App* command = program.add_subcommand(
        "drill", "Write pictures that differ in one technique, for a class to name, and the answers");
    const auto request = std::make_shared<DrillRequest>();
    declareFolder(*command, request->folder, "The folder to write into, made when it is missing")->required();
    declareForce(*command, request->force);
    command->add_option("--rounds", request->rounds, "How many")
        ->check(CLI::Range(1, 50))
        ->capture_default_str()
        ->type_name("N");
    command->add_option("--seed", request->seed, "Another seed gives other rounds; the same gives the same")
        ->capture_default_str()
        ->type_name("N");
    std::vector<std::string> names;
    for (const lessons::DrillKind& kind : lessons::drillKinds()) names.emplace_back(kind.name);
    command
        ->add_option("--kind", request->kinds,
                     fmt::format("What differs, with commas between; any unless given: {}", fmt::join(names, ", ")))
        ->delimiter(',')
        ->type_name("KIND");
    command->callback([request, &status] { status = runDrill(*request); });
}

}  // namespace app
