#include "app/stages/step_track.h"

#include <algorithm>
#include <cmath>

namespace app {

using pipeline::Moment;
using pipeline::StageId;
using pipeline::StepLevel;

namespace {

constexpr double kClosestTicks = 4;  // pixels

}  // namespace

double StepTrack::partWidth() const {
    const double parts = double(pipeline::kStageCount);
    return std::max(1.0, (width - (parts - 1) * gap) / parts);
}

double StepTrack::partLeft(StageId stage) const { return double(index(stage)) * (partWidth() + gap); }

double StepTrack::xOf(Moment moment) const {
    const double total = double(steps.total(moment.stage));
    const double share = total > 0 ? double(moment.done) / total : 1;
    return partLeft(moment.stage) + share * partWidth();
}

Moment StepTrack::momentAt(double x) const {
    const double part = std::clamp(std::floor((x + gap / 2) / (partWidth() + gap)), 0.0, pipeline::kStageCount - 1.0);
    const StageId stage = pipeline::kStages[std::size_t(part)];
    const double share = std::clamp((x - partLeft(stage)) / partWidth(), 0.0, 1.0);
    return steps.fitting({stage, std::int64_t(std::llround(share * double(steps.total(stage))))});
}

std::vector<double> StepTrack::ticks(StageId stage, StepLevel level) const {
    std::vector<double> xs;
    for (const std::int64_t end : steps.ends(stage, level, std::int64_t(partWidth() / kClosestTicks))) {
        const double x = xOf({stage, end});
        // Steps may be of very different lengths: a short one gives way.
        if (xs.empty() || x - xs.back() >= kClosestTicks) xs.push_back(x);
    }
    return xs;
}

Moment snapped(const pipeline::Steps& steps, Moment moment, StepLevel level) {
    moment = steps.fitting(moment);
    if (moment.done == 0) return moment;
    const Moment after = *steps.next({moment.stage, moment.done - 1}, level);
    if (after == moment) return moment;
    const auto before = steps.previous(after, level);
    const std::int64_t begin = before && before->stage == moment.stage ? before->done : 0;
    return moment.done - begin < after.done - moment.done ? Moment{moment.stage, begin} : after;
}

}  // namespace app
