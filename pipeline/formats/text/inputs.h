#pragma once
#include "pipeline/formats/scene_folder.h"

// What a command reads, which it may not replace. In scene_folder.cpp, where all files are opened.
namespace pipeline {

// readFile() of a file that the program writes again by itself, as an index: it is no input.
Result<std::string> readOwnFile(const std::filesystem::path& file, std::size_t limit = kMaxFileBytes);

// While one lives, the files that are read are remembered as inputs, which no command may replace. A window has none: who
// saves a scene means its file.
class InputMemory {
public:
    InputMemory();
    ~InputMemory();
    InputMemory(const InputMemory&) = delete;
    InputMemory& operator=(const InputMemory&) = delete;
};
// Whether the file, under whatever name, was read meanwhile.
bool isInput(const std::filesystem::path& file);

}  // namespace pipeline
