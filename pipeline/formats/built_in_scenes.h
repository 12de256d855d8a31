#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace pipeline {

// Scenes that come with the program.
struct BuiltInScene {
    std::string name;   // "pyramid"
    std::string title;  // "Pyramid"
    std::string look;   // what to look at, one sentence
    std::filesystem::path file;
};
std::vector<BuiltInScene> builtInScenes();

// Where resources/ is: ../share/shadescope from an installed program, else the source tree.
std::filesystem::path resourceFolder();

}  // namespace pipeline
