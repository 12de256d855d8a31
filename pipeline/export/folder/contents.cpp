#include "pipeline/export/folder/contents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "pipeline/core/version.h"
#include "pipeline/export/folder/file_hash.h"
#include "pipeline/formats/text/inputs.h"

namespace pipeline {

namespace fs = std::filesystem;

namespace {

constexpr const char* kContents = "contents";

// Calls visit(name, entry) for each file that the index lists by a plain name.
template <class Visit>
void forEachFile(const Json& index, Visit visit) {
    if (!index[kContents].is(Json::kArray)) return;
    for (const Json& entry : index[kContents]) {
        const fs::path file = entry["file"].text();
        if (file.has_filename() && file == file.filename()) visit(file.string(), entry);
    }
}

// The SHA-256 that an index has for a file; empty where it has none.
std::string hashIn(const Json& index, const std::string& name) {
    std::string hash;
    forEachFile(index, [&](const std::string& listed, const Json& entry) {
        if (listed == name && entry["sha256"].is(Json::kString)) hash = entry["sha256"].text();
    });
    return hash;
}

// A name with bytes that are no UTF-8 is listed as it can be.
std::string listed(const std::string& name) { return Json::parse(Json(name).dump()).text(); }

Json fileEntry(const std::string& name, std::uintmax_t bytes, const std::optional<std::string>& hash) {
    return {{"file", listed(name)}, {"bytes", bytes}, {"sha256", hash.value_or("")}};
}

}  // namespace

Json contentsOf(const fs::path& folder, const std::vector<std::string>& names) {
    Json contents = Json::array();
    for (const std::string& name : names) {
        std::error_code ignored;
        contents.push_back(fileEntry(name, fs::file_size(folder / name, ignored), sha256(folder / name)));
    }
    return contents;
}

Json contentsOf(const std::vector<std::pair<std::string, std::string>>& files) {
    Json contents = Json::array();
    for (const auto& [name, bytes] : files) contents.push_back(fileEntry(name, bytes.size(), sha256Of(bytes)));
    return contents;
}

Json readIndex(const fs::path& folder, const std::string& index) {
    constexpr std::size_t kLevels = 16;
    const Result<std::string> text = readOwnFile(folder / index);
    if (!text) return {};
    return Json::read(*text, {kLevels, "settings"}).value_or(Json());
}

std::vector<std::string> namesIn(const Json& index) {
    std::vector<std::string> names;
    forEachFile(index, [&](const std::string& name, const Json&) { names.push_back(name); });
    return names;
}

std::string whyInDoubt(const fs::path& folder, const std::string& index, const Json& found) {
    std::error_code ignored;
    if (found.is(Json::kNull)) {
        if (fs::exists(folder / unfinishedName(index), ignored))
            return fmt::format("{} is missing: the run before was ended by force", index);
        return fs::exists(folder / index, ignored) ? index + " cannot be read" : std::string();
    }
    if (!found.find(kContents)) return index + " does not list what its files hold";
    std::string why;
    forEachFile(found, [&](const std::string& name, const Json& entry) {
        if (!why.empty() || !fs::exists(folder / name, ignored)) return;
        // A stranger's folder may hold a pipe, which is never read to its end.
        if (!fs::is_regular_file(folder / name, ignored) || entry["bytes"] != fs::file_size(folder / name, ignored) ||
            entry["sha256"] != sha256(folder / name).value_or("-"))
            why = fmt::format("{} is not as {} has it", name, index);
    });
    return why;
}

std::string unfinishedName(const std::string& index) { return fs::path(index).filename().string() + ".unfinished"; }

Json programMark() { return {{"name", "Shadescope"}, {"version", programVersion()}}; }

namespace {

// Pages of the program name it in their footers.
bool isMarkedPage(const fs::path& page) {
    const Result<std::string> text = readOwnFile(page);
    if (!text) return false;
    const std::size_t end = text->rfind("</footer>");
    const std::size_t start = end == text->npos ? end : text->rfind("<footer", end);
    return start != text->npos && text->find("Shadescope ", start) < end;
}

bool isMarkedIndex(const Json& index) {
    return index["program"]["name"] == "Shadescope" || index["format"] == "shadescope study";
}

}  // namespace

Errors whyNotReplaced(const fs::path& folder, const std::vector<std::string>& names, const std::string& index) {
    std::error_code ignored;
    const bool isPage = index.ends_with(".html");
    const Json found = isPage ? Json() : readIndex(folder, index);
    const bool isOurs = isPage ? isMarkedPage(folder / index) : isMarkedIndex(found);
    std::vector<std::string> onTheirWay;  // also in folders below: they are only compared
    const Json unfinished = readIndex(folder, unfinishedName(index));
    if (unfinished[kContents].is(Json::kArray))
        for (const Json& entry : unfinished[kContents]) onTheirWay.push_back(entry["file"].text());
    const std::vector<std::string> listed = namesIn(found);
    const bool lists = found.find(kContents) != nullptr;
    const auto has = [](const std::vector<std::string>& all, const std::string& name) {
        return std::ranges::find(all, name) != all.end();
    };
    Errors errors;
    for (const std::string& name : names) {
        const fs::path file = folder / name;
        if (!fs::exists(fs::symlink_status(file, ignored)) || has(onTheirWay, name)) continue;
        if (!isOurs && name.ends_with(".html") && isMarkedPage(file)) continue;
        if (!isOurs || (lists && name != index && !has(listed, name)))
            errors.push_back(
                {{file.string()}, "is there, and Shadescope did not write it", "another folder, or --force"});
        else if (name.ends_with(".toml") && lists && sha256(file).value_or("") != hashIn(found, name))
            errors.push_back({{file.string()}, "was changed since Shadescope wrote it", "another folder, or --force"});
        if (errors.size() == kMaxErrors) break;
    }
    return errors;
}

std::string unfinishedText(const std::vector<std::string>& names) {
    Json files = Json::array();
    for (const std::string& name : names) files.push_back({{"file", listed(name)}});
    const Json all{{"about",
                    "Shadescope is writing into this folder, or was ended by force while it did. Then the files below "
                    "may be of two runs; the next run into this folder replaces them."},
                   {kContents, files}};
    return all.dump(2) + '\n';
}

}  // namespace pipeline
