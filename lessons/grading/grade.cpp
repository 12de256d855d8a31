#include "lessons/grading/grade.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "lessons/library.h"
#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"
#include "pipeline/export/json/json_value.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/key_places.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::Errors;
using pipeline::Json;
using pipeline::Result;

constexpr std::size_t kMostHandInBytes = std::size_t{8} << 20, kMostPagesNamed = 3, kMostAnswers = 200;
constexpr std::size_t kMostQuestions = 5000, kMostGiven = 200, kMostName = 255;
constexpr std::size_t kMostSaid = 300;  // bytes of what a parser says, which may quote the file

// The answers to a sheet, by the number of the question.
struct SheetAnswers {
    std::size_t sheet = 0;
    std::string draw;  // empty: it names none
    std::map<std::size_t, std::string> given;
};

// Nothing where the file is no answer to a sheet.
Result<std::optional<SheetAnswers>> sheetAnswersIn(const std::string& text, const std::string& file) {
    SheetAnswers answers;
    try {
        const Json json = Json::parse(text);
        if (!json.find("sheet")) return std::optional<SheetAnswers>();
        if (json.at("version") != 1) return Error{{file, 0, 0}, "found answers of another version", "version 1"};
        answers.sheet = json.at("sheet").get<std::size_t>();
        if (json.find("draw"))
            answers.draw = pipeline::escapedControls(json["draw"].get<std::string>().substr(0, kMostName));
        for (const auto& [question, given] : json.at("answers").items()) {
            const auto number = numberIn(question);
            if (!number || !(*number >= 1) || *number > double(kMostAnswers))
                return Error{{file, 0, 0},
                             "found the answer " + pipeline::inQuotes(question),
                             "the number of a question, from 1"};
            if (given.is(Json::kStructured) ||
                given.is(Json::kNull))  // a list may be nested deeper than anybody can print
                return Error{{file, 0, 0},
                             "found no text and no number as the answer " + pipeline::inQuotes(question),
                             "\"0.77\" or 0.77"};
            answers.given[std::size_t(*number)] =
                given.is(Json::kString) ? pipeline::escapedControls(given.get<std::string>().substr(0, kMostGiven))
                                        : given.dump();
        }
    } catch (const std::exception& error) {
        return Error{
            {file, 0, 0},
            "this is no hand-in: " + pipeline::escapedControls(std::string_view(error.what()).substr(0, kMostSaid))};
    }
    return std::optional(std::move(answers));
}

// "B", "A, C" and "C, A, B" as indices; nothing where a letter is none.
std::optional<std::vector<std::size_t>> lettersOf(std::string_view text) {
    std::vector<std::size_t> letters;
    for (const char c : text) {
        if (c == ' ' || c == ',') continue;
        const char upper = c >= 'a' && c <= 'z' ? char(c - 32) : c;
        if (upper < 'A' || upper > 'I') return {};
        letters.push_back(std::size_t(upper - 'A'));
    }
    return letters;
}

// What was written on paper for a question of each kind, as the window would have it.
std::optional<Given> writtenFor(const NumberQuestion&, const std::string& text) { return Typed{text}; }
template <class Answer>
std::optional<Given> writtenLetters(const std::string& text) {
    const auto letters = lettersOf(text);
    return letters ? std::optional<Given>(Answer{*letters}) : std::nullopt;
}
std::optional<Given> writtenFor(const ChoiceQuestion&, const std::string& text) { return writtenLetters<Chosen>(text); }
std::optional<Given> writtenFor(const SeveralQuestion&, const std::string& text) {
    return writtenLetters<Chosen>(text);
}
std::optional<Given> writtenFor(const OrderQuestion&, const std::string& text) { return writtenLetters<Ordered>(text); }
std::optional<Given> writtenFor(const UntilQuestion&, const std::string&) { return {}; }
std::optional<Given> writtenFor(const WriteQuestion&, const std::string&) { return {}; }
std::optional<Given> writtenFor(const ClickQuestion& click, const std::string& text) {
    const std::size_t comma = text.find(',');
    if (click.kind == ThingKind::Pixel) {
        const auto x = numberIn(text.substr(0, comma));
        const auto y = comma == text.npos ? std::nullopt : numberIn(text.substr(comma + 1));
        if (!x || !y) return {};
        return Pick{.x = *x, .y = *y};
    }
    const auto number = numberIn(text.substr(std::min(text.find_first_of("0123456789"), text.size())));
    if (!number || !(*number >= 0) || *number > 1e9) return {};
    return pickOf({click.kind, std::size_t(*number)});
}
std::optional<Given> givenFor(const Question& question, const std::string& text) {
    return std::visit([&](const auto& kind) { return writtenFor(kind, text); }, question.kind);
}

