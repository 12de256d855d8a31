// Sheets as files: pages for the class, and in a folder of its own what their teacher keeps.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "lessons/grading/csv_text.h"
#include "lessons/grading/sheet.h"
#include "pipeline/core/printable.h"
#include "pipeline/export/folder/contents.h"
#include "pipeline/export/folder/file_hash.h"
#include "pipeline/export/folder/publish.h"
#include "pipeline/export/json/json_value.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/key_places.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::Json;
using pipeline::Result;

constexpr std::size_t kMostKeyBytes = std::size_t{64} << 20;

// What was drawn and every answer, a row a sheet.
std::string csvOf(const Sheets& sheets) {
    std::string text = "sheet,draw";
    const Sheet& first = sheets.sheets.front();
    for (const auto& [key, value] : first.drawn) text += ',' + csvCell(key);
    for (std::size_t i = 0; i < first.answers.size(); ++i) text += fmt::format(",answer {}", i + 1);
    text += '\n';
    for (const Sheet& sheet : sheets.sheets) {
        text += fmt::format("{},{}", sheet.number, sheet.draw);
        for (const auto& [key, value] : sheet.drawn) text += ',' + csvCell(value);
        for (const std::string& answer : sheet.answers) text += ',' + csvCell(answer);
        text += '\n';
    }
    return text;
}

// files: the others.
std::string jsonOf(const Sheets& sheets, const SheetTemplate& made, const SheetOptions& options,
                   const std::vector<std::pair<std::string, std::string>>& files) {
    std::error_code ignored;
    const std::filesystem::path folder = std::filesystem::absolute(made.folder, ignored).lexically_normal();
    const std::filesystem::path named = folder.has_filename() ? folder : folder.parent_path();
    Json json{{"program", pipeline::programMark()},
              {"version", 1},
              {"lesson", named.filename().string()},
              {"folder", named.string()},
              {"seed", options.seed},
              {"blanks", options.blanks},
              {"sheets", Json::array()},
              {"files", pipeline::contentsOf(files)}};
    for (const Sheet& sheet : sheets.sheets) {
        Json drawn = Json::object();
        for (const auto& [key, value] : sheet.drawn) drawn[key] = value;
        json["sheets"].push_back({{"sheet", sheet.number},
                                  {"draw", sheet.draw},
                                  {"drawn", drawn},
                                  {"answers", sheet.answers},
                                  {"text", sheet.text}});
    }
    return json.dump(1) + '\n';
}

// What a student fills in and hands in.
std::string emptyAnswers(const Sheet& sheet) {
    Json json{{"version", 1}, {"sheet", sheet.number}, {"draw", sheet.draw}, {"answers", Json::object()}};
    for (std::size_t i = 1; i <= sheet.answers.size(); ++i) json["answers"][std::to_string(i)] = "";
    return json.dump(1) + '\n';
}

std::string sheetName(std::size_t number, std::size_t count) {
    return fmt::format("sheet-{:0{}}", number, std::max<std::size_t>(2, std::to_string(count).size()));
}
std::string keyName(const std::string& sheet) { return "keys/" + sheet + "-key.html"; }

// Sheets and keys of a draw before, more than this one has; of a folder that the program has written into.
std::vector<std::string> earlierFiles(const std::filesystem::path& folder, const std::vector<std::string>& written) {
    std::vector<std::string> gone;
    std::error_code failed;
    const bool isOurs = std::filesystem::exists(folder / kSheetIndex, failed) &&
                        pipeline::whyNotReplaced(folder, {kSheetIndex}, kSheetIndex).empty();
    if (!isOurs && !std::filesystem::exists(folder / pipeline::unfinishedName(kSheetIndex), failed)) return gone;
    for (const char* const below : {"", "keys/"})
        for (std::filesystem::directory_iterator entry(folder / below, failed), end; !failed && entry != end;
             entry.increment(failed)) {
            const std::string name = below + entry->path().filename().string();
            std::size_t number = 0;
            const std::string sheet = name.substr(name.starts_with("keys/") ? 5 : 0);
            const auto [rest, error] = std::from_chars(sheet.data() + std::min<std::size_t>(6, sheet.size()),
                                                       sheet.data() + sheet.size(), number);
            const std::string_view ending(rest, std::size_t(sheet.data() + sheet.size() - rest));
            const bool isOne = sheet.starts_with("sheet-") && error == std::errc() &&
                               (*below ? ending == "-key.html" : ending == ".html" || ending == "-answers.json");
            if (isOne && std::ranges::find(written, name) == written.end() && entry->is_regular_file(failed))
                gone.push_back(name);
        }
    return gone;
}

}  // namespace

std::string drawNumber(const Sheet& sheet) {
    std::string all = sheet.text;
    for (const std::string& answer : sheet.answers) all += '\0' + answer;
    return pipeline::sha256Of(all).substr(0, 8);
}

std::vector<std::string> sheetFiles(std::size_t count) {
    std::vector<std::string> names;
    for (std::size_t i = 1; i <= count; ++i) {
        const std::string sheet = sheetName(i, count);
        names.insert(names.end(), {sheet + ".html", sheet + "-answers.json", keyName(sheet)});
    }
    names.insert(names.end(), {"keys/sheets.csv", kSheetIndex});
    return names;
}

Result<std::size_t> writeSheets(const Sheets& sheets, const SheetTemplate& made, const SheetOptions& options,
                                const std::filesystem::path& folder) {
    const std::vector<std::string> names = sheetFiles(sheets.pages.size());
    std::vector<std::pair<std::string, std::string>> files;
    const auto add = [&](std::string bytes) { files.emplace_back(names[files.size()], std::move(bytes)); };
    for (std::size_t i = 0; i < sheets.pages.size(); ++i) {
        add(sheets.pages[i].sheet);
        add(emptyAnswers(sheets.sheets[i]));
        add(sheets.pages[i].key);
    }
    add(csvOf(sheets));
    add(jsonOf(sheets, made, options, files));
    // At once: a sheet beside the key of another draw would be marked wrong.
    if (const auto written = pipeline::replaceFiles(files, folder, earlierFiles(folder, names)); !written)
        return written.errors();
    return files.size();
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
        for (const Json& sheet : json.at("sheets")) {
            const auto number = sheet.at("sheet").get<std::size_t>();
            keys.texts[number] = sheet.at("text").get<std::string>();
            if (sheet.find("draw")) keys.draws[number] = pipeline::escapedControls(sheet["draw"].get<std::string>());
        }
    } catch (const std::exception& error) {
        return Error{{file.string(), 0, 0},
                     std::string("these are no sheets: ") + pipeline::escapedControls(error.what())};
    }
    return keys;
}

}  // namespace lessons
