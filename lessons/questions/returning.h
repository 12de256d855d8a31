#pragma once
#include <set>

#include "lessons/lesson.h"

namespace lessons {

// A lesson's pages of these numbers, from 1, as they return in another one: with what their lines "again" change. Its
// other pages are empty.
pipeline::Result<Lesson> parseReturning(const LessonText& text, const std::set<std::size_t>& wanted);

}  // namespace lessons