class Grader {
public:
    Grader(const SheetKeys* sheets, const LinesRunner& run, const pipeline::Stop& stop)
        : m_sheets(sheets), m_run(run), m_stop(stop) {}

    Result<Graded> grade(std::span<const std::filesystem::path> files,
                         const std::function<void(std::size_t)>& progress) {
        nameStudents(files);
        for (std::size_t i = 0; i < files.size(); ++i) {
            if (progress) progress(i);
            if (m_stop.stop_requested()) return Error{{}, "stopped", {}};
            m_student = m_names[i];
            const std::size_t before = m_graded.answers.size();
            if (const Errors errors = add(files[i]); !errors.empty()) {
                if (m_stop.stop_requested()) return Error{{}, "stopped", {}};
                m_graded.answers.resize(before);
                m_graded.refused.push_back(errors.front());
                continue;
            }
            Graded::Student student{m_student, 0, 0};
            for (std::size_t k = before; k < m_graded.answers.size(); ++k)
                student.points += m_graded.answers[k].points, student.full += m_graded.answers[k].full;
            m_graded.students.push_back(std::move(student));
        }
        if (m_stop.stop_requested()) return Error{{}, "stopped", {}};
        m_graded.shared = mistakesOf(m_graded);
        if (m_stop.stop_requested()) return Error{{}, "stopped", {}};
        return std::move(m_graded);
    }

private:
    // "anna" of anna.json; where another file has this name too, "group 2/anna".
    void nameStudents(std::span<const std::filesystem::path> files) {
        for (const std::filesystem::path& file : files) m_names.push_back(pipeline::escaped(file.stem().string()));
        std::map<std::string, std::size_t> count;
        for (const std::string& name : m_names) ++count[name];
        for (std::size_t i = 0; i < files.size(); ++i)
            if (count[m_names[i]] > 1)
                m_names[i] = pipeline::escaped((files[i].parent_path().filename() / files[i].stem()).string());
    }

    Errors add(const std::filesystem::path& file) {
        std::error_code ignored;
        if (std::filesystem::is_symlink(file, ignored))
            return {{{file.string(), 0, 0}, "this is a link to another file", "a file of its own"}};
        const auto text = pipeline::readFile(file, kMostHandInBytes);
        if (!text) return pipeline::namedAt({file.string()}, text.errors());
        const auto sheet = sheetAnswersIn(*text, file.string());
        if (!sheet) return sheet.errors();
        if (*sheet) return addSheet(**sheet, file.string());
        const auto results = parseResults(*text, file.string());
        if (!results) return results.errors();
        if (results->empty()) return {{{file.string(), 0, 0}, "found no answer in it", "a hand-in with answers"}};
        std::size_t questions = 0;
        for (const auto& [lesson, pages] : results->lessons()) questions += pages.size();
        if (questions > kMostQuestions || results->lessons().size() > kMostAnswers)
            return {{{file.string(), 0, 0},
                     fmt::format("found {} questions of {} lessons", questions, results->lessons().size()),
                     fmt::format("at most {} of {}", kMostQuestions, kMostAnswers)}};
        for (const auto& [lesson, pages] : results->lessons()) {
            addLesson(lesson, pages);
            if (m_stop.stop_requested()) return {{{}, "stopped", {}}};
        }
        return {};
    }

    // A name of a hand-in leads to no other folder.
    const Lesson* lessonNamed(const std::string& name) {
        if (name.size() > kMostName || name.find('/') != name.npos || name.starts_with('.')) return nullptr;
        const auto [known, isNew] = m_lessons.try_emplace(name);
        if (isNew)
            if (auto lesson = findLesson(name, m_stop)) known->second = std::move(lesson).value();
        return known->second ? &*known->second : nullptr;
    }

