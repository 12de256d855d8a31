#pragma once
#include <optional>
#include <vector>

#include "pipeline/export/json/json.h"
#include "pipeline/run/frame.h"

namespace app {

// What leaving out saves in one scene: frames with every rule and without any in turns, so that
// whatever else the machine does disturbs both alike.
struct LeaveOutTimes {
    std::vector<double> with, without;           // milliseconds of each repetition
    std::vector<double> deciding;                // of those `with`, for the plan
    pipeline::FramePtr withFrame, withoutFrame;  // the last of each
};

struct LeaveOutOptions {
    pipeline::FrameRequest request;
    int warmups = 3, repeats = 20;
};

// Nothing when interrupted.
std::optional<LeaveOutTimes> measureLeavingOut(const pipeline::Scene& scene, const LeaveOutOptions& options);

// One row a scene, with a line of heads before the first. nameWidth: columns of the longest scene's name.
void printLeaveOutHead(std::size_t nameWidth);
void printLeaveOutRow(const LeaveOutTimes& times, std::size_t nameWidth);
pipeline::Json leaveOutJson(const LeaveOutTimes& times);

}  // namespace app
