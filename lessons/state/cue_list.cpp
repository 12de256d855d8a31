#include "lessons/state/cue_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "lessons/state/state_text.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/formats/toml/toml_writer.h"

namespace lessons {

using pipeline::Error;
using pipeline::Result;
using pipeline::TomlValues;

namespace {

constexpr std::size_t kMaxCues = 1000;
const KnownKeys kListKeys{"title", "minutes", "cue"};
const KnownKeys kCueKeys{"name", "caption", "note", "ask", "choices", "right"};
constexpr std::size_t kMostChoices = 4, kLeastChoices = 2;

// ask, choices and right, which go together.
std::optional<CueQuestion> questionIn(const toml::table& cue, const std::string& path, TomlValues& values) {
    const auto* ask = cue.get("ask");
    const auto* choices = cue.get("choices");
    const auto* right = cue.get("right");
    if (!ask && !choices && !right) return {};
    if (!ask || !choices || !right) {
        values.fail(cue.source(), path + " has a question without all of its parts", "ask, choices and right");
        return {};
    }
    CueQuestion question;
    question.text = values.text(*ask, path + ".ask").value_or("");
    const auto* list = choices->as_array();
    if (!list || list->size() < kLeastChoices || list->size() > kMostChoices) {
        values.refuse(*choices, path + ".choices", "an array of 2 to 4 texts");
        return {};
    }
    for (std::size_t i = 0; i < list->size(); ++i)
        question.choices.push_back(values.text((*list)[i], fmt::format("{}.choices.{}", path, i)).value_or(""));
    const std::string letter = values.text(*right, path + ".right").value_or("A");
    question.right = letter.size() == 1 ? std::size_t(letter[0] - 'A') : kMostChoices;
    if (question.right >= question.choices.size())
        values.fail(right->source(), fmt::format("{}.right is {}", path, pipeline::inQuotes(letter)),
                    fmt::format("a letter from A to {}", char('A' + question.choices.size() - 1)));
    return question;
}

std::string questionText(const CueQuestion& question) {
    std::vector<std::string> choices;
    for (const std::string& choice : question.choices) choices.push_back(pipeline::tomlString(choice));
    return fmt::format("ask = {}\nchoices = [{}]\nright = \"{}\"\n", pipeline::tomlString(question.text),
                       fmt::join(choices, ", "), char('A' + question.right));
}

}  // namespace

std::string toToml(const CueList& list) {
    std::string text;
    if (!list.title.empty()) text += fmt::format("title = {}\n", pipeline::tomlString(list.title));
    text += fmt::format("minutes = {}\n", list.minutes);
    for (const Cue& cue : list.cues) {
        text += fmt::format("\n[[cue]]\nname = {}\n", pipeline::tomlString(cue.name));
        if (!cue.caption.empty()) text += fmt::format("caption = {}\n", pipeline::tomlString(cue.caption));
        if (!cue.note.empty()) text += fmt::format("note = {}\n", pipeline::tomlText(cue.note));
        if (cue.ask) text += questionText(*cue.ask);
        text += stateText(cue.state, "cue.");
    }
    return text;
}

Result<CueList> readCues(std::string_view text, const std::string& file, const pipeline::Stop& stop) {
    const auto table = pipeline::parseToml({text, file, {{}, stop}});
    if (!table) return table.errors();
    TomlValues values(file);
    CueList list;
    for (const auto& [key, node] : *table)
        if (std::ranges::find(kListKeys, key.str()) == kListKeys.end())
            values.unknown(key, std::string(key.str()), kListKeys);
    if (const auto* node = table->get("title")) list.title = values.text(*node, "title").value_or("");
    if (const auto* node = table->get("minutes"))
        list.minutes = int(values.wholeNumber(*node, "minutes", 1, 600).value_or(list.minutes));
    const auto* cues = table->get("cue");
    for (const toml::table* one : cues ? values.tables(*cues, "cue", kMaxCues) : std::vector<const toml::table*>()) {
        const std::string path = fmt::format("cue.{}", list.cues.size());
        Cue cue;
        cue.state = readStateTable(*one, path, kCueKeys, values);
        for (auto [key, into] : {std::pair{"name", &cue.name}, {"caption", &cue.caption}, {"note", &cue.note}})
            if (const auto* node = one->get(key)) *into = values.text(*node, path + '.' + key).value_or("");
        cue.ask = questionIn(*one, path, values);
        if (cue.name.empty()) values.fail(one->source(), path + " has no name", "a name");
        if (std::ranges::find(list.cues, cue.name, &Cue::name) != list.cues.end())
            values.fail(one->source(), path + ": another cue is called " + pipeline::inQuotes(cue.name),
                        "another name");
        if (cue.state.scene.empty() && cue.state.sceneText.empty())
            values.fail(one->source(), path + " has no scene", "a file, or the name of a built-in scene");
        list.cues.push_back(std::move(cue));
    }
    const pipeline::Errors errors = values.errors();
    if (!errors.empty()) return errors;
    return list;
}

Result<std::string> readCueText(const std::filesystem::path& file) {
    auto text = pipeline::readFile(file, pipeline::kMaxTomlBytes);
    if (text) return text;
    pipeline::Errors errors = text.errors();
    for (Error& error : errors)
        if (error.where.file.empty()) error.where.file = file.string();
    return errors;
}

Result<CueList> readCueFile(const std::filesystem::path& file, const pipeline::Stop& stop) {
    const auto text = readCueText(file);
    return text ? readCues(*text, file.string(), stop) : Result<CueList>(text.errors());
}

std::optional<std::size_t> asking(const CueList& list, std::size_t cue) {
    if (cue < list.cues.size() && list.cues[cue].ask) return cue;
    return cue > 0 && cue < list.cues.size() && list.cues[cue - 1].ask ? std::optional(cue - 1) : std::nullopt;
}

Result<std::size_t> findCue(const CueList& list, std::string_view name) {
    const auto found = std::ranges::find(list.cues, name, &Cue::name);
    if (found != list.cues.end()) return std::size_t(found - list.cues.begin());
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (error == std::errc() && end == name.data() + name.size() && number >= 1 && number <= list.cues.size())
        return number - 1;
    std::vector<std::string> names;
    for (const Cue& cue : list.cues) names.push_back(cue.name);
    return Error{{},
                 fmt::format("no cue {}", pipeline::inQuotes(name)),
                 names.empty() ? std::string("a list with cues")
                               : fmt::format("a number from 1 to {}, or a name; {}", names.size(),
                                             pipeline::insteadOf(name, names))};
}

std::filesystem::path cueFileAt(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored) || path.has_parent_path()) return path;
    std::filesystem::path own = pipeline::resourceFolder() / "manual" / path;
    if (own.extension() != kCueEnding) own += kCueEnding;
    return std::filesystem::is_regular_file(own, ignored) ? own : path;
}

Result<CueName> parseCueName(std::string_view text) {
    const auto splitAt = [&](std::size_t colon) {
        return CueName{cueFileAt(text.substr(0, colon)), std::string(text.substr(colon + 1))};
    };
    const std::size_t first = text.find(':');
    if (first == text.npos) return Error{{}, "no cue " + pipeline::inQuotes(text), "FILE:NAME or FILE:NUMBER"};
    std::error_code ignored;
    for (std::size_t colon = first; colon != text.npos; colon = text.find(':', colon + 1))
        if (CueName name = splitAt(colon); std::filesystem::is_regular_file(name.file, ignored)) return name;
    return splitAt(first);  // who reads it is told that there is none
}

std::string freeName(const CueList& list, const std::string& wanted) {
    const auto taken = [&](const std::string& name) {
        return std::ranges::find(list.cues, name, &Cue::name) != list.cues.end();
    };
    std::string name = wanted;
    for (int number = 2; taken(name); ++number) name = fmt::format("{} {}", wanted, number);
    return name;
}

}  // namespace lessons