    void addLesson(const std::string& name, const Results::Pages& pages) {
        const Lesson* const lesson = lessonNamed(name);
        std::vector<GradedAnswer> answers;
        for (const auto& [heading, progress] : pages) {
            GradedAnswer answer{
                m_student, pipeline::escaped(name), 0, {}, pipeline::escaped(heading), progress, 0, 0, {}, false};
            const Page* page = nullptr;
            for (std::size_t i = 0; lesson && i < lesson->pages.size(); ++i)
                if (lesson->pages[i].heading == heading && lesson->pages[i].question)
                    page = &lesson->pages[i], answer.place = i + 1, answer.page = pageName(*lesson, i);
            if (page) {
                const Attempt attempt(*page->question, progress);
                answer.points = attempt.points(), answer.full = attempt.full();
                if (const auto* write = std::get_if<WriteQuestion>(&page->question->kind))
                    runAgain(*write, *page, answer);
            } else {
                answer.note = lesson ? "the lesson has no such question" : "no such lesson here";
            }
            answers.push_back(std::move(answer));
        }
        std::ranges::stable_sort(answers, {}, &GradedAnswer::place);
        std::ranges::move(answers, std::back_inserter(m_graded.answers));
    }

    // The page has judged the lines; here they run once more. Who was shown the answer gets nothing for it.
    void runAgain(const WriteQuestion& write, const Page& page, GradedAnswer& answer) {
        const std::vector<Try>& tries = answer.progress.tries;
        if (tries.empty()) return;
        if (!m_run) return void(answer.note = "as the page judged: no Node.js here");
        const auto judged = judgedIn(write, page.first.state.scene, tries.back().given, m_run, m_stop);
        const bool isRight = judged && judged->verdict.isRight();
        answer.note = isRight == tries.back().right ? "run again" : "run again: the page had judged otherwise";
        if (isRight || answer.progress.outcome != Progress::Outcome::Right) return;
        answer.progress.outcome = Progress::Outcome::Open, answer.points = 0;
    }

    // Judged here, by the frames of the sheet's own scene.
    Errors addSheet(const SheetAnswers& handedIn, const std::string& file) {
        if (!m_sheets)
            return {{{file, 0, 0},
                     fmt::format("these are answers to sheet {}", handedIn.sheet),
                     "--sheets with the sheets.json that was written with it"}};
        const auto text = m_sheets->texts.find(handedIn.sheet);
        if (text == m_sheets->texts.end())
            return {{{file, 0, 0}, fmt::format("there is no sheet {}", handedIn.sheet), "one of sheets.json"}};
        const auto draw = m_sheets->draws.find(handedIn.sheet);
        const std::string known = draw == m_sheets->draws.end() ? "" : draw->second;
        if (handedIn.draw != known)
            return {{{file, 0, 0},
                     handedIn.draw.empty()
                         ? fmt::format("these answers to sheet {} name no draw", handedIn.sheet)
                         : fmt::format("these are answers to draw {} of sheet {}", handedIn.draw, handedIn.sheet),
                     known.empty() ? "answers to sheets without a draw, as sheets.json has them"
                                   : fmt::format("\"draw\": \"{}\", as sheets.json has it", known)}};
        const auto lesson = parseLesson(text->second, "sheets.json", [&](std::string_view name) {
            return sceneOfLesson(name, m_sheets->folder, m_stop);
        });
        if (!lesson) return lesson.errors();
        Errors errors;
        std::size_t question = 0;
        runPages(*lesson, m_stop, [&](const Page& page, std::size_t number, const PageFrames& frames) {
            if (!page.question) return;
            const auto given = handedIn.given.find(++question);
            GradedAnswer answer{m_student,
                                fmt::format("sheet {}", handedIn.sheet),
                                number + 1,
                                pageName(*lesson, number),
                                page.heading,
                                {},
                                0,
                                page.question->points,
                                {},
                                true};
            if (given == handedIn.given.end() || given->second.empty())
                answer.note = "not answered";
            else
                judgeInto(answer, *page.question, given->second, {.frame = *frames.first, .stop = m_stop}, errors);
            m_graded.answers.push_back(std::move(answer));
        });
        if (m_stop.stop_requested()) return {{{}, "stopped", {}}};
        if (!handedIn.given.empty() && handedIn.given.rbegin()->first > question)
            return {
                {{file, 0, 0},
                 fmt::format("found an answer {}", handedIn.given.rbegin()->first),
                 fmt::format("answers to the {} of the sheet", pipeline::plural(std::int64_t(question), "question"))}};
        return errors;
    }
    static void judgeInto(GradedAnswer& answer, const Question& question, const std::string& text,
                          const Context& context, Errors& errors) {
        const auto given = givenFor(question, text);
        if (!given) {
            answer.note = "no answer to such a question: " + pipeline::inQuotes(text);
            return;
        }
        Attempt attempt(question);
        const auto verdict = attempt.check(*given, context);
        if (!verdict)
            errors.insert(errors.end(), verdict.errors().begin(), verdict.errors().end());
        else if (verdict->mark == Mark::Again)
            answer.note = "not counted: " + verdict->said;
        answer.progress = attempt.progress();
        answer.points = attempt.points();
        if (!verdict || verdict->mark == Mark::Right || verdict->mark == Mark::Again) return;
        const auto* const order = std::get_if<OrderQuestion>(&question.kind);
        if (const auto right = order ? rightOrder(*order, context) : Error())
            answer.points = question.points * shareInOrder(*right, std::get<Ordered>(*given).items);
        // It is handed in once: a prediction that is all wrong counts neither way.
        if (question.isPrediction && answer.points == 0) answer.full = 0;
    }

