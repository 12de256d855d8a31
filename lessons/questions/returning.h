#pragma once
#include <set>
#include <span>

#include "lessons/lesson.h"

namespace lessons {

// The heading of a page that returns, by its own.
std::string headingAgain(const std::string& heading);

// The pages that these name, in their order, each as it begins another lesson. Errors: a page that is not there, asks
// nothing, or is named twice.
pipeline::Result<std::vector<Page>> readReturning(std::span<const Lesson::Return> pages,
                                                  const LessonSource& lessonNamed);

// A lesson's pages of these numbers, from 1, as they return in another one: with what their lines "again" change. Its
// other pages are empty.
pipeline::Result<Lesson> parseReturning(const LessonText& text, const std::set<std::size_t>& wanted);

}  // namespace lessons
