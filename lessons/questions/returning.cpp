#include "lessons/questions/returning.h"

#include <map>

#include "lessons/lesson_text.h"

// Pages of other lessons that return at the start of one.

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::Result;

// A page whose question returns, as it begins another lesson.
Page again(Page page, const Lesson& lesson, const Lesson::Return& from, const LessonText& text) {
    page.heading = headingAgain(page.heading);
    page.from = {from.lesson, from.page, text.folder};
    const std::string words = "*From \"" + lesson.title + "\", page " + std::to_string(from.page) + ".*\n\n";
    for (Prose* prose : {&page.first.text, &page.first.paper})
        if (!prose->pieces.empty()) prose->pieces.front().insert(0, words);
    return page;
}

}  // namespace

std::string headingAgain(const std::string& heading) { return "Again: " + heading; }

Result<std::vector<Page>> readReturning(std::span<const Lesson::Return> returns, const LessonSource& lessonNamed) {
    Complaints complaints;
    std::map<std::string, std::set<std::size_t>> wanted;
    for (const Lesson::Return& one : returns)
        if (!wanted[one.lesson].insert(one.page).second) complaints.add(one.where, "this page returns a second time");
    std::map<std::string, std::optional<std::pair<LessonText, Lesson>>> sources;
    std::vector<Page> pages;
    for (const Lesson::Return& one : returns) {
        const auto [source, isNew] = sources.try_emplace(one.lesson);
        if (isNew) {
            auto text = lessonNamed ? lessonNamed(one.lesson) : Error{{}, "no page of another lesson returns here"};
            auto read = text ? parseReturning(*text, wanted[one.lesson]) : text.errors();
            if (!read) complaints.add(one.where, read.errors());
            if (read) source->second.emplace(std::move(text).value(), std::move(read).value());
        }
        if (!source->second) continue;
        const auto& [text, from] = *source->second;
        if (one.page > from.pages.size())
            complaints.add(one.where, "found page " + std::to_string(one.page),
                           "a page from 1 to " + std::to_string(from.pages.size()));
        else if (!from.pages[one.page - 1].question)
            complaints.add(one.where, "this page asks nothing", "a page with a question");
        else
            pages.push_back(again(from.pages[one.page - 1], from, one, text));
    }
    return complaints.empty() ? Result<std::vector<Page>>(std::move(pages)) : complaints.take();
}

Result<Lesson> parseLesson(std::string_view text, const std::string& file, const SceneSource& sceneNamed,
                           const LessonSource& lessonNamed) {
    auto lesson = parseOwnPages(text, file, sceneNamed);
    if (!lesson || lesson->returns.empty()) return lesson;
    auto returning = readReturning(lesson->returns, lessonNamed);
    if (!returning) return returning.errors();
    Lesson whole = std::move(lesson).value();
    whole.pages.insert(whole.pages.begin(), returning->begin(), returning->end());
    return whole;
}

}  // namespace lessons
