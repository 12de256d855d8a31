#pragma once
#include <optional>
#include <string>

#include "lessons/lesson.h"
#include "lessons/state/window_state.h"
#include "pipeline/export/json/json_value.h"

namespace lessons {

// A lesson, and the files that a page has to have for it, by name.
struct LiveLesson {
    Lesson lesson;
    pipeline::Json files = pipeline::Json::object();
};
// folderName: of its folder; empty where it has none.
pipeline::Result<LiveLesson> readLive(const LessonText& from, const std::string& folderName);

// What the script of a live page opens a lesson from; the lesson's prose becomes HTML. nextFile: where the lesson after this
// one is, empty where a page does not lead there. leftOut: pictures that no lesson may bring along.
pipeline::Result<pipeline::Json> liveData(LiveLesson& live, const LessonText& from, const std::string& nextFile,
                                          pipeline::Errors& leftOut);

// A lesson of one page made of a scene: see makeLivePage().
LessonText sceneAsLesson(const pipeline::Scene& scene, std::string_view title, std::string_view look,
                         const std::optional<WindowState>& shown, const pipeline::Stop& stop);

}  // namespace lessons
