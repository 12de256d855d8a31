#include "app/cli/live_argument.h"

#include <filesystem>

#include "app/cli/cli.h"
#include "app/cli/message.h"
#include "app/cli/scene_argument.h"
#include "pipeline/export/size_text.h"
#include "pipeline/export/staging.h"

namespace app {

LivePartsFound livePartsOrTell(const std::string& file, std::string_view command) {
    std::error_code ignored;
    if (file.empty() || std::filesystem::is_directory(file, ignored)) {
        tell("shadescope {}: with --live, -o needs the name of a file, as lesson.html\n", command);
        return {{}, kWrongUsage};
    }
    auto parts = lessons::liveParts();
    if (parts) return {std::move(parts).value(), kDone};
    printErrors(parts.errors());
    return {{}, kCouldNotWrite};
}

int writeLivePage(const pipeline::Result<lessons::LivePage>& page, const std::string& file,
                  const Interrupt& interrupt) {
    if (interrupt.asked()) {
        tell("Cancelled. Nothing was written.\n");
        return kInterrupted;
    }
    if (!page) {
        printErrors(page.errors());
        return kBadInput;
    }
    const auto written = pipeline::writeWhole(file, page->html);
    if (!written) {
        printErrors(written.errors());
        return kCouldNotWrite;
    }
    printErrors(page->leftOut);
    tell("{}, {}\n", file, pipeline::sizeText(page->html.size()));
    return kDone;
}

}  // namespace app
