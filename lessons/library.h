#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"

namespace lessons {

// The lessons that come with the program: each before the one that it names as the next, else in the order of their
// folders' names.
struct Library {
    std::vector<Lesson> lessons;
    pipeline::Errors errors;  // of those that could not be read
};
Library allLessons();
Library allOutlines();  // as readOutline

// A lesson's text, and of one that comes with the program, by its name.
pipeline::Result<LessonText> lessonText(const std::filesystem::path& folder, const pipeline::Stop& stop = {});
pipeline::Result<LessonText> otherLesson(std::string_view name, const pipeline::Stop& stop = {});

// The names of the lessons that come with the program, sorted.
std::vector<std::string> lessonNames();

// A lesson that comes with the program by its folder's name; any other by its folder, or the file lesson.md in it. An
// unknown one is answered with the nearest name.
pipeline::Result<Lesson> findLesson(std::string_view name, const pipeline::Stop& stop = {});

// The folder of a lesson that somebody calls by a path: the folder itself, or a file lesson.md; empty where it is neither.
std::filesystem::path lessonAt(const std::filesystem::path& path);

// The folder of a template of sheets: as lessonAt finds it, else the program's own template of that name, as "light".
// Empty if there is neither.
std::filesystem::path sheetTemplateAt(const std::filesystem::path& path);
// The names of the program's own templates, sorted.
std::vector<std::string> sheetTemplateNames();

// Where the lessons' folders are.
std::filesystem::path lessonFolder();

}  // namespace lessons
