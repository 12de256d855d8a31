#include "app/cli/commands/stage_starter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "pipeline/export/buffers/byte_file.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_folder.h"

namespace app {

namespace {

using pipeline::OwnKind;

// {0}: a parameter's name, or what it is called; {1}: its type, or its kind.
struct Language {
    std::string_view name, extension;
    std::string_view parameter, meaning, read;         // one of each; meaning is a line of a comment
    std::string_view hint;                             // the same within a function
    std::array<std::string_view, 9> types{}, zeros{};  // by kind
};
constexpr std::array<std::string_view, 9> kListZeros{"", "False", "0", "[0, 0]", "[0, 0, 0]", "[0, 0, 0]"};
constexpr std::array kLanguages{
    Language{"python", ".py", "{0}", "#   {0}: {1}", "", "    # {0}: {1}", {}, kListZeros},
    Language{"cpp",
             ".cpp",
             "{1} {0}",
             "//   {0}: {1}",
             "        const auto {0} = read{1}();\n",
             "    // {0}: {1}",
             {"", "bool", "double", "Point", "Vector", "Vector", "std::vector<double>", "std::vector<Point>",
              "std::vector<Vector>"}},
    Language{"js",
             ".js",
             "{0}",
             "//   {0}: {1}",
             "",
             "  // {0}: {1}",
             {},
             {"", "false", "0", "[0, 0]", "[0, 0, 0]", "[0, 0, 0]"}},
    Language{"c",
             ".c",
             "{1} {0}",
             "     {0}: {1}",
             "        const {2} {0} = read{1}();\n",
             "    /* {0}: {1} */",
             {"", "int", "double", "Point", "Vector", "Vector", "Numbers", "Points", "Vectors"}},
    Language{"java",
             ".java",
             "{1} {0}",
             "//   {0}: {1}",
             "            {2} {0} = read{1}();\n",
             "        // {0}: {1}",
             {"", "boolean", "double", "double[]", "double[]", "double[]", "double[]", "double[][]", "double[][]"},
             {"", "false", "0", "new double[2]", "new double[3]", "new double[3]"}},
    Language{"rust",
             ".rs",
             "{0}: {1}",
             "//   {0}: {1}",
             "        let {0} = words.read{1}();\n",
             "    // {0}: {1}",
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

// A file that is there already stays, and is an error. Gives its path.
pipeline::Result<std::string> writeNew(const std::filesystem::path& file, const std::string& text) {
    std::error_code failed;
    std::filesystem::create_directories(file.parent_path(), failed);
    if (std::filesystem::exists(file, failed))
        return pipeline::Error{{file.string()}, "is there already and stays as it is", "the name of another folder"};
    pipeline::ByteFile out(file);
    out.write(text);
    if (const auto written = out.close(); !written) return written.errors();
    return file.string();
}

// words: what stands between the @ of a text of resources/starter, by the file that is written.
template <class Words>
pipeline::Result<std::string> writeStarter(std::string_view text, const std::string& name, const std::string& language,
                                           const std::filesystem::path& folder, Words words) {
    const Language& of = *std::ranges::find(kLanguages, language, &Language::name);
    const std::filesystem::path file = folder / fmt::format("{}{}", name, of.extension);
    const auto read =
        pipeline::readFile(pipeline::resourceFolder() / "starter" / fmt::format("{}{}.in", text, of.extension));
    if (!read) return read.errors();
    return writeNew(file, filledIn(*read, words(of, file.string())));
}

}  // namespace

std::vector<std::string> starterLanguages() {
    std::vector<std::string> names;
    for (const Language& language : kLanguages) names.emplace_back(language.name);
    return names;
}

pipeline::Result<std::string> writeFunctionStarter(const pipeline::OwnContract& contract, const std::string& language,
                                                   const std::filesystem::path& folder) {
    return writeStarter("stage", std::string(contract.name), language, folder,
                        [&](const Language& of, const std::string& file) { return wordsOf(contract, of, file); });
}

pipeline::Result<std::string> writeStageStarter(const pipeline::foreign::StageBlocks& blocks,
                                                const std::string& language, const std::filesystem::path& folder) {
    const std::string name(stageInfo(blocks.stage).name);
    return writeStarter("whole", name, language, folder, [&](const Language& of, const std::string& file) {
        const auto lineOf = [](std::string_view pattern, std::string_view what, std::string_view words) {
            return fmt::format(fmt::runtime(pattern), what, words);
        };
        const auto listed = [](const auto& names) {
            std::string text;
            for (const std::string_view one : names) {
                if (one.empty()) break;
                const auto first = pipeline::findBuffer(fmt::format("{}.0", one));
                const bool isPerLight = first && bufferInfo(first->id).perLight;
                text += fmt::format("{}{}{}", text.empty() ? "" : ", ", one, isPerLight ? ".0 …" : "");
            }
            return text;
        };
        std::string hints;
        for (std::size_t i = 0; i < pipeline::kOwnCount; ++i) {
            const pipeline::OwnContract& contract = ownContract(pipeline::OwnFunction(i));
            if (contract.stage != blocks.stage) continue;
            hints += (hints.empty() ? "" : "\n") + lineOf(of.hint, signatureOf(contract), contract.hint);
        }
        return std::map<std::string, std::string>{{"STAGE", name},
                                                  {"BLOCKS", lineOf(of.meaning, "gets", listed(blocks.gets)) + "\n" +
                                                                 lineOf(of.meaning, "gives", listed(blocks.gives))},
                                                  {"HINTS", hints},
                                                  {"FILE", file}};
    });
}

pipeline::Result<std::vector<std::string>> writeAssignments(const std::filesystem::path& folder) {
    std::error_code failed;
    std::vector<std::string> written;
    for (std::filesystem::directory_iterator at(pipeline::resourceFolder() / "assignments", failed), end;
         !failed && at != end; at.increment(failed)) {
        const auto text = pipeline::readFile(at->path());
        if (!text) return text.errors();
        const auto file = writeNew(folder / at->path().filename(), *text);
        if (!file) return file.errors();
        written.push_back(*file);
    }
    std::ranges::sort(written);
    return written;
}

}  // namespace app
