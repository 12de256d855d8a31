#pragma once
#include <string>
#include <vector>

#include "app/cli/cli.h"

namespace app {

// The program's commands and options as data, for what is written about them: the man page and the shells'
// completions.
struct OptionText {
    std::vector<std::string> names;    // "-o", "--output"; none for what is told by its place
    std::string value;                 // what it takes: "SCENE", "WxH"; empty for a flag
    std::string meaning;               // one line, without a full stop
    std::vector<std::string> choices;  // the only values that it takes; empty where there are others
    bool required = false, repeats = false;
};

struct CommandText {
    std::string name, meaning;
    std::vector<OptionText> options;  // as they were declared; those told by their place in their order among them
    std::vector<CommandText> commands;
    std::string footer;  // of the program alone
};

CommandText commandTree(const CliHost& host);

}  // namespace app
