#pragma once
#include <string>
#include <utility>
#include <vector>

#include "lessons/pages/live_page.h"
#include "lessons/pages/talk_page.h"

// What a course puts on its server or on a stick: an index, every lesson live and on paper, every scene live, the lectures
// as talks, and the manual. All files stand in one folder and name each other; nothing else is needed.

namespace lessons {

struct Site {
    std::vector<std::pair<std::string, std::string>> files;  // name and bytes; the last one is index.html
    std::vector<std::string> leftOut;                        // "NAME: why", a line each
};
// what: "lesson pyramid"; done of all.
using SiteProgress = std::function<void(std::size_t done, std::size_t all, const std::string& what)>;

// draw: of the lectures' cues; empty: they are left out. Errors: a page that cannot be made; "stopped".
pipeline::Result<Site> makeSite(const LiveParts& parts, const DrawView& draw, const pipeline::Stop& stop = {},
                                const SiteProgress& progress = {});

}  // namespace lessons
