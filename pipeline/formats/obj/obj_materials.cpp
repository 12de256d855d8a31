#include "pipeline/formats/obj/obj_materials.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "pipeline/core/text.h"
#include "pipeline/formats/text/line_scanner.h"
#include "pipeline/formats/text/text_scanner.h"
#include "pipeline/formats/text/utf16.h"

namespace pipeline {
namespace {

std::string inLowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

std::string withoutQuotes(std::string name) {
    if (name.size() > 2 && name.front() == '"' && name.back() == '"') return name.substr(1, name.size() - 2);
    return name;
}

// How else a name may be meant that was written on another machine: without quotes, with slashes, or as the file's name
// alone, without folders that are there no more.
std::vector<std::string> otherReadings(const std::string& name) {
    std::string slashes = withoutQuotes(name);
    std::ranges::replace(slashes, '\\', '/');
    std::vector<std::string> readings;
    for (const std::string& reading : {slashes, std::filesystem::path(slashes).filename().string()})
        if (!reading.empty() && reading != name && std::ranges::find(readings, reading) == readings.end())
            readings.push_back(reading);
    return readings;
}

std::vector<std::string> wordsOf(std::string_view text) {
    Errors none;
    LineScanner scanner(text, {}, none);
    std::vector<std::string> words;
    if (scanner.nextLine())
        for (std::string_view word = scanner.next(); !word.empty(); word = scanner.next()) words.emplace_back(word);
    return words;
}

}  // namespace

void ObjMaterials::load(std::string_view names, int line) {
    const std::string all(names);
    const std::string place = fmt::format("{}:{}", m_obj.name, line);
    if (all.empty()) {
        if (m_tried.try_emplace("").second) m_missing.add(place, "mtllib names no file.");
        return;
    }
    std::string whyNot;
    if (loadOne(all, line, whyNot)) return;
    const std::vector<std::string> words = wordsOf(names);
    std::vector<std::string> failed;
    if (words.size() > 1 || (words.size() == 1 && words[0] != all)) {  // one: before a comment
        whyNot.clear();
        std::size_t found = 0;
        for (const std::string& word : words) {
            std::string why;
            if (loadOne(word, line, why))
                ++found;
            else if (!why.empty())
                failed.push_back(std::move(why));
        }
        // A name with spaces whose words are no files either is one name.
        if (found == 0 && !failed.empty()) failed = {m_tried[all]};
    } else if (!whyNot.empty()) {
        failed.push_back(std::move(whyNot));
    }
    for (const std::string& why : failed)
        m_missing.add(place, why + ". Faces with its materials have the default material.");
}

// whyNot: stays empty where the same was said before.
bool ObjMaterials::loadOne(const std::string& written, int line, std::string& whyNot) {
    const auto [tried, isNew] = m_tried.try_emplace(written);
    if (!isNew) return tried->second.empty();
    if (open(written, written, line, whyNot)) return true;
    for (const std::string& reading : otherReadings(written)) {
        std::string whyNeither;
        if (open(reading, written, line, whyNeither)) {
            whyNot.clear();
            return true;
        }
    }
    tried->second = whyNot;
    return false;
}

bool ObjMaterials::open(const std::string& name, const std::string& written, int line, std::string& whyNot) {
    if (isModel(std::filesystem::path(name).extension().string())) {
        whyNot = quotedInput(written) + " is a model and no file of materials";
        return false;
    }
    const Result<NamedFile> file = m_load(name);
    if (!file) {
        whyNot = file.errors().front().found;
        return false;
    }
    const std::string opened = file->otherName.empty() ? name : file->otherName;
    if (opened != written)
        m_otherNames.add(
            fmt::format("{}:{}", m_obj.name, line),
            fmt::format("{} is not there; {} is read in its place.", quotedInput(written), quotedInput(opened)));
    if (!m_read.insert(std::filesystem::path(file->path).lexically_normal().string()).second) return true;
    const std::size_t known = m_materials.size();
    const std::string text = isUtf16(file->text) ? utf8Of(file->text) : std::string();
    readMtl({text.empty() ? std::string_view(file->text) : text, file->path, m_obj.progress, file->tail}, m_materials,
            m_tallies, m_errors);
    for (std::size_t i = known; i < m_materials.size(); ++i) {
        m_of.try_emplace(m_materials[i].name, i);
        m_ofLowerCase.try_emplace(inLowerCase(m_materials[i].name), i);
    }
    return true;
}

const Material* ObjMaterials::find(std::string_view name) const {
    if (const Material* material = findWritten(name)) return material;
    // A name may hold " #", so what follows it is a comment only where nothing has the whole name.
    const std::size_t comment = std::min(name.find(" #"), name.find("\t#"));
    if (comment == name.npos) return nullptr;
    name = name.substr(0, comment);
    while (name.ends_with(' ') || name.ends_with('\t')) name.remove_suffix(1);
    return findWritten(name);
}

const Material* ObjMaterials::findWritten(std::string_view name) const {
    if (const auto same = m_of.find(name); same != m_of.end()) return &m_materials[same->second].material;
    const auto similar = m_ofLowerCase.find(inLowerCase(name));
    return similar == m_ofLowerCase.end() ? nullptr : &m_materials[similar->second].material;
}

std::vector<Remark> ObjMaterials::remarks() const {
    std::vector<Remark> all;
    for (const Said* said : {&m_missing, &m_otherNames}) {
        if (said->count == 0) continue;
        all.push_back(said->first);
        if (said->count > 1)
            all.back().text +=
                fmt::format(" The same holds for {}.", plural(std::int64_t(said->count) - 1, "further material file"));
    }
    m_tallies.say(all);
    return all;
}

}  // namespace pipeline
