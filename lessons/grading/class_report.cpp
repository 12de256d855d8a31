#include "lessons/grading/class_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "lessons/grading/class_page.h"
#include "lessons/grading/csv_text.h"
#include "pipeline/core/text.h"
#include "pipeline/export/folder/contents.h"
#include "pipeline/export/html/html_text.h"

namespace lessons {

namespace {

using pipeline::element;
using pipeline::Json;
using Files = std::vector<std::pair<std::string, std::string>>;

std::string pointsText(double value) { return pipeline::shortestText(value); }

double pointsOf(const TaskMarks& task) {
    double points = 0;
    for (const TaskMarks::Mark& mark : task.marks) points += mark.points;
    return points;
}

// What is taken from a hand-in is no path of a page: %2F, %20.
std::string inAddress(std::string_view name) {
    std::string out;
    for (const char c : name) {
        const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
                             c == '_' || c == '.';
        out += isPlain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return out;
}

std::string studentLink(const std::string& student) {
    return fmt::format("<a href=\"students/{}/index.html\">{}</a>", inAddress(student), pipeline::escapedHtml(student));
}

std::string studentsCsv(const MarkedClass& all) {
    std::string text = "student,points,of";
    if (!all.students.empty())
        for (const TaskMarks& task : all.students[0].tasks)
            text += fmt::format(",{0},{0} first wrong,{0} error", task.task);
    text += ",notes\n";
    for (const StudentMarks& student : all.students) {
        text +=
            fmt::format("{},{},{}", csvCell(student.student), pointsText(student.points()), pointsText(student.of()));
        std::size_t notes = 0;
        for (const TaskMarks& task : student.tasks) {
            text += fmt::format(",{},{},{}", pointsText(pointsOf(task)), csvCell(task.firstWrong),
                                csvCell(task.error ? task.error->id : ""));
            notes += task.problems.size();
        }
        text += fmt::format(",{}\n", student.isCompared() ? std::to_string(notes) : "nothing could be compared");
    }
    return text;
}

// Folders of Moodle's "Download all submissions" are called "Anna Berg_1234567_assignsubmission_file"; its number is the
// participant's in the grading worksheet. Other names are taken for identifiers.
std::string moodleCsv(const MarkedClass& all) {
    std::string text = "Identifier,Full name,Grade,Maximum Grade,Feedback comments\n";
    for (const StudentMarks& student : all.students) {
        std::string identifier = student.student, name = student.student;
        if (const auto end = name.find("_assignsubmission_"); end != name.npos) {
            const auto number = name.rfind('_', end - 1);
            if (end > 0 && number != name.npos && number + 1 < end &&
                name.find_first_not_of("0123456789", number + 1) == end) {
                identifier = "Participant " + name.substr(number + 1, end - number - 1);
                name.resize(number);
            }
        }
        std::string feedback;
        for (const TaskMarks& task : student.tasks)
            feedback += fmt::format("{}{}: {}", feedback.empty() ? "" : " ", task.task, task.headline);
        text += fmt::format("{},{},{},{},{}\n", csvCell(identifier), csvCell(name), pointsText(student.points()),
                            pointsText(student.of()), csvCell(feedback));
    }
    return text;
}

std::string junitXml(const MarkedClass& all) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    const auto quoted = [](const std::string& words) { return '"' + pipeline::escapedHtml(words) + '"'; };
    for (const StudentMarks& student : all.students) {
        std::size_t tests = 0, failures = 0;
        std::string cases;
        for (const TaskMarks& task : student.tasks)
            for (const TaskMarks::Mark& mark : task.marks) {
                ++tests;
                cases += fmt::format("<testcase classname={} name={}", quoted(student.student + '.' + task.task),
                                     quoted(mark.name));
                if (mark.points < mark.of) {
                    ++failures;
                    cases += fmt::format("><failure message={}>{}</failure></testcase>\n", quoted(mark.words),
                                         pipeline::escapedHtml(task.headline));
                } else {
                    cases += "/>\n";
                }
            }
        text += fmt::format("<testsuite name={} tests=\"{}\" failures=\"{}\">\n{}</testsuite>\n",
                            quoted(student.student), tests, failures, cases);
    }
    return text + "</testsuites>\n";
}

// Students with an error, by its id.
struct ClassError {
    NamedError error;
    std::vector<std::string> students;
};
std::vector<ClassError> errorsOf(const MarkedClass& all) {
    std::map<std::string, ClassError> byId;
    for (const StudentMarks& student : all.students)
        for (const TaskMarks& task : student.tasks) {
            if (!task.error) continue;
            ClassError& one = byId[task.error->id];
            one.error = *task.error;
            if (one.students.empty() || one.students.back() != student.student) one.students.push_back(student.student);
        }
    std::vector<ClassError> errors;
    for (auto& [id, one] : byId) errors.push_back(std::move(one));
    std::ranges::stable_sort(errors, std::greater<>(), [](const ClassError& one) { return one.students.size(); });
    return errors;
}

std::string lessonText(const NamedError& error) {
    return error.lesson.empty() ? "" : fmt::format("{}, page “{}”", error.lesson, error.heading);
}

std::string classAsJson(const MarkedClass& all) {
    Json json{{"version", 1},
              {"program", pipeline::programMark()},
              {"title", all.title},
              {"students", Json::array()},
              {"errors", Json::array()},
              {"refused", all.refused}};
    for (const StudentMarks& student : all.students) json["students"].push_back(toJson(student));
    for (const ClassError& one : errorsOf(all))
        json["errors"].push_back({{"id", one.error.id},
                                  {"name", one.error.name},
                                  {"lesson", one.error.lesson},
                                  {"heading", one.error.heading},
                                  {"students", one.students}});
    return json.dump(1) + '\n';
}

std::string classHtml(const MarkedClass& all) {
    std::string errors, stages, students, refused;
    for (const ClassError& one : errorsOf(all)) {
        std::string who;
        for (const std::string& student : one.students) who += (who.empty() ? "" : ", ") + studentLink(student);
        errors += "<tr>" + element("td", one.error.name) + "<td>" + shareBar(one.students.size(), all.students.size()) +
                  "</td>" + element("td", lessonText(one.error)) + "<td>" + who + "</td></tr>\n";
    }
    std::map<std::pair<std::string, std::string>, std::size_t> first;
    for (const StudentMarks& student : all.students) {
        students += "<tr><td>" + studentLink(student.student) + "</td>" +
                    element("td class=number", pointsText(student.points())) +
                    element("td class=number", pointsText(student.of())) + "<td>";
        for (const TaskMarks& task : student.tasks) {
            if (!task.firstWrong.empty()) ++first[{task.task, task.firstWrong}];
            students += element("div", fmt::format("{}: {}{}", task.task, task.headline,
                                                   task.error ? " (" + task.error->name + ")" : ""));
        }
        students += "</td></tr>\n";
    }
    for (const auto& [where, count] : first)
        stages += "<tr>" + element("td", where.first) + element("td", where.second) + "<td>" +
                  shareBar(count, all.students.size()) + "</td></tr>\n";
    for (const std::string& one : all.refused) refused += element("li", one) + '\n';
    if (errors.empty())
        errors = "<p>No hand-in has an error that the program knows.</p>\n";
    else
        errors = classTable("<th>Error</th><th>Students</th><th>Treated by the lesson</th><th>Who</th>", errors);
    std::string body = classSection("Errors of the class", errors);
    if (!stages.empty())
        body += classSection("First wrong stages", classTable("<th>Task</th><th>Stage</th><th>Students</th>", stages));
    body += classSection(
        "Students",
        classTable("<th>Student</th><th class=number>Points</th><th class=number>of</th><th>Finding</th>", students));
    if (!refused.empty()) body += classSection("No hand-ins", "<ul>\n" + refused + "</ul>\n");
    const std::string count = pipeline::plural(std::int64_t(all.students.size()), "hand-in");
    return classPage(all.title, all.title.empty() ? count : all.title + ": " + count, body);
}

std::string studentHtml(const Course& course, const StudentMarks& student) {
    std::string body;
    for (const TaskMarks& task : student.tasks) {
        std::string section = element("p", task.headline) + '\n', rows, notes;
        for (const TaskMarks::Mark& mark : task.marks)
            rows += "<tr>" + element("td", mark.name) + element("td", mark.words) +
                    element("td class=number", pointsText(mark.points)) +
                    element("td class=number", pointsText(mark.of)) + "</tr>\n";
        section +=
            classTable("<th>Part</th><th>Finding</th><th class=number>Points</th><th class=number>of</th>", rows);
        for (const std::string& note : task.problems) notes += element("li", note) + '\n';
        if (!notes.empty()) section += "<ul>\n" + notes + "</ul>\n";
        for (const std::string& page : task.pages)
            section += fmt::format("<p><a href=\"{}.html\">{}</a></p>\n", page,
                                   page == task.task ? "Pictures, the worst pixel and hints"
                                                     : page.substr(page.find('.') + 1) + ": results and pictures");
        if (course.hints >= 3 && task.error && !task.error->lesson.empty())
            section += element("p class=remark", "Treated by " + lessonText(*task.error) + '.');
        body += classSection(task.task, section);
    }
    return classPage(
        student.student,
        fmt::format("{}: {} of {} points", student.student, pointsText(student.points()), pointsText(student.of())),
        body);
}

// https://gradescope-autograders.readthedocs.io: the format of results.json.
std::string gradescopeJson(const Course& course, const StudentMarks& student) {
    Json json{{"score", student.points()}, {"output", course.title}, {"tests", Json::array()}};
    for (const TaskMarks& task : student.tasks) {
        std::string more = task.headline;
        for (const std::string& hint : task.hints) more += '\n' + hint;
        for (const std::string& problem : task.problems) more += '\n' + problem;
        for (const TaskMarks::Mark& mark : task.marks)
            json["tests"].push_back({{"name", task.task + ": " + mark.name},
                                     {"score", mark.points},
                                     {"max_score", mark.of},
                                     {"status", mark.points < mark.of ? "failed" : "passed"},
                                     {"output", mark.points < mark.of ? mark.words + '\n' + more : mark.words}});
    }
    return json.dump(1) + '\n';
}

}  // namespace

Files classFiles(const MarkedClass& all) {
    return {{"students.csv", studentsCsv(all)},
            {"moodle.csv", moodleCsv(all)},
            {"junit.xml", junitXml(all)},
            {"class.html", classHtml(all)},
            {"class.json", classAsJson(all)}};
}

Files studentFiles(const Course& course, const StudentMarks& student, Files pages) {
    Files files;
    for (auto& [task, html] : pages) files.emplace_back(task + ".html", std::move(html));
    files.emplace_back("index.html", studentHtml(course, student));
    files.emplace_back("results.json", gradescopeJson(course, student));
    files.emplace_back("marks.json", toJson(student).dump(1) + '\n');
    return files;
}

}  // namespace lessons
