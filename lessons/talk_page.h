#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "lessons/state/cue_list.h"
#include "lessons/state/view_tree.h"
#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"

// A list of cues as one HTML file: a picture of every view, captions, notes, the equation of the picked pixel. It opens in
// any browser, with the network off, and computes nothing.

namespace lessons {

// A view of a cue as a picture.
struct TalkPicture {
    std::string png;           // bytes of the file
    std::string leftOut = {};  // what the window shows there and a picture cannot, a sentence; may be empty
};
// Draws a view of a cue as the window shows it in so many pixels. Errors: a view that the scene does not have; "stopped".
using DrawView = std::function<pipeline::Result<TalkPicture>(
    const WindowState& state, const std::shared_ptr<const pipeline::Scene>& scene, ViewLeaf view, glm::ivec2 size,
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
