#include "app/cli/arguments/frame_argument.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/cli/message.h"

namespace app {

void tellRemarks(const pipeline::Frame& frame) { tell("{}", remarksText(frame)); }

void declareThreads(CLI::App& command, int& threads) {
    command.add_option("--threads", threads, "Threads to use; 0 is as many as the machine has")
        ->type_name("N")
        ->check(CLI::Range(0, 1024));
}

void declareNames(CLI::App& command, const std::string& option, std::vector<std::string>& names,
                  const std::string& type, const std::string& meaning) {
    const auto take = [&names](const std::vector<std::string>& lists) {
        names.clear();
        for (const std::string& list : lists)
            for (std::size_t begin = 0, end = 0; end != list.npos; begin = end + 1) {
                end = list.find(',', begin);
                names.push_back(list.substr(begin, end - begin));
            }
    };
    command.add_option_function<std::vector<std::string>>(option, take, meaning)
        ->type_name(type)
        ->allow_extra_args(false)
        ->default_str(fmt::format("{}", fmt::join(names, ",")));
}

void declareFrameArgument(CLI::App& command, FrameArgument& argument) {
    declareNames(command, "--buffers", argument.buffers, "all|NAME,...",
                 "all, or buffers by name: these are computed even if left out");
    std::vector<std::string_view> stages;
    for (const pipeline::StageId stage : pipeline::kStages) stages.push_back(pipeline::stageInfo(stage).name);
    command.add_option("--until", argument.until, fmt::format("Stop after this stage: {}", fmt::join(stages, ", ")))
        ->type_name("STAGE");
    declareThreads(command, argument.threads);
}

}  // namespace app
