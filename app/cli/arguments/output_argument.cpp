#include "app/cli/arguments/output_argument.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>

#include "app/cli/arguments/scene_argument.h"
#include "app/cli/message.h"
#include "pipeline/export/buffers/exporter.h"
#include "pipeline/export/folder/contents.h"
#include "pipeline/export/folder/publish.h"
#include "pipeline/export/folder/size_text.h"
#include "pipeline/export/folder/staging.h"

namespace app {

pipeline::Errors writeOutput(const std::string& file, std::string_view bytes) {
    if (file != kStandardOutput) {
        const auto written = pipeline::writeWhole(file, bytes);
        return written ? pipeline::Errors() : written.errors();
    }
    errno = 0;
    std::fwrite(bytes.data(), 1, bytes.size(), stdout);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return {};
    return {pipeline::writeError("standard output", errno != 0 ? errno : EIO)};
}

void tellWritten(const std::string& file, std::size_t bytes) {
    tell("{}, {}\n", file == kStandardOutput ? "standard output" : file, pipeline::sizeText(bytes));
}

void refuseStandardOutput(CLI::Option& option) {
    option.check(CLI::Validator(
        [](const std::string& folder) {
            return folder == kStandardOutput ? std::string(kNoStandardOutput) : std::string();
        },
        ""));
}

CLI::Option* declareFolder(CLI::App& command, std::string& folder, const std::string& meaning) {
    CLI::Option* option = command.add_option("-o,--output", folder, meaning)->type_name("DIR");
    refuseStandardOutput(*option);
    return option;
}

CLI::Option* declareForce(CLI::App& command, bool& force) {
    return command.add_flag("--force", force, "Replace files in the folder that Shadescope did not write");
}

namespace {

bool toldWhyNot(const pipeline::Errors& errors) {
    printErrors(errors);
    return errors.empty();
}

}  // namespace

bool mayWriteInto(const std::string& folder, const std::vector<std::string>& names, const std::string& index,
                  bool force) {
    const pipeline::Errors errors = pipeline::whyNotInto(folder, names);
    if (!errors.empty() || force) return toldWhyNot(errors);
    return toldWhyNot(pipeline::whyNotReplaced(folder, names, index));
}

bool mayWriteTo(const std::string& file) { return file == kStandardOutput || toldWhyNot(pipeline::whyNotTo(file)); }

}  // namespace app
