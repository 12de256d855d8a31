#pragma once
#include "lessons/grading/class_marks.h"

namespace app {

// Runs what is handed in in a temporary folder with a copy of its files, so that the hand-in keeps its bytes. Each run is
// limited to the course's seconds and to 64 MB of output, the build to 60 s if that is more. That confines nothing.
lessons::OpensHandIn opensHandIn(const lessons::Course& course, const pipeline::Stop& stop);

// Of a course that runs programs unconfined: what they can do, and the line that confines them, on standard error.
void tellOfPrograms(const lessons::Course& course);

}  // namespace app
