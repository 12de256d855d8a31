// A graded class as a table, as JSON and as a page.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "lessons/grading/class_page.h"
#include "lessons/grading/csv_text.h"
#include "lessons/grading/grade.h"
#include "lessons/questions/misconceptions.h"
#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"
#include "pipeline/export/folder/staging.h"
#include "pipeline/export/html/html_text.h"
#include "pipeline/export/json/json_value.h"

namespace lessons {

namespace {

using pipeline::element;
using pipeline::Json;

constexpr std::size_t kMostShown = 3;  // misconceptions of the class

std::string plain(double value) { return pipeline::shortestText(value); }

std::string outcomeOf(const GradedAnswer& answer) {
    return std::string(kOutcomeNames[std::size_t(answer.progress.outcome)]);
}

// The answers to one question, of all students.
struct OfQuestion {
    std::string lesson, heading, page;
    std::size_t place = 0, answers = 0, right = 0, atOnce = 0;
    std::map<std::string, std::size_t> mistakes;  // students, by the misconception's id
};
std::vector<OfQuestion> questionsOf(const Graded& graded) {
    std::vector<OfQuestion> questions;
    for (const GradedAnswer& answer : graded.answers) {
        if (answer.progress.tries.empty() && answer.progress.outcome == Progress::Outcome::Open) continue;
        const std::string lesson = answer.onSheet ? "all sheets" : answer.lesson;
        auto found = std::ranges::find_if(
            questions, [&](const OfQuestion& one) { return one.lesson == lesson && one.heading == answer.heading; });
        if (found == questions.end())
            found = questions.insert(found, {lesson, answer.heading, answer.page, answer.place, 0, 0, 0, {}});
        const bool right = answer.progress.outcome == Progress::Outcome::Right;
        ++found->answers;
        found->right += right;
        found->atOnce += right && answer.progress.tries.size() == 1 && answer.progress.hints == 0;
        std::set<std::string> own;
        for (const Try& one : answer.progress.tries) own.insert(one.mistake);
        own.erase("");
        for (const std::string& id : own) ++found->mistakes[id];
    }
    std::ranges::stable_sort(questions, [](const OfQuestion& a, const OfQuestion& b) {
        return std::pair(a.lesson, a.place) < std::pair(b.lesson, b.place);
    });
    return questions;
}

std::string nameOf(const std::string& id) {
    const Misconception* const row = findMisconception(id);
    return row ? row->name : id;
}

std::string mistakeItems(const std::vector<SharedMistake>& shared, std::size_t students) {
    std::string list;
    for (std::size_t i = 0; i < std::min(kMostShown, shared.size()); ++i) {
        const SharedMistake& one = shared[i];
        list += "<li>" + element("b", one.name) + ' ' +
                element("span",
                        fmt::format("{} of {}, {}", one.students, pipeline::plural(std::int64_t(students), "student"),
                                    pipeline::plural(std::int64_t(one.times), "answer")));
        if (!one.treatedBy.empty())
            list +=
                "<br>" + element("span class=remark", fmt::format("Treated by {}.", fmt::join(one.treatedBy, "; ")));
        list += "</li>\n";
    }
    return list.empty() ? "<p>No answer has a mistake that the program knows.</p>\n" : "<ol>\n" + list + "</ol>\n";
}

std::string questionRows(const Graded& graded) {
    std::string rows;
    for (const OfQuestion& one : questionsOf(graded)) {
        std::vector<std::pair<std::size_t, std::string>> mistakes;
        for (const auto& [id, students] : one.mistakes) mistakes.emplace_back(students, nameOf(id));
        std::ranges::sort(mistakes, [](const auto& a, const auto& b) {
            return std::pair(b.first, a.second) < std::pair(a.first, b.second);
        });
        std::vector<std::string> words;
        for (const auto& [students, name] : mistakes) words.push_back(fmt::format("{} ({})", name, students));
        rows += "<tr>" + element("td", one.lesson) +
                element("td", one.page.empty() ? one.heading : one.page + ' ' + one.heading) +
                element("td class=number", std::to_string(one.answers)) + "<td>" + shareBar(one.right, one.answers) +
                "</td>" + element("td class=number", percent(one.atOnce, one.answers)) +
                element("td", fmt::format("{}", fmt::join(words, ", "))) + "</tr>\n";
    }
    return rows;
}

}  // namespace

std::string toCsv(const Graded& graded) {
    std::string text =
        "student,lesson,page,question,outcome,answer,right,mistakes,tries,hints,seconds,points,of,note\n";
    for (const GradedAnswer& answer : graded.answers) {
        const auto& tries = answer.progress.tries;
        std::vector<std::string> mistakes;
        for (const Try& one : tries)
            if (!one.mistake.empty()) mistakes.push_back(one.mistake);
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csvCell(answer.student),
                            csvCell(answer.lesson), answer.page, csvCell(answer.heading), outcomeOf(answer),
                            csvCell(tries.empty() ? "" : tries.back().given),
                            answer.progress.outcome == Progress::Outcome::Right ? "yes" : "no",
                            csvCell(fmt::format("{}", fmt::join(mistakes, " "))), tries.size(), answer.progress.hints,
                            plain(tries.empty() ? 0 : tries.back().seconds), plain(answer.points), plain(answer.full),
                            csvCell(answer.note));
    }
    return text;
}

