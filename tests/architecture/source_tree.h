#pragma once
#include <string>
#include <vector>

namespace architecture {

struct SourceFile {
    std::string path;  // from the project's root, with '/': "pipeline/run/runner.cpp"
    std::vector<std::string> lines;
};
using SourceTree = std::vector<SourceFile>;

// Every text file below root in the order of the paths; not .git, not what .gitignore names.
SourceTree readSourceTree(const std::string& root);

// Names of the files and folders at the root, sorted; not .git, not what .gitignore names.
std::vector<std::string> topLevel(const std::string& root);

}  // namespace architecture
