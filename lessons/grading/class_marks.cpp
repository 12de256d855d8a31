#include "lessons/grading/class_marks.h"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/grading/class_page.h"
#include "lessons/grading/program_marks.h"
#include "pipeline/compare/report/compare_html.h"
#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"
#include "pipeline/export/folder/contents.h"
#include "pipeline/export/folder/file_hash.h"
#include "pipeline/formats/numbers/number_file.h"
#include "pipeline/formats/scene_folder.h"

namespace lessons {

namespace foreign = pipeline::foreign;
using pipeline::Error;
using pipeline::Json;

namespace {

constexpr std::size_t kMostEntries = 10000, kMostProblems = 20;

double sumOf(const StudentMarks& student, double TaskMarks::Mark::*member) {
    double sum = 0;
    for (const TaskMarks& task : student.tasks)
        for (const TaskMarks::Mark& mark : task.marks) sum += mark.*member;
    return sum;
}

std::string firstWrongOf(const foreign::Report& report) {
    std::string text;
    for (const pipeline::StageId stage : report.possiblyWrong)
        text += fmt::format("{}{}", text.empty() ? "" : " or ", stageInfo(stage).label);
    return text;
}

void shorten(std::vector<std::string>& problems) {
    if (problems.size() <= kMostProblems) return;
    const std::size_t more = problems.size() - kMostProblems;
    problems.resize(kMostProblems);
    problems.push_back(fmt::format("and {} more", more));
}

// The regular files of a folder, sorted.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder, pipeline::Errors& problems) {
    std::vector<std::filesystem::path> files;
    std::error_code failed;
    if (!is_directory(symlink_status(folder, failed))) {
        problems.push_back({{}, "there is no folder " + pipeline::inQuotes(folder.filename().string()), {}});
        return files;
    }
    std::size_t entries = 0;
    for (std::filesystem::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
        if (++entries > kMostEntries) {
            problems.push_back({{}, fmt::format("found more than {} files", kMostEntries), "fewer"});
            return {};
        }
        if (at->is_symlink(failed))
            problems.push_back(
                {{at->path().filename().string()}, "this is a link to another file: it is left out", {}});
        else if (at->is_regular_file(failed))
            files.push_back(at->path());
    }
    if (failed) problems.push_back({{}, "the folder cannot be read: " + failed.message(), {}});
    std::ranges::sort(files);
    return files;
}

// All files of a program and of the folders in it, but hidden ones. False where there is too much.
bool readProgram(const std::filesystem::path& folder, std::size_t most, std::size_t& size, HandInFiles::OfTask& files) {
    namespace fs = std::filesystem;
    std::error_code failed;
    std::size_t entries = 0;
    if (!is_directory(symlink_status(folder, failed))) {
        files.problems.push_back({{}, "there is no folder " + pipeline::inQuotes(folder.filename().string()), {}});
        return true;
    }
    for (fs::recursive_directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
        if (++entries > kMostEntries) return false;
        const std::string name = at->path().lexically_relative(folder).generic_string();
        if (at->path().filename().string().starts_with('.')) {
            at.disable_recursion_pending();
        } else if (at->is_symlink(failed)) {
            files.problems.push_back({{name}, "this is a link to another file: it is left out", {}});
        } else if (at->is_regular_file(failed)) {
            size += std::size_t(std::min<std::uintmax_t>(at->file_size(failed), pipeline::kMaxFileBytes + 1));
            if (size > most) return false;
            auto text = pipeline::readFile(at->path(), most);
            if (!text) return false;
            files.bytes[name] = std::move(text).value();
            if ((at->status(failed).permissions() & fs::perms::owner_exec) != fs::perms::none)
                files.executable.insert(name);
        }
    }
    if (failed) files.problems.push_back({{}, "the folder cannot be read: " + failed.message(), {}});
    return true;
}

// Whether the bytes of such a file are read; only the name of others is.
bool isRead(const std::filesystem::path& file, std::size_t lights) {
    return file.filename() == "mine.toml" || foreign::findHanded(file.stem().string(), lights).has_value();
}

}  // namespace

std::optional<NamedError> errorOf(const foreign::Report& report) {
    if (!report.suspects || report.suspects->candidates.empty()) return {};
    const pipeline::foreign::KnownError& first = report.suspects->candidates[0].error;
    NamedError out{{}, {}, first.lesson, first.heading};
    const bool areTogether = report.suspects->areTogether;
    for (const foreign::Candidate& one : report.suspects->candidates) {
        out.id += (out.id.empty() ? "" : areTogether ? "+" : "|") + one.error.id;
        out.name += (out.name.empty() ? "" : areTogether ? " and " : " or ") + one.error.name;
    }
    return out;
}

