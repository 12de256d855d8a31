#pragma once
#include <string>
#include <vector>

#include "pipeline/core/result.h"

namespace app {

// compare --class.
struct ClassRequest {
    std::string course, handedIn, folder, shard, commands;
    bool restart = false, force = false;
    double pass = 0;  // per cent
};

// Marks the hand-ins of a folder, one folder a student, and publishes each when it is marked; those that are there
// already, of the same course and files, stay. Then the files of the class, unless it is a part. Gives the exit status.
int runClass(const ClassRequest& request);

// Writes what a shell runs to start this program with each of these arguments, one command a line.
pipeline::Result<std::monostate> writeCommands(const std::string& file,
                                               const std::vector<std::vector<std::string>>& commands);

}  // namespace app
