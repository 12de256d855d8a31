#include "lessons/questions/results.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "pipeline/core/printable.h"
#include "pipeline/export/folder/staging.h"
#include "pipeline/export/json/json_value.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/key_places.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::Json;
using pipeline::Result;

constexpr std::size_t kMaxResultsBytes = std::size_t{8} << 20, kMostTriesKept = 1000;
constexpr std::size_t kMostSaid = 300;  // bytes of what a parser says, which may quote the file

// A value of a file that somebody may have changed; throws Json's own exceptions where it is of another kind.
Progress progressFrom(const Json& json) {
    Progress progress;
    const std::string outcome = json.at("outcome").get<std::string>();
    const auto found = std::ranges::find(kOutcomeNames, outcome);
    if (found == kOutcomeNames.end()) throw std::invalid_argument("no outcome " + outcome);
    progress.outcome = Progress::Outcome(found - kOutcomeNames.begin());
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

Result<Results> parseResults(std::string_view text, const std::string& file) {
    Results results;
    try {
        const Json json = Json::parse(text);
        if (json.at("version") != 1) return Error{{file, 0, 0}, "found results of another version", "version 1"};
        for (const auto& [lesson, pages] : json.at("lessons").items())
            for (const auto& [heading, progress] : pages.items())
                results.m_lessons[lesson][heading] = progressFrom(progress);
        for (const Json& lesson : json["done"])
            results.m_done.push_back(pipeline::escapedControls(lesson.get<std::string>()));
    } catch (const std::exception& error) {
        return Error{
            {file, 0, 0},
            "these are no results: " + pipeline::escapedControls(std::string_view(error.what()).substr(0, kMostSaid))};
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
            summary.mistakes.push_back({one.mistake, mistakeName(one.mistake), number, 1});
        }
        summary.points += of.points;
        summary.full += of.full;
        summary.isDone &= attempt.isSettled();
        summary.pages.push_back(std::move(of));
    }
    return summary;
}

}  // namespace lessons
