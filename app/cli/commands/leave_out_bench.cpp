#include "app/cli/commands/leave_out_bench.h"

#include <fmt/format.h>

#include <array>
#include <memory>

#include "app/cli/message.h"
#include "pipeline/core/sample.h"
#include "pipeline/run/runner.h"
#include "pipeline/study/memory_share.h"

namespace app {

namespace {

using pipeline::Frame;

double median(const std::vector<double>& times) { return pipeline::summarize(times).median; }

// Median of the quotients of neighbouring frames.
double ratio(const LeaveOutTimes& times) {
    std::vector<double> quotients;
    for (std::size_t i = 0; i < times.with.size(); ++i) quotients.push_back(times.without[i] / times.with[i]);
    return median(quotients);
}

long long done(const Frame& frame, std::string_view what) {
    for (const pipeline::StageId stage : pipeline::kStages)
        for (const pipeline::Tally& tally : frame.run(stage).tallies)
            if (tally.what == what) return tally.done;
    return 0;
}

double megabytes(const Frame& frame) { return pipeline::bufferBytes(frame) / 1e6; }

constexpr std::array<std::string_view, 3> kCounters{"light evaluations", "powers", "shadow look-ups"};

}  // namespace

std::optional<LeaveOutTimes> measureLeavingOut(const pipeline::Scene& scene, const LeaveOutOptions& options) {
    auto with = std::make_shared<pipeline::Scene>(scene), without = std::make_shared<pipeline::Scene>(scene);
    with->settings.leaveOut = true, without->settings.leaveOut = false;
    LeaveOutTimes times;
    for (int i = -options.warmups; i < options.repeats; ++i) {
        times.withFrame = runFrame(with, options.request, nullptr);
        times.withoutFrame = runFrame(without, options.request, nullptr);
        if (!times.withFrame || !times.withoutFrame) return std::nullopt;
        if (i < 0) continue;
        times.with.push_back(times.withFrame->milliseconds());
        times.without.push_back(times.withoutFrame->milliseconds());
        times.deciding.push_back(times.withFrame->planMilliseconds());
    }
    return times;
}

void printLeaveOutHead(std::size_t nameWidth) {
    say("{:<{}} {:>9} {:>9} {:>6} {:>9}   {:<23} {:<23} {:<23} {}\n", "", nameWidth, "with ms", "without", "times",
        "deciding", "light evaluations", "powers", "shadow look-ups", "buffers MB");
}

void printLeaveOutRow(const LeaveOutTimes& times, std::size_t nameWidth) {
    const double with = median(times.with), without = median(times.without);
    say("{:<{}} {:>9.3f} {:>9.3f} {:>6.2f} {:>8.2f}%  ", times.withFrame->scene().name, nameWidth, with, without,
        ratio(times), 100 * median(times.deciding) / with);
    for (const std::string_view what : kCounters)
        say(" {:<23}", fmt::format("{} of {}", done(*times.withFrame, what), done(*times.withoutFrame, what)));
    say(" {:.1f} of {:.1f}\n", megabytes(*times.withFrame), megabytes(*times.withoutFrame));
}

pipeline::Json leaveOutJson(const LeaveOutTimes& times) {
    pipeline::Json counters = pipeline::Json::object();
    for (const std::string_view what : kCounters)
        counters[std::string(what)] = {{"with", done(*times.withFrame, what)},
                                       {"without", done(*times.withoutFrame, what)}};
    return {{"scene", sceneToJson(times.withFrame->scene())},
            {"milliseconds", {{"with", median(times.with)}, {"without", median(times.without)}}},
            {"times_as_fast", ratio(times)},
            {"deciding_milliseconds", median(times.deciding)},
            {"counters", counters},
            {"buffer_megabytes", {{"with", megabytes(*times.withFrame)}, {"without", megabytes(*times.withoutFrame)}}}};
}

}  // namespace app
