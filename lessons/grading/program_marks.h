#pragma once
#include "lessons/grading/class_marks.h"

// A program of a student's, run in the scenes of a task and marked.

namespace lessons {

struct MarkedProgram {
    TaskMarks marks;
    std::vector<std::pair<std::string, std::string>> pages;  // of scenes that are not hidden: name and HTML
};

// Runs and judges the program in every scene of the task. Each scene has an equal part of the points: all of it where the
// results agree, half where a known mistake explains them, else none. Hidden scenes are "hidden 1", "hidden 2", and of them
// nothing is said that the program was handed or has printed. After a run that was ended at a limit the others are left out.
// Worth nothing where it was stopped.
MarkedProgram markProgram(const Course& course, const Course::Task& task, const HandInFiles::OfTask& files,
                          const OpensHandIn& open, const pipeline::Stop& stop);

}  // namespace lessons
