#pragma once
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lessons/grading/sheet.h"
#include "lessons/questions/results.h"
#include "lessons/questions/write_run.h"

// A class's hand-ins: what each student answered, and which misconceptions they share.

namespace lessons {

// One question of one student.
struct GradedAnswer {
    std::string student;    // the hand-in's name
    std::string lesson;     // its name, or "sheet 7"
    std::size_t place = 0;  // of the page, from 1; 0 where the lesson has no such page any more
    std::string page;       // what it is called (pageName), or empty
    std::string heading;
    Progress progress;
    double points = 0, full = 0;
    std::string note;      // why it could not be counted, or how it was judged; may be empty
    bool onSheet = false;  // one of several, which ask the same with other numbers
};

// How often a misconception was met.
struct SharedMistake {
    std::string id, name;
    std::size_t students = 0, times = 0;
    std::vector<std::string> treatedBy;  // "Which way it faces, page 2": pages of lessons that name it, at most 3
};

struct Graded {
    struct Student {
        std::string name;
        double points = 0, full = 0;  // full: of the questions in this hand-in
    };
    std::vector<Student> students;      // in the order of the hand-ins
    std::vector<GradedAnswer> answers;  // student by student, page by page
    // What could not be read: the file, and why. The others are graded all the same.
    pipeline::Errors refused;
    std::vector<SharedMistake> shared;  // mistakesOf() these answers: it reads all lessons, so once
};

// Grades hand-ins: results as the window and the pages write them (lessons/questions/results.h), or the answers to a sheet,
// {"version": 1, "sheet": 7, "answers": {"1": "0.77", "2": "B"}}, where sheets were given. Two hand-ins of one name are
// told apart by their folders. An order that is partly right has its share of the points on a sheet (shareInOrder in
// judge.h): it is handed in once. A link is refused: what it leads to is another one's. progress: of the hand-in that is
// read, from 0. run: runs lines of questions of kind write again; without it the page's verdict counts. "stopped" is the only error.
pipeline::Result<Graded> grade(std::span<const std::filesystem::path> files, const SheetKeys* sheets,
                               const pipeline::Stop& stop = {},
                               const std::function<void(std::size_t handIn)>& progress = {},
                               const LinesRunner& run = {});

// Of each folder its files *.json in the order of their names, without those of folders in it; of anything else the path.
std::vector<std::filesystem::path> handInsOf(std::span<const std::filesystem::path> paths);

// Those of most students first, then of most times, then by name.
std::vector<SharedMistake> mistakesOf(const Graded& graded);

// The same as a table for a spreadsheet, as JSON, and as a page for the teacher.
std::string toCsv(const Graded& graded);
std::string studentsCsv(const Graded& graded);  // one row a student
std::string toJson(const Graded& graded);
std::string toHtml(const Graded& graded);
// class.csv, students.csv, class.json and class.html, all or none. Gives their names.
std::vector<std::string> gradedFiles();  // their names
pipeline::Result<std::vector<std::string>> writeGraded(const Graded& graded, const std::filesystem::path& folder);

}  // namespace lessons