std::string studentsCsv(const Graded& graded) {
    std::string text = "student,points,of,answers,right,mistakes\n";
    for (const Graded::Student& student : graded.students) {
        std::size_t answers = 0, right = 0;
        std::set<std::string> mistakes;
        for (const GradedAnswer& answer : graded.answers) {
            if (answer.student != student.name) continue;
            answers += !answer.progress.tries.empty(), right += answer.progress.outcome == Progress::Outcome::Right;
            for (const Try& one : answer.progress.tries) mistakes.insert(one.mistake);
        }
        mistakes.erase("");
        text += fmt::format("{},{},{},{},{},{}\n", csvCell(student.name), plain(student.points), plain(student.full),
                            answers, right, csvCell(fmt::format("{}", fmt::join(mistakes, " "))));
    }
    return text;
}

std::string toJson(const Graded& graded) {
    Json json{{"version", 1},
              {"students", Json::array()},
              {"answers", Json::array()},
              {"misconceptions", Json::array()},
              {"refused", Json::array()}};
    for (const Graded::Student& student : graded.students)
        json["students"].push_back({{"student", student.name}, {"points", student.points}, {"of", student.full}});
    for (const GradedAnswer& answer : graded.answers) {
        Json tries = Json::array();
        for (const Try& one : answer.progress.tries)
            tries.push_back({{"given", one.given},
                             {"right", one.right},
                             {"mistake", one.mistake},
                             {"hints", one.hints},
                             {"seconds", one.seconds}});
        json["answers"].push_back({{"student", answer.student},
                                   {"lesson", answer.lesson},
                                   {"page", answer.page},
                                   {"question", answer.heading},
                                   {"outcome", outcomeOf(answer)},
                                   {"tries", tries},
                                   {"hints", answer.progress.hints},
                                   {"points", answer.points},
                                   {"of", answer.full},
                                   {"note", answer.note}});
    }
    for (const SharedMistake& one : graded.shared)
        json["misconceptions"].push_back({{"id", one.id},
                                          {"name", one.name},
                                          {"students", one.students},
                                          {"answers", one.times},
                                          {"treated_by", one.treatedBy}});
    for (const pipeline::Error& one : graded.refused)
        json["refused"].push_back({{"file", pipeline::escaped(one.where.file)}, {"why", pipeline::escaped(one.found)}});
    return json.dump(1) + '\n';
}

std::string toHtml(const Graded& graded) {
    std::string students;
    for (const Graded::Student& student : graded.students)
        students += "<tr>" + element("td", student.name) + element("td class=number", plain(student.points)) +
                    element("td class=number", plain(student.full)) + "</tr>\n";
    std::string refused;
    for (const pipeline::Error& one : graded.refused)
        refused += element("li", pipeline::escaped(pipeline::format(one))) + '\n';
    std::string notes;
    for (const GradedAnswer& answer : graded.answers)
        if (!answer.note.empty())
            notes += element("li", fmt::format("{}, {}, {}: {}", answer.student, answer.lesson, answer.heading,
                                               answer.note)) +
                     '\n';
    std::string body = classSection("Misconceptions of the class", mistakeItems(graded.shared, graded.students.size()));
    body += classSection("Questions",
                         classTable("<th>Lesson</th><th>Question</th><th class=number>Answers</th><th>Right</th><th "
                                    "class=number>At once</th><th>Mistakes (students)</th>",
                                    questionRows(graded)));
    body += classSection("Students",
                         classTable("<th>Student</th><th class=number>Points</th><th class=number>of</th>", students));
    if (!notes.empty()) body += classSection("Notes", "<ul>\n" + notes + "</ul>\n");
    if (!refused.empty()) body += classSection("Hand-ins that could not be read", "<ul>\n" + refused + "</ul>\n");
    return classPage("Class",
                     fmt::format("{}, {}", pipeline::plural(std::int64_t(graded.students.size()), "student"),
                                 pipeline::plural(std::int64_t(graded.answers.size()), "answer")),
                     body);
}

std::vector<std::string> gradedFiles() { return {"class.csv", "students.csv", "class.json", "class.html"}; }

pipeline::Result<std::vector<std::string>> writeGraded(const Graded& graded, const std::filesystem::path& folder) {
    const std::vector<std::string> names = gradedFiles();
    return pipeline::writeFiles({{names[0], toCsv(graded)},
                                 {names[1], studentsCsv(graded)},
                                 {names[2], toJson(graded)},
                                 {names[3], toHtml(graded)}},
                                folder);
}

}  // namespace lessons
