#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"
#include "lessons/questions/attempt.h"

// What somebody has answered: kept in one file on this machine, and nowhere else.

namespace lessons {

// As files and tables have the outcomes of Progress.
inline constexpr std::array<std::string_view, 3> kOutcomeNames{"open", "right", "shown"};

// What a mistake is called, by its id: as its row of misconceptions.md says, or the function that somebody wrote (own.h). The
// id itself where neither knows it any more.
std::string mistakeName(std::string_view id);

class Results {
public:
    // Null where nothing was answered on this page yet. A page is known by its heading, so that pages may move.
    const Progress* find(const Lesson& lesson, const Page& page) const { return find(lesson.name, page.heading); }
    const Progress* find(const std::string& lesson, const std::string& heading) const;
    void put(const Lesson& lesson, const Page& page, Progress progress);
    void forget() { *this = {}; }
    void forget(const std::string& lesson) {
        m_lessons.erase(lesson);
        std::erase(m_done, lesson);
    }
    bool empty() const { return m_lessons.empty(); }
    // The progress of each page by its heading, of each lesson by its name.
    using Pages = std::map<std::string, Progress>;
    const std::map<std::string, Pages>& lessons() const { return m_lessons; }
    // Names of the lessons of which every question was settled, in the order in which they came to that.
    const std::vector<std::string>& done() const { return m_done; }
    bool operator==(const Results&) const = default;

private:
    friend pipeline::Result<Results> parseResults(std::string_view text, const std::string& file);
    std::map<std::string, Pages> m_lessons;
    std::vector<std::string> m_done;
};

// JSON; parseResults gives the same back. Errors name `file`.
std::string toText(const Results& results);
pipeline::Result<Results> parseResults(std::string_view text, const std::string& file);

// Where they are kept: results.json in $XDG_DATA_HOME/shadescope, else in ~/.local/share/shadescope. Empty where there is
// no such folder to be.
std::filesystem::path resultsFile();
// Nothing answered where there is no file yet.
pipeline::Result<Results> readResults(const std::filesystem::path& file);
// Whole or not at all; the folder is made. Without any result the file is removed.
pipeline::Errors writeResults(const Results& results, const std::filesystem::path& file);

// The end of a lesson.
struct Summary {
    struct OfPage {
        std::string heading;
        Attempt::State state = Attempt::State::Open;
        bool hadMistake = false;  // right after a known one
        double points = 0, full = 0;
    };
    std::vector<OfPage> pages;  // those with a question
    double points = 0, full = 0;
    bool isDone = false;  // every question is settled
    struct OwnMistake {
        std::string id, name;
        std::size_t page = 0;  // the first on which it was made, from 0
        std::size_t times = 0;
    };
    std::vector<OwnMistake> mistakes;  // in the order in which they were first made
};
Summary summaryOf(const Lesson& lesson, const Results& results);

}  // namespace lessons