    const SheetKeys* m_sheets;
    const LinesRunner& m_run;
    const pipeline::Stop& m_stop;
    std::vector<std::string> m_names;  // of the hand-ins
    std::string m_student;
    std::map<std::string, std::optional<Lesson>> m_lessons;
    Graded m_graded;
};

// Pages of lessons that name a misconception.
std::map<std::string, std::vector<std::string>> treatments(const std::set<std::string>& ids) {
    std::map<std::string, std::vector<std::string>> pages;
    for (const Lesson& lesson : allLessons().lessons)
        for (std::size_t i = 0; i < lesson.pages.size(); ++i) {
            if (!lesson.pages[i].question || lesson.pages[i].from) continue;
            for (const std::string& id : mistakeIds(*lesson.pages[i].question))
                if (ids.contains(id) && pages[id].size() < kMostPagesNamed)
                    pages[id].push_back(fmt::format("{}, page {}", lesson.title, pageName(lesson, i)));
        }
    return pages;
}

}  // namespace

Result<Graded> grade(std::span<const std::filesystem::path> files, const SheetKeys* sheets, const pipeline::Stop& stop,
                     const std::function<void(std::size_t)>& progress, const LinesRunner& run) {
    return Grader(sheets, run, stop).grade(files, progress);
}

std::vector<std::filesystem::path> handInsOf(std::span<const std::filesystem::path> paths) {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path& path : paths) {
        std::error_code error;
        if (!std::filesystem::is_directory(path, error)) {
            files.push_back(path);
            continue;
        }
        const std::size_t before = files.size();
        for (const auto& entry : std::filesystem::directory_iterator(path, error))
            if (entry.path().extension() == ".json") files.push_back(entry.path());
        if (files.size() == before) files.push_back(path);  // refused by its name, as what holds no hand-in
        std::sort(files.begin() + std::ptrdiff_t(before), files.end());
    }
    return files;
}

std::vector<SharedMistake> mistakesOf(const Graded& graded) {
    std::map<std::string, std::set<std::string>> students;
    std::map<std::string, std::size_t> times;
    for (const GradedAnswer& answer : graded.answers)
        for (const Try& one : answer.progress.tries)
            if (!one.mistake.empty()) students[one.mistake].insert(answer.student), ++times[one.mistake];
    std::set<std::string> ids;
    std::vector<SharedMistake> shared;
    for (const auto& [id, who] : students) {
        shared.push_back({id, mistakeName(id), who.size(), times[id], {}});
        ids.insert(id);
    }
    auto pages = treatments(ids);
    for (SharedMistake& one : shared) one.treatedBy = std::move(pages[one.id]);
    std::ranges::sort(shared, [](const SharedMistake& a, const SharedMistake& b) {
        return std::tuple(b.students, b.times, a.name) < std::tuple(a.students, a.times, b.name);
    });
    return shared;
}

}  // namespace lessons