void addProblems(const pipeline::Errors& errors, std::vector<std::string>& to) {
    for (const Error& error : errors) to.push_back(pipeline::escaped(format(error)));
}

double StudentMarks::points() const { return sumOf(*this, &TaskMarks::Mark::points); }
double StudentMarks::of() const { return sumOf(*this, &TaskMarks::Mark::of); }

HandInFiles readHandIn(const Course& course, const std::filesystem::path& folder, const pipeline::Stop& stop) {
    HandInFiles out;
    std::string key = course.key;
    std::size_t size = 0;
    std::map<std::filesystem::path, HandInFiles::OfTask> programs;  // by their folders: several tasks may share one
    for (const Course::Task& task : course.tasks) {
        HandInFiles::OfTask files;
        const std::filesystem::path from = task.folder.empty() ? folder : folder / task.folder;
        if (task.program) {
            const auto [known, isNew] = programs.try_emplace(from);
            if (isNew && !readProgram(from, course.mostBytes, size, known->second)) size = course.mostBytes + 1;
            out.tasks.push_back(known->second);
            continue;
        }
        for (const auto& path : filesIn(from, files.problems)) {
            const std::string name = path.filename().string();
            const std::string ending = path.extension().string();
            const bool isNumbers = ending.size() > 1 && pipeline::readsNumbers(ending.substr(1));
            if (stop.stop_requested() || (!isNumbers && name != "mine.toml")) continue;
            std::string& bytes = files.bytes[name];
            if (!isRead(path, task.scene->lights.size())) continue;
            std::error_code failed;
            size += std::size_t(std::min<std::uintmax_t>(file_size(path, failed), pipeline::kMaxFileBytes + 1));
            if (size > course.mostBytes) break;
            auto text = pipeline::readFile(path, course.mostBytes);
            if (text) {
                bytes = std::move(text).value();
            } else {
                files.bytes.erase(name);
                for (Error error : text.errors()) error.where.file = name, files.problems.push_back(std::move(error));
            }
        }
        out.tasks.push_back(std::move(files));
    }
    if (size > course.mostBytes)
        for (HandInFiles::OfTask& task : out.tasks) {
            const auto limit = fmt::format("at most {} MB in one hand-in", course.mostBytes / (1000 * 1000));
            task = {{}, {{{}, "the files are too large", limit}}, {}};
        }
    for (const HandInFiles::OfTask& task : out.tasks) {
        for (const auto& [name, bytes] : task.bytes) key += fmt::format("{}\n{}\n", name, pipeline::sha256Of(bytes));
        key += format(task.problems) + '\n';
    }
    out.key = pipeline::sha256Of(key);
    return out;
}

TaskMarks::Mark markOf(const foreign::Report& report, const Course::Check& check) {
    TaskMarks::Mark mark{check.name, "no file", 0, check.points};
    std::size_t files = 0, right = 0, agree = 0, explained = 0;
    const std::vector<std::size_t> named = report.suspects ? report.suspects->files : std::vector<std::size_t>();
    for (std::size_t i = 0; i < report.findings.size(); ++i) {
        const foreign::Finding& finding = report.findings[i];
        if (check.stage ? finding.stage != *check.stage : finding.name.buffer != check.buffer.buffer) continue;
        ++files, agree += finding.agrees;
        const auto& own = report.own[i];
        right += finding.agrees || (check.stage && own && own->finding.agrees);
        explained += finding.agrees || std::ranges::find(named, i) != named.end();
    }
    if (files == 0) return mark;
    const bool isExplained = explained == files;
    mark.points = right == files ? check.points : isExplained ? check.points / 2 : 0;
    mark.words = agree == files   ? "agrees"
                 : right == files ? "right with what it got"
                 : isExplained    ? "differs; one known error explains the files"
                                  : "differs";
    return mark;
}

