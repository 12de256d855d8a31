#pragma once
#include "lessons/grading/class_marks.h"

// A class's marks for tables, for the tools of courses, and for people.

namespace lessons {

struct MarkedClass {
    std::string title;
    std::vector<StudentMarks> students;  // by their folders' names
    std::vector<std::string> refused;    // what is no hand-in, and why
};

// students.csv, moodle.csv (grades to import), junit.xml, class.json and class.html; the last names the others.
std::vector<std::pair<std::string, std::string>> classFiles(const MarkedClass& all);
// Of one student: index.html, results.json as Gradescope reads it, and marks.json. pages: of the tasks.
std::vector<std::pair<std::string, std::string>> studentFiles(const Course& course, const StudentMarks& student,
                                                              std::vector<std::pair<std::string, std::string>> pages);

}  // namespace lessons
