#pragma once
#include <string>
#include <vector>

#include "app/cli/command_tree.h"

// What a shell offers after the Tab key, made from the program's tables.
namespace manual {

// What an option or a place takes.
struct Offered {
    std::vector<std::string> words{};  // "color", "shading=flat"; a key alone ends in '='
    bool list = false;                 // several, with commas between them
    bool files = false, folders = false;
};
// By the option's own choices, else by the name of its value: "SCENE", "DIR".
Offered offeredFor(const app::OptionText& option);

std::string bashCompletion(const app::CommandText& program);
std::string zshCompletion(const app::CommandText& program);
std::string fishCompletion(const app::CommandText& program);

}  // namespace manual
