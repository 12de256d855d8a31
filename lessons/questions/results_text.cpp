// Results as text: the part of results.h that a live page needs too, which has no files.
#include <algorithm>
#include <array>

#include "lessons/questions/misconceptions.h"
#include "lessons/questions/results.h"
#include "pipeline/export/json/json_value.h"

namespace lessons {

using pipeline::Json;

namespace {

Json toJson(const Progress& progress) {
    Json tries = Json::array();
    for (const Try& one : progress.tries)
        tries.push_back({{"given", one.given},
                         {"right", one.right},
                         {"mistake", one.mistake},
                         {"hints", one.hints},
                         {"seconds", one.seconds}});
    return {{"outcome", kOutcomeNames[std::size_t(progress.outcome)]}, {"hints", progress.hints}, {"tries", tries}};
}

}  // namespace

std::string mistakeName(std::string_view id) {
    if (const Misconception* row = findMisconception(id)) return row->name;
    for (std::size_t i = 0; i < pipeline::kOwnCount; ++i)
        for (const pipeline::OwnMistake& one : ownContract(pipeline::OwnFunction(i)).mistakes)
            if (one.id == id) return std::string(one.name);
    return std::string(id);
}

const Progress* Results::find(const std::string& lesson, const std::string& heading) const {
    const auto pages = m_lessons.find(lesson);
    if (pages == m_lessons.end()) return nullptr;
    const auto found = pages->second.find(heading);
    return found == pages->second.end() ? nullptr : &found->second;
}

void Results::put(const Lesson& lesson, const Page& page, Progress progress) {
    m_lessons[lesson.name].insert_or_assign(page.heading, std::move(progress));
    const auto isOpen = [&](const Page& one) {
        const Progress* known = one.question && !one.from ? find(lesson, one) : nullptr;
        return one.question && !one.from && (!known || known->outcome == Progress::Outcome::Open);
    };
    if (!lesson.pages.empty() && std::ranges::none_of(lesson.pages, isOpen) &&
        std::ranges::find(m_done, lesson.name) == m_done.end())
        m_done.push_back(lesson.name);
}

std::string toText(const Results& results) {
    Json json{{"version", 1}, {"lessons", Json::object()}};
    for (const auto& [lesson, pages] : results.lessons())
        for (const auto& [heading, progress] : pages) json["lessons"][lesson][heading] = toJson(progress);
    if (!results.done().empty()) json["done"] = results.done();
    return json.dump(1) + '\n';
}

}  // namespace lessons
