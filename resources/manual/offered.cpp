#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lessons/library.h"
#include "pipeline/buffers/buffer_table.h"
#include "pipeline/check/case.h"
#include "pipeline/core/stage.h"
#include "pipeline/defects/own.h"
#include "pipeline/export/buffers/exporter.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/study/sweep.h"
#include "resources/manual/completions.h"

namespace manual {

namespace {

using Words = std::vector<std::string>;

Words scenes() {
    Words words;
    for (const pipeline::BuiltInScene& scene : pipeline::builtInScenes()) words.push_back(scene.name);
    return words;
}

Words lessonNames() {
    Words words;
    for (const lessons::Lesson& lesson : lessons::allLessons().lessons) words.push_back(lesson.name);
    return words;
}

Words buffers() {
    Words words;
    for (const pipeline::BufferInfo& info : pipeline::bufferTable())
        words.push_back(fmt::format("{}{}", info.name, info.perLight ? ".0" : ""));
    return words;
}

Words allBuffers() {
    Words words = buffers();
    words.insert(words.begin(), "all");
    return words;
}

Words formats() {
    Words words;
    for (const pipeline::Exporter& exporter : pipeline::exporterTable()) words.emplace_back(exporter.name);
    return words;
}

Words stages() {
    Words words;
    for (const pipeline::StageId stage : pipeline::kStages) words.emplace_back(pipeline::stageInfo(stage).name);
    return words;
}

// Of the first light and the first object, and with each value where there are only a few.
Words settings() {
    Words words;
    for (const pipeline::Setting& setting : pipeline::settingsTable()) {
        std::string key(setting.key);
        std::ranges::replace(key, '#', '0');
        if (setting.choices.empty()) words.push_back(key + "=");
        for (const std::string_view choice : setting.choices) words.push_back(fmt::format("{}={}", key, choice));
    }
    return words;
}

Words ownFunctions() {
    Words words = stages();
    for (std::size_t i = 0; i < pipeline::kOwnCount; ++i)
        words.emplace_back(pipeline::ownContract(pipeline::OwnFunction(i)).name);
    return words;
}

Words sweeps() {
    Words words;
    for (const pipeline::NamedSweep& sweep : pipeline::namedSweeps()) words.emplace_back(sweep.name);
    return words;
}

Words cases() {
    Words words;
    for (const pipeline::check::Case& item : pipeline::check::caseTable()) words.emplace_back(item.id);
    return words;
}

Words groups() {
    Words words;
    for (std::size_t i = 0; i < pipeline::check::kGroupCount; ++i)
        words.emplace_back(name(static_cast<pipeline::check::Group>(i)));
    return words;
}

struct ValueRow {
    std::string_view value;
    Words (*words)();
    bool list = false, files = false, folders = false;
};
constexpr std::array kValues{
    ValueRow{.value = "SCENE", .words = scenes, .files = true},
    ValueRow{.value = "LESSON", .words = lessonNames, .folders = true},
    ValueRow{.value = "KEY=VALUE", .words = settings},
    ValueRow{.value = "all|NAME,...", .words = allBuffers, .list = true},
    ValueRow{.value = "NAME,...", .words = formats, .list = true},
    ValueRow{.value = "NAME", .words = buffers},
    ValueRow{.value = "STAGE", .words = stages},
    ValueRow{.value = "FUNCTION", .words = ownFunctions},
    ValueRow{.value = "SWEEP", .words = sweeps},
    ValueRow{.value = "ID", .words = cases},
    ValueRow{.value = "GROUP", .words = groups},
    ValueRow{.value = "DIR", .words = nullptr, .folders = true},
    ValueRow{.value = "FILE", .words = nullptr, .files = true},
    ValueRow{.value = "REPORT.html|DIR", .words = nullptr, .files = true, .folders = true},
    ValueRow{.value = "|FILE ...", .words = nullptr, .files = true, .folders = true},
    ValueRow{.value = "FILE:NAME", .words = nullptr, .files = true},
    ValueRow{.value = "FILE.gif|DIR", .words = nullptr, .files = true},
};

}  // namespace

Offered offeredFor(const app::OptionText& option) {
    if (!option.choices.empty()) return {.words = option.choices};
    const auto* const row = std::ranges::find(kValues, option.value, &ValueRow::value);
    if (row == kValues.end()) return {};
    return {
        .words = row->words ? row->words() : Words{}, .list = row->list, .files = row->files, .folders = row->folders};
}

}  // namespace manual
