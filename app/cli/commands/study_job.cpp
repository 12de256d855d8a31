#include "app/cli/commands/study_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "app/cli/arguments/error_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/cli.h"
#include "app/cli/commands/child_process.h"
#include "app/cli/commands/study_folder.h"
#include "app/cli/library_guard.h"
#include "app/cli/message.h"
#include "app/cli/progress_printer.h"
#include "pipeline/export/folder/contents.h"
#include "pipeline/export/folder/staging.h"
#include "pipeline/export/json/study_json.h"
#include "pipeline/export/study/study_files.h"
#include "pipeline/export/study/study_text.h"
#include "pipeline/study/machine.h"

namespace app {

namespace fs = std::filesystem;
using pipeline::StudyPoint;
using pipeline::StudyReport;

namespace {

std::string valuesText(const StudyPoint& point) { return fmt::format("{}", fmt::join(point.values, ", ")); }

bool isFound(const StudyPoint& point) { return !point.failure.empty() || !point.errors.empty(); }

// What may be lost when the program is ended by force. Writing after every point would take the time of its square in
// a study of thousands.
constexpr std::chrono::seconds kKeptEvery{5};

struct Run {
    const StudyOrder& job;
    const Interrupt& interrupt;
    int& status;
    StudyReport report;
    std::chrono::steady_clock::time_point kept = std::chrono::steady_clock::now();

    fs::path part() const { return partFile(job.folder, job.request); }

    bool keep() {
        const auto written = writeJson(report, part());
        kept = std::chrono::steady_clock::now();
        if (written) return true;
        printErrors(written.errors());
        status = kCouldNotWrite;
        return false;
    }
    bool cancelled() {
        if (!keep()) return false;
        status = studyCancelled(job);
        return false;
    }

    // What the folder holds stays as it is.
    bool stoppedBefore() {
        status = studyCancelled(job);
        return false;
    }

    bool begin() {
        // What a folder cannot hold would be measured for nothing.
        if (const auto folder = pipeline::Staging::begin(job.folder); !folder) {
            printErrors(folder.errors());
            status = kCouldNotWrite;
            return false;
        }
        report = beginStudy(job.request);
        report.processes = job.processes;
        if (interrupt.asked()) return stoppedBefore();
        if (job.restart) return true;
        auto before = resumed(job.folder, job.request, interrupt.token());
        if (interrupt.asked()) return stoppedBefore();
        if (!before) {
            printErrors(before.errors());
            status = kBadInput;
            return false;
        }
        if (!*before) return true;
        report = **before;
        report.processes = job.processes;
        if (job.request.choice) report.choice = *job.request.choice;
        tell("Goes on: {} of {} points have their errors, {} of {} processes their times.\n",
             std::ranges::count_if(report.points, isFound), report.points.size(), report.load.size(), job.processes);
        return true;
    }

    bool findErrors() {
        pipeline::ErrorFinder finder(job.request);
        ProgressPrinter progress("Errors");
        const auto all = report.points.size();
        for (StudyPoint& point : report.points) {
            if (isFound(point)) continue;
            progress.show(std::size_t(std::ranges::count_if(report.points, isFound)), all, valuesText(point));
            if (!finder.find(point, report, interrupt.token())) {
                progress.end();
                return cancelled();
            }
            if (std::chrono::steady_clock::now() - kept >= kKeptEvery && !keep()) return false;
        }
        return keep();
    }

