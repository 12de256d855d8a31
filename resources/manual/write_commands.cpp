// Writes what is installed about the commands, from the program's tables: a man page, and what the shells offer
// after the Tab key.
//   write_commands FOLDER   writes shadescope.1, shadescope.bash, _shadescope and shadescope.fish
#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "app/cli/command_tree.h"
#include "pipeline/core/version.h"
#include "resources/manual/completions.h"

namespace {

using app::CommandText;
using app::OptionText;

// As roff takes a text: a hyphen that may be copied, no line that is a request.
std::string roff(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool begins = i == 0 || text[i - 1] == '\n';
        if (begins && (text[i] == '.' || text[i] == '\'')) out += "\\&";
        if (text[i] == '\\')
            out += "\\e";
        else if (text[i] == '-')
            out += "\\-";
        else
            out += text[i];
    }
    return out;
}

std::string optionEntry(const OptionText& option) {
    std::string names;
    for (const std::string& name : option.names)
        names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", roff(name));
    if (!option.value.empty()) names += fmt::format("{}\\fI{}\\fR", names.empty() ? "" : " ", roff(option.value));
    std::string meaning = option.meaning;
    if (option.required) meaning += " (required)";
    if (option.repeats && option.meaning.find("more than once") == option.meaning.npos &&
        option.meaning.find("repeated") == option.meaning.npos)
        meaning += "; may be given more than once";
    return fmt::format(".TP\n{}\n{}.\n", names, roff(meaning));
}

void addCommand(const CommandText& command, const std::string& path, std::string& text) {
    std::string line = fmt::format("\\fBshadescope {}\\fR", roff(path));
    for (const OptionText& option : command.options)
        if (option.names.empty())
            line +=
                option.required ? fmt::format(" \\fI{}\\fR", option.value) : fmt::format(" [\\fI{}\\fR]", option.value);
        else if (option.required)
            line += fmt::format(" \\fB{}\\fR \\fI{}\\fR", roff(option.names.front()), roff(option.value));
    text += fmt::format(".SS {}\n{} [\\fIoptions\\fR]\n.PP\n{}.\n", roff(path), line, roff(command.meaning));
    for (const OptionText& option : command.options)
        if (option.names.empty() || !option.names.back().starts_with("--help")) text += optionEntry(option);
    for (const CommandText& part : command.commands) addCommand(part, path + " " + part.name, text);
}

std::string manPage(const CommandText& program, bool hasWindow) {
    std::string text = fmt::format(
        ".\\\" Made from the program's tables by resources/manual/write_commands.cpp; not to be edited.\n"
        ".TH SHADESCOPE 1 \"\" \"Shadescope {}\" \"User Commands\"\n"
        ".SH NAME\nshadescope \\- see how polygons become a picture, one step at a time\n.SH SYNOPSIS\n",
        roff(std::string(pipeline::programVersion())));
    if (hasWindow) text += "\\fBshadescope\\fR [\\fB\\-\\-no\\-session\\fR] [\\fIFILE\\fR]\n.br\n";
    text += "\\fBshadescope\\fR \\fICOMMAND\\fR [\\fIARGUMENTS\\fR]\n.SH DESCRIPTION\n";
    text += fmt::format(
        "Shadescope renders a scene of polygons through six stages (transform, cull, normals, shadow buffer, "
        "z\\-buffer, "
        "shading) and keeps what every stage leaves.{} A command needs no display.\n",
        hasWindow ? " Without a command it opens its window, with a scene, a model, a lesson's folder or a cue list."
                  : " This build has the commands alone.");
    text += ".SH OPTIONS\n";
    for (const OptionText& option : program.options) text += optionEntry(option);
    text += ".SH COMMANDS\n";
    for (const CommandText& command : program.commands) addCommand(command, command.name, text);
    text +=
        ".SH EXIT STATUS\n.TP\n0\nDone.\n.TP\n1\nThe command ran, and the answer is no.\n.TP\n2\nWrong usage.\n.TP\n3\n"
        "Bad input: \\fIFILE\\fR:\\fILINE\\fR:\\fICOLUMN\\fR: what was found, and what was expected.\n.TP\n4\nThe "
        "command could not write, or there was not enough memory.\n.TP\n130\nThe command was stopped.\n";
    text += ".SH EXAMPLES\n";
    for (const char* const line :
         {"shadescope export pyramid -o pyramid", "shadescope plan pyramid --set shading=gouraud",
          "shadescope inspect pyramid --pixel 268,281", "shadescope study flat_gouraud_phong --sweep shading -o study"})
        text += fmt::format(".PP\n.EX\n{}\n.EE\n", roff(line));
    return text;
}

bool write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text;
    return static_cast<bool>(out.flush());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: write_commands FOLDER\n");
        return 2;
    }
    app::CliHost host;
#ifdef SHADESCOPE_WINDOW
    host.hasWindow = true;
#endif
    const CommandText program = commandTree(host);
    const std::filesystem::path folder = argv[1];
    const bool written = write(folder / "shadescope.1", manPage(program, host.hasWindow)) &&
                         write(folder / "shadescope.bash", manual::bashCompletion(program)) &&
                         write(folder / "_shadescope", manual::zshCompletion(program)) &&
                         write(folder / "shadescope.fish", manual::fishCompletion(program));
    return written ? 0 : 4;
}
