#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lessons/state/cue_list.h"
#include "lessons/state/view_tree.h"
#include "pipeline/buffers/palette.h"
#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"

// A list of cues as one HTML file: a picture of every view, captions, notes, questions, the equation of the picked pixel
// or the algorithm of the step. It opens in any browser, with the network off, and computes nothing.

namespace lessons {

// What the colours of a picture stand for.
struct TalkLegend {
    std::string low, high, unit;            // values at the ends of the palette
    std::vector<pipeline::Color8> palette;  // from low to high; empty: no range
    std::vector<std::pair<pipeline::Color8, std::string>> names;
};
// A view of a cue as a picture.
struct TalkPicture {
    std::string png;                      // bytes of the file
    std::string leftOut = {};             // what the window shows there and a picture cannot, a sentence; may be empty
    std::vector<std::string> names = {};  // of what it shows: "color, Gouraud"; of two sides A and B; empty: the view's
    TalkLegend legend = {};
};
// How large a view is drawn. growth: pixels of the picture per pixel of the window at a text size of 100 %; 0: as a slide
// of that height has it.
struct TalkRoom {
    glm::ivec2 size;
    double growth = 0;
};
// Draws a view of a cue as the window shows it. Errors: why there is no picture of the view, a sentence; "stopped".
using DrawView = std::function<pipeline::Result<TalkPicture>(
    const WindowState& state, const std::shared_ptr<const pipeline::Scene>& scene, ViewLeaf view, const TalkRoom& room,
    const pipeline::Stop& stop)>;

// The page's own files: talk.html with holes @NAME@, its style and its script.
struct TalkParts {
    std::string page, style, script;
};
pipeline::Result<TalkParts> talkParts();

struct TalkPage {
    std::string html;
    std::vector<std::string> leftOut = {};  // "CUE: why", a line each
};
// number: of the cue that is done, from 1.
using TalkProgress = std::function<void(std::size_t number)>;

// folder: that the cues' scenes are named from. Errors: a cue whose scene cannot be read, or that does not fit it, with
// its name; "stopped".
pipeline::Result<TalkPage> makeTalkPage(const CueList& list, const std::filesystem::path& folder,
                                        const TalkParts& parts, const DrawView& draw, const pipeline::Stop& stop = {},
                                        const TalkProgress& progress = {});

// Where each view of an arrangement stands in a room of so many pixels, in the order of leavesOf.
std::vector<glm::ivec2> viewSizes(const ViewTree& tree, glm::ivec2 room);

}  // namespace lessons
