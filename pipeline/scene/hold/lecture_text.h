#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pipeline/scene/scene.h"

// Scenes and objects as the text files of lecture 1 have them, with one vertex and one polygon a line.

namespace pipeline {

struct LectureLine {
    int number = 0;  // of the file, where each list is one line; 0 where a line of the file goes on
    std::string text;
    std::string meaning;                // "vertex 4"
    std::optional<std::size_t> vertex;  // whose line this is
};
std::vector<LectureLine> objectLines(const Object& object);
// objectFile: the name of every object's file. Nothing of a scene that such a file cannot say: a look-at camera, a light at a
// place.
std::vector<LectureLine> sceneLines(const Scene& scene, const std::string& objectFile);

}  // namespace pipeline
