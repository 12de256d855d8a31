#pragma once
#include <functional>

#include "lessons/lesson.h"
#include "lessons/questions/write_run.h"

namespace lessons {

// Called before each page, from 0.
using CheckProgress = std::function<void(std::size_t page)>;

// What is wrong with a lesson that could be read, found by running every page as a reader would: answers that are not
// right, mistakes that are right or answered by another's sentence, choices of which not exactly one holds, first halves
// that tell the answer, texts that cannot be filled in, buffers that are not there. At most kMaxErrors, each with its
// place; "stopped" alone where it was stopped.
// run: for questions of kind write; without it their lines are not tried.
pipeline::Errors checkLesson(const Lesson& lesson, const pipeline::Stop& stop = {}, const CheckProgress& progress = {},
                             const LinesRunner& run = {});

// Of checkLesson: where a page tells its answer before it is asked for. Answers of fewer than three digits are not
// looked for in the texts.
pipeline::Errors leaksOf(const Page& page, const Context& context);

// Of checkLesson: what the words of a page, and what a hand can move on it, break of the rules that
// resources/manual/write-a-lesson.md lists.
pipeline::Errors heldErrorsOf(const Page& page, const PageFrames& frames, const pipeline::Stop& stop);

// How many words a text has; a hole counts as one.
std::size_t wordsIn(const Prose& prose);

// How long a lesson takes: a word a third of a second, half a minute a page, a minute and a half a question. Minutes.
double minutesOf(const Lesson& lesson);

}  // namespace lessons