    bool measure() {
        // In the folder, where there is room for it, hidden, and of this process alone: parts of a study share a folder.
        const auto hidden = pipeline::Staging::begin(job.folder);
        if (!hidden) {
            printErrors(hidden.errors());
            status = kCouldNotWrite;
            return false;
        }
        const fs::path times = hidden->folder() / "times.json";
        for (int process = static_cast<int>(report.load.size()); process < job.processes; ++process) {
            std::vector<std::string> arguments = job.arguments;
            arguments.insert(arguments.end(), {"--times-into", times.string(), "--times-of",
                                               fmt::format("{} of {}", process + 1, job.processes)});
            const auto ended = runOurselves(arguments, interrupt.token());
            if (!ended) {
                printErrors(ended.errors());
                status = kCouldNotWrite;
                return false;
            }
            auto measured = *ended == kDone ? readStudy(times, interrupt.token())
                                            : pipeline::Error{{}, "a process that took times ended early", {}};
            std::error_code ignored;
            fs::remove(times, ignored);
            if (interrupt.asked() || *ended == kInterrupted) return cancelled();
            if (!measured) {
                printErrors(measured.errors());
                status = kCouldNotWrite;
                return false;
            }
            addTimes(*measured, report);
            if (!keep()) return false;
        }
        return true;
    }
};

// Why no point has both a time and the error of the plot: each reason once, in the order of the points.
std::string whyNoPoint(const pipeline::StudyAnalysis& analysis) {
    constexpr std::size_t kTold = 3;  // a reason may name its value: there are as many as points then
    std::vector<std::string_view> reasons;
    for (const pipeline::PointAnalysis& point : analysis.points)
        if (std::ranges::find(reasons, point.missing) == reasons.end()) reasons.emplace_back(point.missing);
    const std::size_t more = reasons.size() - std::min(reasons.size(), kTold);
    reasons.resize(reasons.size() - more);
    return fmt::format("{}{}", fmt::join(reasons, "; "), more == 0 ? "" : fmt::format("; and {} more", more));
}

}  // namespace

int studyCancelled(const StudyOrder& job) {
    tell("Cancelled. The same command goes on from here; what there is stands in {}\n",
         partFile(job.folder, job.request).string());
    return kInterrupted;
}

std::optional<StudyReport> runStudy(const StudyOrder& job, const Interrupt& interrupt, int& status) {
    Run run{job, interrupt, status, {}};
    if (!run.begin() || !run.findErrors()) return std::nullopt;
    // Before the times are taken, which would be taken for nothing.
    if (const std::string wrong = chooseError(job.request, run.report); !wrong.empty()) {
        tell("shadescope study: {}\n", wrong);
        status = kWrongUsage;
        return std::nullopt;
    }
    if (!run.measure()) return std::nullopt;
    return std::move(run.report);
}

int takeTimes(const pipeline::StudyRequest& request, const fs::path& file, const std::string& which,
              const Interrupt& interrupt) {
    StudyReport report = beginStudy(request);
    report.processes = 1;
    report.load = {pipeline::loadAverage()};
    {
        ProgressPrinter progress(which.empty() ? "Times" : "Times, process " + which);
        const auto show = [&](int done, int all) { progress.show(std::size_t(done), std::size_t(all), "rounds"); };
        if (!measureTimes(request, report.points, show, interrupt.token())) return kInterrupted;
    }
    if (const auto written = writeJson(report, file); !written) {
        printErrors(written.errors());
        return kCouldNotWrite;
    }
    return kDone;
}

int reportStudy(const StudyReport& report, pipeline::StudyLimits limits,
                const std::vector<pipeline::StudyPictures>& pictures, const fs::path& folder, bool json) {
    const pipeline::StudyAnalysis analysis = analyse(report, report.choice);
    const auto middle = middleOfFront(analysis).value_or(pipeline::StudyLimits());
    const bool hasNone = analysis.byTime.empty();
    const bool isNo = hasNone || (limits.error > 0 && !cheapestWithin(analysis, limits.error)) ||
                      (limits.milliseconds > 0 && !bestWithin(analysis, limits.milliseconds));
    if (limits.error == 0) limits.error = middle.error;
    if (limits.milliseconds == 0) limits.milliseconds = middle.milliseconds;
    const std::string inDoubt = pipeline::whyInDoubt(folder, "study.json", pipeline::readIndex(folder, "study.json"));
    const auto written = [&] {
        const LibraryGuard guard;
        return writeStudyFiles(report, analysis, limits, pictures, folder);
    }();
    if (!written) {
        printErrors(written.errors());
        return kCouldNotWrite;
    }
    if (!inDoubt.empty()) tell("{}: {}; the study there was replaced\n", folder.string(), inDoubt);
    if (json)
        say("{}", studyFileText(report));
    else
        say("{}", studyText(report, analysis, limits));
    tell("{} are in {}\n", fmt::join(*written, ", "), folder.string());
    if (hasNone) tell("No point of the study has both a time and an error: {}\n", whyNoPoint(analysis));
    return isNo ? kAnswerIsNo : kDone;
}

}  // namespace app
