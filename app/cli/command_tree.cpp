#include "app/cli/command_tree.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/cli/commands.h"

namespace app {

namespace {

// CLI11 keeps the value and its choices in one text: "FORMAT:{text,csv}", "N:INT in [0 - 1024]", "SWEEP REQUIRED".
void readType(const std::string& type, OptionText& option) {
    const std::size_t begin = type.find(":{");
    option.value = type.substr(0, std::min({begin, type.find(":INT"), type.find(' ')}));
    option.required |= type.ends_with(" REQUIRED");
    if (begin == type.npos || type.back() != '}') return;
    std::string choice;
    for (const char letter : type.substr(begin + 2)) {
        if (letter != ',' && letter != '}') {
            choice += letter;
            continue;
        }
        option.choices.push_back(choice);
        choice.clear();
    }
}

OptionText optionText(const CLI::Option& option) {
    OptionText text;
    for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
    text.meaning = option.get_description();
    text.required = option.get_required();
    text.repeats = option.get_expected_max() > 1;
    if (text.names.empty()) {
        text.value = option.get_name();
    } else if (option.get_items_expected_max() > 0) {
        readType(option.get_type_name(), text);
    }
    return text;
}

CommandText commandText(const CLI::App& command) {
    CommandText text;
    text.name = command.get_name();
    text.meaning = command.get_description();
    text.footer = command.get_footer();
    for (const CLI::Option* option : command.get_options()) text.options.push_back(optionText(*option));
    for (const CLI::App* part : command.get_subcommands([](const CLI::App*) { return true; })) {
        CommandText inner = commandText(*part);
        if (!inner.name.empty())
            text.commands.push_back(std::move(inner));
        else  // a group of options, which the command line does not know by name
            text.options.insert(text.options.end(), inner.options.begin(), inner.options.end());
    }
    return text;
}

}  // namespace

CommandText commandTree(const CliHost& host) {
    CLI::App program;
    int status = kDone;
    declareProgram(program, host, status);
    return commandText(program);
}

}  // namespace app
