#pragma once
#include "pipeline/buffers/buffer2d.h"
#include "pipeline/export/json/json_value.h"
#include "pipeline/inspect/own_calls.h"

namespace pipeline::foreign {

// What a program with one function of the pipeline has done in a scene.
struct OwnReport {
    OwnFunction function = OwnFunction::Place;
    std::string scene, command;  // as they were typed
    std::vector<OwnElement> elements;
    OwnResults mine;
    OwnVerdict verdict;
    bool isCut = false;        // more calls were left out
    std::size_t notAsked = 0;  // calls of the picture for which the right result stands in
    FramePtr right, yours;     // yours: null where the pipeline does not go on with the results
    double seconds = 0;        // in the program
    std::string messages;      // the end of what it wrote to standard error
    int hints = 3;             // how much is given away: 0 and 1 nothing, 2 the place, 3 the mistake's name

    const OwnContract& contract() const { return ownContract(function); }
};

// The first line of ownText().
std::string headline(const OwnReport& report);
// A line of text each, the first the verdict.
std::vector<std::string> ownText(const OwnReport& report);
// One page without anything from elsewhere. All texts of the program are escaped.
std::string ownHtml(const OwnReport& report);
Json ownJson(const OwnReport& report, int status);

}  // namespace pipeline::foreign
