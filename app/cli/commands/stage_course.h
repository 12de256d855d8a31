#pragma once
#include <string>

namespace app {

// stage --course: the hand-in of one student, marked as compare --class marks it.
struct StageCourse {
    std::string course;
    std::string folder;  // of the hand-in
    std::string output;  // for the pages; empty: none
    bool json = false, force = false;
};

// Prints the findings and points, and writes the student's pages. Gives the exit status: that the answer is no where a point
// is missing.
int runStageCourse(const StageCourse& request);

}  // namespace app
