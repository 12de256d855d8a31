#include "lessons/results.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "lessons/misconceptions.h"
#include "pipeline/core/printable.h"
#include "pipeline/export/json.h"
#include "pipeline/export/staging.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/key_places.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::Json;
using pipeline::Result;

constexpr std::size_t kMaxResultsBytes = std::size_t{8} << 20, kMostTriesKept = 1000;
constexpr std::array<std::string_view, 3> kOutcomes{"open", "right", "shown"};

Json toJson(const Progress& progress) {
    Json tries = Json::array();
    for (const Try& one : progress.tries)
        tries.push_back({{"given", one.given},
                         {"right", one.right},
                         {"mistake", one.mistake},
                         {"hints", one.hints},
                         {"seconds", one.seconds}});
    return {{"outcome", kOutcomes[std::size_t(progress.outcome)]}, {"hints", progress.hints}, {"tries", tries}};
}

// A value of a file that somebody may have changed; throws Json's own exceptions where it is of another kind.
Progress progressFrom(const Json& json) {
    Progress progress;
    const std::string outcome = json.at("outcome").get<std::string>();
    const auto found = std::ranges::find(kOutcomes, outcome);
    if (found == kOutcomes.end()) throw std::invalid_argument("no outcome " + outcome);
    progress.outcome = Progress::Outcome(found - kOutcomes.begin());
    progress.hints = json.at("hints").get<std::size_t>();
    for (const Json& one : json.at("tries")) {
        if (progress.tries.size() == kMostTriesKept) break;
        const double seconds = one.at("seconds").get<double>();
        progress.tries.push_back({pipeline::escapedControls(one.at("given").get<std::string>()),
                                  one.at("right").get<bool>(),
                                  pipeline::escapedControls(one.at("mistake").get<std::string>()),
                                  one.at("hints").get<std::size_t>(), std::isfinite(seconds) ? seconds : 0});
    }
    return progress;
}

}  // namespace

const Progress* Results::find(const Lesson& lesson, const Page& page) const {
    const auto pages = m_lessons.find(lesson.name);
    if (pages == m_lessons.end()) return nullptr;
    const auto found = pages->second.find(page.heading);
    return found == pages->second.end() ? nullptr : &found->second;
}

void Results::put(const Lesson& lesson, const Page& page, Progress progress) {
    m_lessons[lesson.name].insert_or_assign(page.heading, std::move(progress));
}

std::string toText(const Results& results) {
    Json json{{"version", 1}, {"lessons", Json::object()}};
    for (const auto& [lesson, pages] : results.lessons())
        for (const auto& [heading, progress] : pages) json["lessons"][lesson][heading] = toJson(progress);
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

Result<Results> parseResults(std::string_view text, const std::string& file) {
    Results results;
    try {
        const Json json = Json::parse(text);
        if (json.at("version") != 1) return Error{{file, 0, 0}, "found results of another version", "version 1"};
        for (const auto& [lesson, pages] : json.at("lessons").items())
            for (const auto& [heading, progress] : pages.items())
                results.m_lessons[lesson][heading] = progressFrom(progress);
    } catch (const std::exception& error) {
        return Error{{file, 0, 0}, std::string("these are no results: ") + pipeline::escapedControls(error.what())};
    }
    return results;
}

std::filesystem::path resultsFile() {
    const auto folder = [](const char* variable) -> std::filesystem::path {
        const char* const value = std::getenv(variable);
        return value && *value ? value : "";
    };
    std::filesystem::path data = folder("XDG_DATA_HOME");
    if (data.empty() || data.is_relative()) {
        data = folder("HOME");
        if (data.empty()) return {};
        data = data / ".local" / "share";
    }
    return data / "shadescope" / "results.json";
}

Result<Results> readResults(const std::filesystem::path& file) {
    std::error_code ignored;
    if (file.empty() || !std::filesystem::exists(file, ignored)) return Results();
    const auto text = pipeline::readFile(file, kMaxResultsBytes);
    if (!text) return pipeline::namedAt({file.string()}, text.errors());
    return parseResults(*text, file.string());
}

pipeline::Errors writeResults(const Results& results, const std::filesystem::path& file) {
    if (file.empty()) return {Error{{}, "no folder for results", "HOME or XDG_DATA_HOME in the environment"}};
    if (results.empty()) {
        std::error_code error;
        std::filesystem::remove(file, error);
        if (error) return {Error{{file.string(), 0, 0}, error.message()}};
        return {};
    }
    const auto written = pipeline::writeFiles({{file.filename().string(), toText(results)}}, file.parent_path());
    return written ? pipeline::Errors() : written.errors();
}

Summary summaryOf(const Lesson& lesson, const Results& results) {
    Summary summary;
    summary.isDone = true;
    for (std::size_t number = 0; number < lesson.pages.size(); ++number) {
        const Page& page = lesson.pages[number];
        if (!page.question) continue;
        const Progress* known = results.find(lesson, page);
        const Attempt attempt(*page.question, known ? *known : Progress());
        Summary::OfPage of{page.heading, attempt.state(), false, attempt.points(), attempt.full()};
        for (const Try& one : attempt.progress().tries) {
            if (one.mistake.empty()) continue;
            of.hadMistake = true;
            const auto same = std::ranges::find(summary.mistakes, one.mistake, &Summary::OwnMistake::id);
            if (same != summary.mistakes.end()) {
                ++same->times;
                continue;
            }
            const Misconception* row = findMisconception(one.mistake);
            summary.mistakes.push_back({one.mistake, row ? row->name : one.mistake, number, 1});
        }
        summary.points += of.points;
        summary.full += of.full;
        summary.isDone &= attempt.isSettled();
        summary.pages.push_back(std::move(of));
    }
    return summary;
}

}  // namespace lessons
