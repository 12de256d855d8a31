#include "resources/manual/completions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

namespace manual {

namespace {

using app::CommandText;
using app::OptionText;

constexpr const char* kMadeFrom =
    "# Made from the program's tables by resources/manual/write_commands.cpp; not to be edited.\n";

// 'it'\''s': as a word of a shell.
std::string shellWord(const std::string& text) {
    std::string word = "'";
    for (const char letter : text) word += letter == '\'' ? "'\\''" : std::string(1, letter);
    return word + "'";
}

// Calls it with each command and what stands before its options on a command line: "study merge".
void eachCommand(const CommandText& command, const std::string& path,
                 const std::function<void(const CommandText&, const std::string& path)>& take) {
    take(command, path);
    for (const CommandText& part : command.commands)
        eachCommand(part, path.empty() ? part.name : path + " " + part.name, take);
}

std::vector<std::string> commandNames(const CommandText& command) {
    std::vector<std::string> names;
    for (const CommandText& part : command.commands) names.push_back(part.name);
    return names;
}

// bash: a branch of `case "$path:$before"`; what is told by its place stands behind a path alone.
std::string bashBranch(const std::string& pattern, const Offered& offered) {
    std::string text = fmt::format("        {})\n", pattern);
    text += fmt::format("            words={}\n", shellWord(fmt::format("{}", fmt::join(offered.words, " "))));
    if (offered.list) text += "            list=yes\n";
    if (offered.files) text += "            action=file\n";
    if (offered.folders) text += "            action=directory\n";
    return text + "            ;;\n";
}

}  // namespace

std::string bashCompletion(const CommandText& program) {
    std::string values, options, places, commands;
    eachCommand(program, "", [&](const CommandText& command, const std::string& path) {
        std::vector<std::string> names;
        for (const OptionText& option : command.options) {
            names.insert(names.end(), option.names.begin(), option.names.end());
            const Offered offered = offeredFor(option);
            if (option.names.empty()) {
                places += bashBranch(shellWord(path), offered);
            } else if (!option.value.empty()) {
                std::vector<std::string> patterns;
                for (const std::string& name : option.names) patterns.push_back(shellWord(path + ":" + name));
                values += bashBranch(fmt::format("{}", fmt::join(patterns, " | ")), offered);
            }
        }
        options += fmt::format("        {}) options={} ;;\n", shellWord(path),
                               shellWord(fmt::format("{}", fmt::join(names, " "))));
        if (!command.commands.empty())
            commands += fmt::format("        {}) commands={} ;;\n", shellWord(path),
                                    shellWord(fmt::format("{}", fmt::join(commandNames(command), " "))));
    });
    return fmt::format(R"(# bash completion for shadescope
{}
_shadescope() {{
    local line=${{COMP_LINE:0:COMP_POINT}} path='' before='' words='' action='' list='' options='' commands='' offered=''
    local -a said
    read -ra said <<< "$line"
    [[ $line == *[[:space:]] ]] && said+=('')
    local word=${{said[-1]}} i
    for ((i = 1; i < ${{#said[@]}} - 1; ++i)); do
        commands=''
        case $path in
{}        esac
        [[ " $commands " == *" ${{said[i]}} "* ]] && path="${{path:+$path }}${{said[i]}}"
        before=${{said[i]}}
    done
    commands=''
    case $path in
{}    esac
    case "$path:$before" in
{}        *)
            before=''
            ;;
    esac
    if [[ -z $before ]]; then
        case $path in
{}        esac
        case $path in
{}        esac
        if [[ $word == -* ]]; then
            offered=$options action=''
        else
            offered="$words $commands"
        fi
    else
        offered=$words
    fi
    local done=''
    [[ -n $list && $word == *,* ]] && done=${{word%,*}},
    # bash replaces only what follows the last = or : of a word.
    local kept=''
    [[ $word == *[=:]* ]] && kept=${{word%"${{word##*[=:]}}"}}
    local reply
    COMPREPLY=()
    for reply in $(compgen -W "$offered" -- "${{word#"$done"}}"); do
        reply=$done$reply
        COMPREPLY+=("${{reply#"$kept"}}")
    done
    if [[ -n $action ]]; then
        compopt -o filenames
        while IFS= read -r reply; do COMPREPLY+=("$reply"); done < <(compgen -A "$action" -- "$word")
    elif [[ ${{#COMPREPLY[@]}} == 1 && ${{COMPREPLY[0]}} == *= ]]; then
        compopt -o nospace
    fi
}}
complete -F _shadescope shadescope
)",
                       kMadeFrom, commands, commands, values, places, options);
}

namespace {

// [text]: brackets and colons have a meaning of their own for _arguments.
std::string zshText(const std::string& text) {
    std::string out;
    for (const char letter : text) {
        if (letter == '[' || letter == ']' || letter == ':' || letter == '\\') out += '\\';
        out += letter;
    }
    return out;
}

// The last part of a specification for _arguments: what completes a value.
std::string zshAction(const Offered& offered) {
    std::string words;
    for (const std::string& word : offered.words) words += " " + word;
    if (offered.words.empty()) return offered.folders ? "_files -/" : offered.files ? "_files" : " ";
    const char* const function = offered.list ? "_shadescope_list" : "_shadescope_words";
    const char* const also = offered.folders ? " -/" : offered.files ? " -f" : " -";
    return fmt::format("{}{}{}", function, also, words);
}

std::string zshOption(const OptionText& option, const CommandText& command) {
    Offered offered = offeredFor(option);
    // A command of its own may stand where a scene may.
    if (option.names.empty())
        for (const std::string& name : commandNames(command)) offered.words.push_back(name);
    const std::string value =
        option.value.empty() ? "" : fmt::format(":{}:{}", zshText(option.value), zshAction(offered));
    if (option.names.empty())
        return shellWord(fmt::format("{}:{}:{}", option.repeats ? "*" : "", zshText(option.value), zshAction(offered)));
    std::string text;
    for (const std::string& name : option.names) {
        std::vector<std::string> others(option.names);
        if (option.repeats) others.clear();
        const std::string excluded = option.repeats      ? "*"
                                     : others.size() > 1 ? fmt::format("({})", fmt::join(others, " "))
                                                         : "";
        text += (text.empty() ? "" : " ") +
                shellWord(fmt::format("{}{}[{}]{}", excluded, name, zshText(option.meaning), value));
    }
    return text;
}

std::string zshFunctionName(const std::string& path) {
    std::string name = "_shadescope_command";
    for (const char letter : " " + path) name += letter == ' ' ? '_' : letter;
    return name;
}

}  // namespace

std::string zshCompletion(const CommandText& program) {
    std::string text = fmt::format(R"(#compdef shadescope
{}
# ALSO WORD...: these words, and files (-f) or folders (-/).
_shadescope_words() {{
    local also=$1
    shift
    compadd -S '' -- ${{(M)@:#*=}}
    compadd -- ${{@:#*=}}
    case $also in -f) _files ;; -/) _files -/ ;; esac
}}
_shadescope_list() {{
    shift
    compset -P '*,'
    compadd -q -S , -- "$@"
}}
)",
                                   kMadeFrom);
    eachCommand(program, "", [&](const CommandText& command, const std::string& path) {
        const bool hasPlaces =
            std::ranges::any_of(command.options, [](const OptionText& o) { return o.names.empty(); });
        std::string options;
        for (const OptionText& option : command.options)
            options += fmt::format("        {} \\\n", zshOption(option, command));
        text += fmt::format("{}() {{\n", zshFunctionName(path));
        if (command.commands.empty() || hasPlaces) {
            for (const CommandText& part : command.commands)
                text += fmt::format("    if [[ $words[2] == {} ]]; then shift words; (( CURRENT-- )); {}; return; fi\n",
                                    part.name, zshFunctionName(path + " " + part.name));
            text += fmt::format("    _arguments -s \\\n{}        && return\n}}\n", options);
            return;
        }
        text += fmt::format("    local line state\n    local -a commands=(\n");
        for (const CommandText& part : command.commands)
            text += fmt::format("        {}\n", shellWord(part.name + ":" + zshText(part.meaning)));
        text += fmt::format(
            "    )\n    _arguments -C -s \\\n{}        '1: :->command' '*::argument:->rest' && return\n", options);
        // The program alone takes a file in place of a command.
        text += fmt::format(
            "    case $state in\n        command) _describe command commands{} ;;\n        rest)\n"
            "            case $line[1] in\n",
            path.empty() ? "; _files" : "");
        for (const CommandText& part : command.commands)
            text += fmt::format("                {}) {} ;;\n", part.name,
                                zshFunctionName(path.empty() ? part.name : path + " " + part.name));
        text += "            esac ;;\n    esac\n}\n";
    });
    return text + fmt::format("{} \"$@\"\n", zshFunctionName(""));
}

std::string fishCompletion(const CommandText& program) {
    std::string text = std::string("# fish completion for shadescope\n") + kMadeFrom;
    eachCommand(program, "", [&](const CommandText& command, const std::string& path) {
        // Whether the line is at this command, and at none of its own.
        std::string at = path.empty() ? "__fish_use_subcommand"
                                      : fmt::format("__fish_seen_subcommand_from {}", path.substr(path.rfind(' ') + 1));
        if (const std::size_t space = path.find(' '); space != path.npos)
            at += fmt::format("; and __fish_seen_subcommand_from {}", path.substr(0, space));
        else if (!path.empty() && !command.commands.empty())
            at += fmt::format("; and not __fish_seen_subcommand_from {}", fmt::join(commandNames(command), " "));
        for (const CommandText& part : command.commands)
            text += fmt::format("complete -c shadescope -n {} -a {} -d {}\n", shellWord(at), part.name,
                                shellWord(part.meaning));
        for (const OptionText& option : command.options) {
            text += fmt::format("complete -c shadescope -n {}", shellWord(at));
            for (const std::string& name : option.names)
                text += name.starts_with("--") ? fmt::format(" -l {}", name.substr(2))
                                               : fmt::format(" -s {}", name.substr(1));
            if (!option.meaning.empty() && !option.names.empty())
                text += fmt::format(" -d {}", shellWord(option.meaning));
            if (!option.value.empty()) {
                const Offered offered = offeredFor(option);
                if (!option.names.empty()) text += offered.files ? " -r" : " -x";
                std::string words = fmt::format("{}", fmt::join(offered.words, " "));
                if (offered.list) words = fmt::format("(__fish_append , {})", words);
                if (offered.folders) words += " (__fish_complete_directories)";
                if (!words.empty()) text += fmt::format(" -a {}", shellWord(words));
            }
            text += '\n';
        }
    });
    return text;
}

}  // namespace manual
