#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"

namespace lessons {

// The lessons that come with the program, in the order of their folders' names.
struct Library {
    std::vector<Lesson> lessons;
    pipeline::Errors errors;  // of those that could not be read
};
Library allLessons();

// A lesson by its folder's name; an unknown one is answered with the nearest.
pipeline::Result<Lesson> findLesson(std::string_view name);

// Where the lessons' folders are.
std::filesystem::path lessonFolder();

}  // namespace lessons
