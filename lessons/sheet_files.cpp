// Sheets as files: pages for the class, and in a folder of its own what their teacher keeps.
#include <fmt/format.h>

#include "lessons/csv_text.h"
#include "lessons/sheet.h"
#include "pipeline/core/printable.h"
#include "pipeline/export/json.h"
#include "pipeline/export/staging.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/key_places.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::Json;
using pipeline::Result;

constexpr std::size_t kMostKeyBytes = std::size_t{64} << 20;
constexpr std::string_view kKeyFolder = "keys", kKeyFile = "sheets.json";

// What was drawn and every answer, a row a sheet.
std::string csvOf(const Sheets& sheets) {
    std::string text = "sheet";
    const Sheet& first = sheets.sheets.front();
    for (const auto& [key, value] : first.drawn) text += ',' + csvCell(key);
    for (std::size_t i = 0; i < first.answers.size(); ++i) text += fmt::format(",answer {}", i + 1);
    text += '\n';
    for (const Sheet& sheet : sheets.sheets) {
        text += std::to_string(sheet.number);
        for (const auto& [key, value] : sheet.drawn) text += ',' + csvCell(value);
        for (const std::string& answer : sheet.answers) text += ',' + csvCell(answer);
        text += '\n';
    }
    return text;
}

std::string jsonOf(const Sheets& sheets, const SheetTemplate& made, const SheetOptions& options) {
    std::error_code ignored;
    const std::filesystem::path folder = std::filesystem::absolute(made.folder, ignored).lexically_normal();
    const std::filesystem::path named = folder.has_filename() ? folder : folder.parent_path();
    Json json{{"version", 1},
              {"lesson", named.filename().string()},
              {"folder", named.string()},
              {"seed", options.seed},
              {"blanks", options.blanks},
              {"sheets", Json::array()}};
    for (const Sheet& sheet : sheets.sheets) {
        Json drawn = Json::object();
        for (const auto& [key, value] : sheet.drawn) drawn[key] = value;
        json["sheets"].push_back(
            {{"sheet", sheet.number}, {"drawn", drawn}, {"answers", sheet.answers}, {"text", sheet.text}});
    }
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

// What a student fills in and hands in.
std::string emptyAnswers(const Sheet& sheet) {
    Json json{{"version", 1}, {"sheet", sheet.number}, {"answers", Json::object()}};
    for (std::size_t i = 1; i <= sheet.answers.size(); ++i) json["answers"][std::to_string(i)] = "";
    return json.dump(1) + '\n';
}

}  // namespace

Result<std::size_t> writeSheets(const Sheets& sheets, const SheetTemplate& made, const SheetOptions& options,
                                const std::filesystem::path& folder) {
    const int digits = int(std::to_string(sheets.sheets.size()).size());
    std::vector<std::pair<std::string, std::string>> pages, keys;
    for (std::size_t i = 0; i < sheets.pages.size(); ++i) {
        const std::string name = fmt::format("sheet-{:0{}}", i + 1, std::max(2, digits));
        pages.emplace_back(name + ".html", sheets.pages[i].sheet);
        pages.emplace_back(name + "-answers.json", emptyAnswers(sheets.sheets[i]));
        keys.emplace_back(name + "-key.html", sheets.pages[i].key);
    }
    keys.emplace_back("sheets.csv", csvOf(sheets));
    keys.emplace_back(kKeyFile, jsonOf(sheets, made, options));
    // A sheet without its key could not be marked, so the keys are there first.
    if (const auto written = pipeline::writeFiles(keys, folder / kKeyFolder); !written) return written.errors();
    if (const auto written = pipeline::writeFiles(pages, folder); !written) return written.errors();
    return pages.size() + keys.size();
}

Result<SheetKeys> readSheetKeys(const std::filesystem::path& file) {
    const auto text = pipeline::readFile(file, kMostKeyBytes);
    if (!text) return pipeline::namedAt({file.string()}, text.errors());
    SheetKeys keys;
    try {
        const Json json = Json::parse(*text);
        if (json.at("version") != 1)
            return Error{{file.string(), 0, 0}, "found sheets of another version", "version 1"};
        keys.lesson = pipeline::escapedControls(json.at("lesson").get<std::string>());
        keys.folder = json.at("folder").get<std::string>();
        for (const Json& sheet : json.at("sheets"))
            keys.texts[sheet.at("sheet").get<std::size_t>()] = sheet.at("text").get<std::string>();
    } catch (const std::exception& error) {
        return Error{{file.string(), 0, 0},
                     std::string("these are no sheets: ") + pipeline::escapedControls(error.what())};
    }
    return keys;
}

}  // namespace lessons
