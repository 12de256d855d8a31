#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "lessons/lesson.h"
#include "lessons/pages/page_parts.h"
#include "lessons/state/window_state.h"
#include "pipeline/core/stop.h"
#include "pipeline/export/json/json_value.h"

// A lesson or a scene as one HTML file with the pipeline in it, compiled to WebAssembly: it works without network, server
// and installation. app/web/ has the page and the core's calls.

namespace lessons {

// What every page has in common: the core, and the page's own files.
struct LiveParts {
    std::string core;                 // WebAssembly, packed by gzip
    std::string page, style, script;  // page.html with holes @NAME@, its styles and scripts
    std::string writer = {};          // elements that a page has with questions of kind write: see withWriter()
    std::string places = {};          // of the whole program: what the page has beside a lesson
    // The file beside the page that has the core, "globalThis.sharedCore = '…'" in base85; empty: it stands in the page.
    std::string sharedCore = {};
    std::string index = {};  // the file beside the page that lists all pages; empty: none
};
// Of a page of one lesson, of pages that share a core, or of the page that is the whole program. Found beside the installed
// program's resources, or in the source tree and its folder build/web. An error says how to build the core where it is not
// there.
enum class LiveKind : std::uint8_t { Lesson, Site, Whole };
pipeline::Result<LiveParts> liveParts(LiveKind kind = LiveKind::Lesson);

// With what reads and runs lines, for lessons with questions of kind write. Errors: a file that is not there.
pipeline::Result<LiveParts> withWriter(LiveParts parts);

struct LivePage {
    std::string html;
    pipeline::Errors leftOut = {};  // pictures that no lesson may bring along, with the place of their page
};

// The file of a lesson's page in a site.
inline std::string livePageFile(const std::string& lesson) { return "lesson-" + lesson + ".html"; }

// The lesson in a folder, or in the text of a lesson.md whose scenes `sceneNamed` finds. Errors: what is wrong with it,
// FILE:LINE:COLUMN; "stopped".
pipeline::Result<LivePage> makeLivePage(const Lesson& lesson, const LiveParts& parts, const pipeline::Stop& stop = {});

// A lesson of one page made of a scene: its title, what to look at, and every setting. shown: the buffers, pixel, place
// and channel that the page begins with; nothing: the picture, and a pixel in the middle of what is drawn.
pipeline::Result<LivePage> makeLivePage(const pipeline::Scene& scene, std::string_view title, std::string_view look,
                                        const std::optional<WindowState>& shown, const LiveParts& parts,
                                        const pipeline::Stop& stop = {});

// The page with its holes filled, but for those of its kind, which `values` has.
std::string filledPage(const LiveParts& parts, std::string_view title, const pipeline::Json& data, PageValues values);

// What a site has beside the page that is its index.
struct PageSurroundings {
    pipeline::Json lists = pipeline::Json::array();  // [{"heading", "entries": [{"file", "title", "note"}]}]
    std::string paper{};                             // the same and all else as HTML, for a browser without scripts
};
// The program in one page: every scene and lesson, scenes and models of the reader's own, the check of a renderer, the wrong
// picture and the cases.
// Errors: a file of the program that cannot be read; "stopped".
using PageProgress = std::function<void(std::size_t done, std::size_t all, const std::string& what)>;
pipeline::Result<std::string> makeWholePage(const LiveParts& parts, const pipeline::Stop& stop = {},
                                            const PageProgress& progress = {}, const PageSurroundings& beside = {});

}  // namespace lessons
