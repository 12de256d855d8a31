#pragma once
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "lessons/grading/course.h"
#include "pipeline/compare/verdict.h"
#include "pipeline/export/json/json_value.h"

// A hand-in, of renderers' files or of programs, marked.

namespace lessons {

// An error that explains what a student handed in, or several that explain it equally well.
struct NamedError {
    std::string id, name;         // "no-max|half-lambert", "A or B"
    std::string lesson, heading;  // about the first; may be empty
};

struct TaskMarks {
    struct Mark {
        std::string name, words;  // of the course's check; "agrees", "no file"
        double points = 0, of = 0;
    };
    std::string task, headline;
    std::string firstWrong;  // "Normals or Shading"; empty where all agrees or nothing tells
    std::optional<NamedError> error;
    std::vector<std::string> hints, problems;
    std::vector<Mark> marks;
    bool isCompared = false;         // else no file or no result could be
    std::vector<std::string> pages;  // without ".html"
};

struct StudentMarks {
    std::string student;  // the folder's name, escaped
    std::string key;      // a hash of the course and the files
    std::vector<TaskMarks> tasks;
    double points() const;
    double of() const;
    bool isCompared() const { return std::ranges::any_of(tasks, &TaskMarks::isCompared); }
};

pipeline::Json toJson(const StudentMarks& marks);
// Nothing where the text is not what toJson writes.
std::optional<StudentMarks> marksFromJson(const std::string& text);

// The files of one hand-in that can be read, by task. Links are left out, and so is everything where there is too much.
struct HandInFiles {
    struct OfTask {
        std::map<std::string, std::string> bytes;  // by the file's name; of programs by its path in the folder
        pipeline::Errors problems;
        std::set<std::string> executable;  // of programs
    };
    std::vector<OfTask> tasks;
    std::string key;
};
HandInFiles readHandIn(const Course& course, const std::filesystem::path& folder, const pipeline::Stop& stop);

// Runs a command where the files of a hand-in are, and hands it a text.
using RunsCommand = std::function<pipeline::Result<pipeline::foreign::ProgramOutput>(const std::string& command,
                                                                                     const std::string& input)>;
// Makes a folder with these files, which is gone with the last copy of what runs in it.
using OpensHandIn = std::function<pipeline::Result<RunsCommand>(const HandInFiles::OfTask& files)>;

// Marks hand-ins, one at a time. What the program makes of a scene is made once for all.
class Marker {
public:
    // open: for courses that run programs.
    Marker(const Course& course, OpensHandIn open)
        : m_course(course), m_open(std::move(open)), m_references(course.tasks.size()) {}
    // With the pages of each task, by the task's name. An error only where it was stopped.
    struct Marked {
        StudentMarks marks;
        std::vector<std::pair<std::string, std::string>> pages;
    };
    pipeline::Result<Marked> mark(const std::string& student, const HandInFiles& files, const pipeline::Stop& stop);

private:
    pipeline::Result<std::monostate> markFiles(std::size_t task, const std::string& student,
                                               const HandInFiles::OfTask& files, const pipeline::Stop& stop,
                                               Marked& out);

    const Course& m_course;
    OpensHandIn m_open;
    std::vector<std::shared_ptr<const pipeline::foreign::Reference>> m_references;
};

// The points of one check. Stage: all where it agrees, or is right with what it got. Buffer: all where it agrees. Half
// where it differs and a known error explains the files. No file has none.
TaskMarks::Mark markOf(const pipeline::foreign::Report& report, const Course::Check& check);
std::optional<NamedError> errorOf(const pipeline::foreign::Report& report);
void addProblems(const pipeline::Errors& errors, std::vector<std::string>& to);

}  // namespace lessons
