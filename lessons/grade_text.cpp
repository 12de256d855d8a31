// A graded class as a table, as JSON and as a page.
#include <fmt/format.h>

#include <algorithm>

#include "lessons/csv_text.h"
#include "lessons/grade.h"
#include "lessons/handout_figure.h"
#include "lessons/misconceptions.h"
#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/html_text.h"
#include "pipeline/export/json_value.h"
#include "pipeline/export/staging.h"

namespace lessons {

namespace {

using pipeline::element;
using pipeline::Json;

constexpr std::size_t kMostShown = 3;  // misconceptions of the class
constexpr std::string_view kClassStyle = R"(
section { margin-top: 2rem; padding-top: 1.25rem; border-top: 1px solid #D0D5DC; }
.number { text-align: right; } .remark, footer { color: #4A525D; font-size: .875rem; }
table { border-collapse: collapse; } th, td { padding: .25rem .75rem .25rem 0; text-align: left; vertical-align: top; }
th { border-bottom: 1px solid #171A1F; } td { border-bottom: 1px solid #D0D5DC; }
.bar { display: inline-block; width: 8rem; height: .6rem; background: #E3E8EE; } .bar span { display: block; height: 100%; background: #137244; }
footer { margin-top: 3rem; }
@media print { main { max-width: none; padding: 0; } body { font-size: 11pt; } tr, li { break-inside: avoid; } }
)";

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

std::string percent(std::size_t part, std::size_t all) {
    return all == 0 ? "–" : fmt::format("{:.0f} %", 100.0 * double(part) / double(all));
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
        const double share = one.answers == 0 ? 0 : 100.0 * double(one.right) / double(one.answers);
        rows += "<tr>" + element("td", one.lesson) +
                element("td", one.page.empty() ? one.heading : one.page + ' ' + one.heading) +
                element("td class=number", std::to_string(one.answers)) +
                fmt::format("<td><span class=bar><span style=\"width: {:.0f}%\"></span></span> {}</td>", share,
                            percent(one.right, one.answers)) +
                element("td class=number", percent(one.atOnce, one.answers)) +
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
    const auto section = [](std::string_view heading, const std::string& body) {
        return "<section>\n" + element("h2", heading) + '\n' + body + "</section>\n";
    };
    std::string body = section("Misconceptions of the class", mistakeItems(graded.shared, graded.students.size()));
    body += section("Questions",
                    "<table><thead><tr><th>Lesson</th><th>Question</th><th class=number>Answers</th><th>Right</th><th "
                    "class=number>At once</th><th>Mistakes (students)</th></tr></thead><tbody>\n" +
                        questionRows(graded) + "</tbody></table>\n");
    body +=
        section("Students",
                "<table><thead><tr><th>Student</th><th class=number>Points</th><th class=number>of</th></tr></thead>"
                "<tbody>\n" +
                    students + "</tbody></table>\n");
    if (!notes.empty()) body += section("Not counted", "<ul>\n" + notes + "</ul>\n");
    if (!refused.empty()) body += section("Hand-ins that could not be read", "<ul>\n" + refused + "</ul>\n");
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>Class</title>\n<style>{}{}</style>\n</head>\n"
        "<body>\n<main>\n<h1>{}</h1>\n{}<footer>Shadescope {}</footer>\n</main>\n</body>\n</html>\n",
        paperStyle(), kClassStyle,
        fmt::format("{}, {}", pipeline::plural(std::int64_t(graded.students.size()), "student"),
                    pipeline::plural(std::int64_t(graded.answers.size()), "answer")),
        body, pipeline::escapedHtml(pipeline::programVersion()));
}

std::vector<std::string> gradedFiles() { return {"class.csv", "class.json", "class.html"}; }

pipeline::Result<std::vector<std::string>> writeGraded(const Graded& graded, const std::filesystem::path& folder) {
    const std::vector<std::string> names = gradedFiles();
    return pipeline::writeFiles({{names[0], toCsv(graded)}, {names[1], toJson(graded)}, {names[2], toHtml(graded)}},
                                folder);
}

}  // namespace lessons