pipeline::Result<std::monostate> Marker::markFiles(std::size_t number, const std::string& student,
                                                   const HandInFiles::OfTask& files, const pipeline::Stop& stop,
                                                   Marked& out) {
    const Course::Task& task = m_course.tasks[number];
    if (!m_references[number]) {
        auto made = foreign::makeReference(*task.scene, {}, stop);
        if (!made) return Error{{}, "cancelled", {}};
        m_references[number] = std::make_shared<const foreign::Reference>(std::move(*made));
    }
    foreign::CompareOptions options;
    options.hints = m_course.hints, options.stop = stop;
    std::map<std::string, std::string_view> bytes;
    for (const auto& [name, text] : files.bytes) bytes[name] = text;
    TaskMarks marks;
    marks.task = task.name;
    addProblems(files.problems, marks.problems);
    const auto report = compareRenderer(*task.scene, m_references[number],
                                        foreign::readHandedIn(bytes, *m_references[number]->frame), student, options);
    if (stop.stop_requested()) return Error{{}, "cancelled", {}};
    if (report) {
        marks.isCompared = true;
        marks.headline = headline(*report), marks.hints = hints(*report);
        marks.firstWrong = firstWrongOf(*report), marks.error = errorOf(*report);
        for (const std::string& other : report->in->others) marks.problems.push_back(pipeline::escaped(other));
        addProblems(report->in->errors, marks.problems);
        marks.pages.push_back(task.name);
        out.pages.emplace_back(task.name,
                               reportHtml(*report, fmt::format("shadescope compare SCENE {}", out.marks.student)));
    } else {
        marks.headline = "Nothing could be compared.";
        addProblems(report.errors(), marks.problems);
        out.pages.emplace_back(task.name, classPage(task.name, marks.headline, {}));  // in place of an earlier one
    }
    for (const Course::Check& check : task.checks)
        marks.marks.push_back(report ? markOf(*report, check)
                                     : TaskMarks::Mark{check.name, "no file", 0, check.points});
    out.marks.tasks.push_back(std::move(marks));
    return std::monostate();
}

pipeline::Result<Marker::Marked> Marker::mark(const std::string& student, const HandInFiles& files,
                                              const pipeline::Stop& stop) {
    Marked out{{pipeline::escaped(student), files.key, {}}, {}};
    for (std::size_t i = 0; i < m_course.tasks.size(); ++i) {
        const Course::Task& task = m_course.tasks[i];
        if (!task.program) {
            if (const auto marked = markFiles(i, student, files.tasks[i], stop, out); !marked) return marked.errors();
        } else {
            MarkedProgram marked = markProgram(m_course, task, files.tasks[i], m_open, stop);
            if (stop.stop_requested()) return Error{{}, "cancelled", {}};
            out.marks.tasks.push_back(std::move(marked.marks));
            std::ranges::move(marked.pages, std::back_inserter(out.pages));
        }
        shorten(out.marks.tasks.back().problems);
    }
    return out;
}

Json toJson(const StudentMarks& student) {
    Json json{{"version", 1},          {"program", pipeline::programMark()}, {"student", student.student},
              {"key", student.key},    {"points", student.points()},         {"of", student.of()},
              {"tasks", Json::array()}};
    for (const TaskMarks& task : student.tasks) {
        Json marks = Json::array();
        for (const TaskMarks::Mark& mark : task.marks)
            marks.push_back({{"name", mark.name}, {"words", mark.words}, {"points", mark.points}, {"of", mark.of}});
        Json error;
        if (task.error)
            error = {{"id", task.error->id},
                     {"name", task.error->name},
                     {"lesson", task.error->lesson},
                     {"heading", task.error->heading}};
        json["tasks"].push_back({{"task", task.task},
                                 {"compared", task.isCompared},
                                 {"headline", task.headline},
                                 {"first_wrong", task.firstWrong},
                                 {"error", error},
                                 {"hints", task.hints},
                                 {"problems", task.problems},
                                 {"pages", task.pages},
                                 {"marks", marks}});
    }
    return json;
}

std::optional<StudentMarks> marksFromJson(const std::string& text) {
    const auto texts = [](const Json& list) {
        std::vector<std::string> out;
        for (const Json& one : list) out.push_back(one.text());
        return out;
    };
    try {
        const Json json = Json::parse(text);
        StudentMarks student{json.at("student").text(), json.at("key").text(), {}};
        for (const Json& from : json.at("tasks")) {
            TaskMarks task{from.at("task").text(),
                           from.at("headline").text(),
                           from.at("first_wrong").text(),
                           {},
                           texts(from.at("hints")),
                           texts(from.at("problems")),
                           {},
                           from.at("compared").get<bool>(),
                           texts(from.at("pages"))};
            if (const Json& error = from.at("error"); error.is(Json::kObject))
                task.error = {error.at("id").text(), error.at("name").text(), error.at("lesson").text(),
                              error.at("heading").text()};
            for (const Json& mark : from.at("marks"))
                task.marks.push_back({mark.at("name").text(), mark.at("words").text(), mark.at("points").get<double>(),
                                      mark.at("of").get<double>()});
            student.tasks.push_back(std::move(task));
        }
        return student;
    } catch (const std::exception&) {
        return {};
    }
}

}  // namespace lessons
