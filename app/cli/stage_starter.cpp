#include "app/cli/stage_starter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "pipeline/export/byte_file.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_folder.h"

namespace app {

namespace {

using pipeline::OwnKind;

// {0}: a parameter's name, or what it is called; {1}: its type, or its kind.
struct Language {
    std::string_view name, extension;
    std::string_view parameter, meaning, read;         // one of each; meaning is a line of a comment
    std::array<std::string_view, 9> types{}, zeros{};  // by kind
};
constexpr std::array<std::string_view, 9> kListZeros{"", "False", "0", "[0, 0]", "[0, 0, 0]", "[0, 0, 0]"};
constexpr std::array kLanguages{
    Language{"python", ".py", "{0}", "#   {0}: {1}", "", {}, kListZeros},
    Language{"cpp",
             ".cpp",
             "{1} {0}",
             "//   {0}: {1}",
             "        const auto {0} = read{1}();\n",
             {"", "bool", "double", "Point", "Vector", "Vector", "std::vector<double>", "std::vector<Point>",
              "std::vector<Vector>"}},
    Language{"js", ".js", "{0}", "//   {0}: {1}", "", {}, {"", "false", "0", "[0, 0]", "[0, 0, 0]", "[0, 0, 0]"}},
    Language{"c",
             ".c",
             "{1} {0}",
             "     {0}: {1}",
             "        const {2} {0} = read{1}();\n",
             {"", "int", "double", "Point", "Vector", "Vector", "Numbers", "Points", "Vectors"}},
    Language{"java",
             ".java",
             "{1} {0}",
             "//   {0}: {1}",
             "            {2} {0} = read{1}();\n",
             {"", "boolean", "double", "double[]", "double[]", "double[]", "double[]", "double[][]", "double[][]"},
             {"", "false", "0", "new double[2]", "new double[3]", "new double[3]"}},
    Language{"rust",
             ".rs",
             "{0}: {1}",
             "//   {0}: {1}",
             "        let {0} = words.read{1}();\n",
             {"", "bool", "f64", "Point", "Vector", "Vector", "Vec<f64>", "Vec<Point>", "Vec<Vector>"},
             {"", "false", "0.0", "[0.0; 2]", "[0.0; 3]", "[0.0; 3]"}},
};

std::string_view kindName(OwnKind kind) {
    constexpr std::array<std::string_view, 9> kNames{"",       "Number",  "Number", "Point",  "Vector",
                                                     "Vector", "Numbers", "Points", "Vectors"};
    return kNames[std::size_t(kind)];
}

std::map<std::string, std::string> wordsOf(const pipeline::OwnContract& contract, const Language& language,
                                           const std::string& file) {
    std::string parameters, meanings, reads, arguments, kinds;
    for (const pipeline::OwnParameter& one : contract.taken()) {
        // A word of Python.
        const std::string name = std::string(one.name) + (language.name == "python" && one.name == "lambda" ? "_" : "");
        const std::string_view type = language.types[std::size_t(one.kind)];
        const std::string_view comma = parameters.empty() ? "" : ", ";
        parameters += comma, arguments += comma, kinds += comma;
        parameters += fmt::format(fmt::runtime(language.parameter), name, type);
        arguments += name;
        kinds += fmt::format("\"{}\"", kindName(one.kind));
        if (!meanings.empty()) meanings += '\n';
        meanings += fmt::format(fmt::runtime(language.meaning), name, one.meaning);
        reads += fmt::format(fmt::runtime(language.read), name, kindName(one.kind), type);
    }
    const auto result = std::size_t(contract.returns);
    return {{"FUNCTION", std::string(contract.name)},
            {"RESULT", std::string(contract.result)},
            {"HINT", std::string(contract.hint)},
            {"PARAMETERS", parameters},
            {"MEANINGS", meanings},
            {"READ", reads},
            {"ARGUMENTS", arguments},
            {"KINDS", kinds},
            {"TYPE", std::string(language.types[result])},
            {"ZERO", std::string(language.zeros[result])},
            {"SHOWN", std::string(kindName(contract.returns))},
            {"COLUMNS", std::to_string(contract.size())},
            {"FILE", file}};
}

// The text with each @WORD@ replaced.
std::string filledIn(std::string_view text, const std::map<std::string, std::string>& words) {
    std::string out;
    while (true) {
        const std::size_t at = text.find('@');
        out += text.substr(0, at);
        if (at == text.npos) return out;
        text.remove_prefix(at + 1);
        const std::size_t end = text.find('@');
        const auto word = words.find(std::string(text.substr(0, end)));
        if (word == words.end()) {
            out += '@';
            continue;
        }
        out += word->second;
        text.remove_prefix(end + 1);
    }
}

}  // namespace

std::vector<std::string> starterLanguages() {
    std::vector<std::string> names;
    for (const Language& language : kLanguages) names.emplace_back(language.name);
    return names;
}

pipeline::Result<std::string> writeFunctionStarter(const pipeline::OwnContract& contract, const std::string& language,
                                                   const std::filesystem::path& folder) {
    const Language& of = *std::ranges::find(kLanguages, language, &Language::name);
    const std::string name = fmt::format("{}{}", contract.name, of.extension);
    const std::filesystem::path file = folder / name;
    const auto text =
        pipeline::readFile(pipeline::resourceFolder() / "starter" / fmt::format("stage{}.in", of.extension));
    if (!text) return text.errors();
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (std::filesystem::exists(file, failed))
        return pipeline::Error{{file.string()}, "is there already and stays as it is", "the name of another folder"};
    pipeline::ByteFile out(file);
    out.write(filledIn(*text, wordsOf(contract, of, file.string())));
    if (const auto written = out.close(); !written) return written.errors();
    return file.string();
}

}  // namespace app
