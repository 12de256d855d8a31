#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "app/cli/interrupt.h"
#include "lessons/pages/live_page.h"

namespace app {

// --live: one HTML file, for a lesson and for a scene.

// The parts of a page, or nothing after the reason went to standard error, and the exit status that it means.
struct LivePartsFound {
    std::optional<lessons::LiveParts> parts;
    int status = 0;
    explicit operator bool() const { return parts.has_value(); }
};
// command: "export", for messages; file: what -o names.
LivePartsFound livePartsOrTell(const std::string& file, std::string_view command);

// Whether -o names no file: a folder, or nothing.
bool isNoFile(const std::string& file);

// Writes a page that was made, and tells how large it is. Gives the exit status.
int writePage(const pipeline::Result<std::string>& html, const std::string& file, const Interrupt& interrupt);
// The same, and what was left out of it.
int writeLivePage(const pipeline::Result<lessons::LivePage>& page, const std::string& file, const Interrupt& interrupt);

}  // namespace app
