#include "app/cli/arguments/live_argument.h"

#include <filesystem>

#include "app/cli/arguments/output_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/cli.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"

namespace app {

bool isNoFile(const std::string& file) {
    std::error_code ignored;
    return file.empty() || std::filesystem::is_directory(file, ignored);
}

LivePartsFound livePartsOrTell(const std::string& file, std::string_view command) {
    if (isNoFile(file)) {
        tell("shadescope {}: with --live, -o needs the name of a file, as lesson.html\n", command);
        return {{}, kWrongUsage};
    }
    if (!mayWriteTo(file)) return {{}, kCouldNotWrite};
    auto parts = lessons::liveParts();
    if (parts) return {std::move(parts).value(), kDone};
    printErrors(parts.errors());
    return {{}, kCouldNotWrite};
}

int writePage(const pipeline::Result<std::string>& html, const std::string& file, const Interrupt& interrupt) {
    if (interrupt.asked()) return tellCancelled();
    if (!html) {
        printErrors(html.errors());
        return kBadInput;
    }
    if (const auto errors = writeOutput(file, *html); !errors.empty()) {
        printErrors(errors);
        return kCouldNotWrite;
    }
    tellWritten(file, html->size());
    return kDone;
}

int writeLivePage(const pipeline::Result<lessons::LivePage>& page, const std::string& file,
                  const Interrupt& interrupt) {
    if (page) printErrors(page->leftOut);
    return writePage(page ? pipeline::Result<std::string>(page->html) : page.errors(), file, interrupt);
}

}  // namespace app
