#include <fmt/format.h>

#include <algorithm>

#include "pipeline/study/run_study.h"

namespace pipeline {
namespace {

void append(const TimeSamples& from, TimeSamples& to) {
    to.processes.insert(to.processes.end(), from.processes.begin(), from.processes.end());
}

void addTimes(const StudyPoint& from, StudyPoint& to) {
    append(from.frame, to.frame);
    for (std::size_t i = 0; i < kStageCount; ++i) append(from.stages[i], to.stages[i]);
}

// What makes two reports parts of the same study; the member that differs, or nothing.
std::string difference(const StudyReport& a, const StudyReport& b) {
    if (a.scene != b.scene) return fmt::format("the scenes are {} and {}", a.scene, b.scene);
    if (a.geometry != b.geometry) return fmt::format("the scenes, both {}, have other meshes or turns", a.scene);
    if (a.version != b.version) return fmt::format("the programs are {} and {}", a.version, b.version);
    if (a.width != b.width || a.height != b.height) return "the pictures have different sizes";
    if (a.axes != b.axes) return "the sweeps differ";
    for (const auto& [key, value] : a.settings)
        if (const auto other = b.settings.find(key); other == b.settings.end() || other->second != value)
            return fmt::format("{} is {} and {}", key, value, other == b.settings.end() ? "not there" : other->second);
    if (a.settings.size() != b.settings.size()) return "one of them has more settings";
    if (a.threads != b.threads) return fmt::format("the frames ran on {} and {} threads", a.threads, b.threads);
    if (a.warmups != b.warmups || a.repeats != b.repeats) return "the numbers of frames differ";
    return {};
}

}  // namespace

void addErrorBars(const std::vector<ErrorRow>& bars, StudyReport& report) {
    for (const ErrorRow& bar : bars) {
        const auto isSame = [&](const ErrorRow& row) { return row.buffer == bar.buffer && row.measure == bar.measure; };
        const auto place = std::ranges::find_if(report.errorBars, isSame);
        if (place == report.errorBars.end()) {
            report.errorBars.push_back(bar);
            continue;
        }
        for (std::size_t kind = 0; kind < kErrorKinds; ++kind)
            place->value[kind] = std::max(place->value[kind], bar.value[kind]);  // of which one is none: the other
    }
}

namespace {

// Whether a report holds the very times that another one holds: no two frames take the same time to the last digit, again
// and again. One frame a point may, but not at every point.
bool measuresAgain(const StudyReport& from, const StudyReport& of) {
    std::size_t both = 0, same = 0;
    bool again = false;
    for (const StudyPoint& point : from.points) {
        const auto place = std::ranges::find(of.points, point.number, &StudyPoint::number);
        if (place == of.points.end()) continue;
        for (const auto& process : point.frame.processes) {
            const auto& there = place->frame.processes;
            const bool isThere = std::ranges::find(there, process) != there.end();
            again = again || (isThere && process.size() > 1);
            both += !there.empty(), same += isThere;
        }
    }
    return again || (both > 0 && same == both);
}

// Machines that differ are told side by side: their times are not one sample, but each point's are.
void addWords(std::string& words, const std::string& more) {
    if (words.find(more) == words.npos) words += (words.empty() ? "" : "; ") + more;
}

void mergePoint(const StudyPoint& from, StudyPoint& to) {
    if (to.errors.empty()) {
        to.errors = from.errors, to.blame = from.blame, to.counters = from.counters, to.megabytes = from.megabytes;
        if (to.failure.empty()) to.failure = from.failure;
    }
    addTimes(from, to);
}

void mergeReport(const StudyReport& from, StudyReport& to) {
    for (const StudyPoint& point : from.points) {
        const auto place = std::ranges::lower_bound(to.points, point.number, {}, &StudyPoint::number);
        if (place != to.points.end() && place->number == point.number)
            mergePoint(point, *place);
        else
            to.points.insert(place, point);
    }
    for (std::size_t i = 0; i < kErrorKinds; ++i) {
        if (to.references[i].empty()) to.references[i] = from.references[i];
        if (to.whyNone[i].empty()) to.whyNone[i] = from.whyNone[i];
    }
    addErrorBars(from.errorBars, to);
    if (to.errorWhy.empty()) to.errorWhy = from.errorWhy;
    to.load.insert(to.load.end(), from.load.begin(), from.load.end());
    addWords(to.machine, from.machine);
    addWords(to.compiler, from.compiler);
}

// Parts that hold times of the same points have more together than each of them; a part that was interrupted has fewer
// than it was to have.
void countProcesses(StudyReport& report) {
    std::size_t most = 0;
    for (const StudyPoint& point : report.points) most = std::max(most, point.frame.processes.size());
    if (most > 0) report.processes = int(most);
}

}  // namespace

void addTimes(const StudyReport& from, StudyReport& to) {
    for (const StudyPoint& point : from.points) {
        const auto place = std::ranges::find(to.points, point.number, &StudyPoint::number);
        if (place != to.points.end()) addTimes(point, *place);
    }
    to.load.insert(to.load.end(), from.load.begin(), from.load.end());
}

Result<StudyReport> mergeStudies(std::vector<StudyReport> parts) {
    StudyReport merged = std::move(parts.front());
    for (std::size_t i = 1; i < parts.size(); ++i) {
        if (const std::string differs = difference(merged, parts[i]); !differs.empty())
            return Error{{}, fmt::format("part {} is of another study than part 1: {}", i + 1, differs), {}};
        if (measuresAgain(parts[i], merged))
            return Error{{}, fmt::format("part {} has times that a part before has too", i + 1), "each part once"};
        mergeReport(parts[i], merged);
    }
    countProcesses(merged);
    return merged;
}

std::size_t missingPoints(const StudyReport& report) { return pointCount(report.axes) - report.points.size(); }

}  // namespace pipeline
