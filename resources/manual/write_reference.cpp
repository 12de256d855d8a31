// Writes reference.md, the part of the manual that is made from the program's tables.
//   write_reference FILE           writes it
//   write_reference --check FILE   exit status 1 when the file says something else
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <sstream>

#include "lessons/expression/function_table.h"
#include "pipeline/buffers/buffer_table.h"
#include "pipeline/contracts/contract.h"
#include "pipeline/core/text.h"
#include "pipeline/defects/defect_table.h"
#include "pipeline/defects/own.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/scene/settings_table.h"

namespace {

using pipeline::shortestText;

std::string stages() {
    std::string text = "## Stages\n\n| name | what it does | takes | leaves |\n|---|---|---|---|\n";
    for (const pipeline::StageId id : pipeline::kStages) {
        const pipeline::StageInfo& stage = pipeline::stageInfo(id);
        text += fmt::format("| `{}` | {} | {} | {} |\n", stage.name, stage.summary, stage.takes, stage.leaves);
    }
    return text;
}

std::string_view domainText(pipeline::Domain domain) {
    switch (domain) {
        case pipeline::Domain::Vertex: return "vertex";
        case pipeline::Domain::Polygon: return "polygon";
        case pipeline::Domain::Pixel: return "pixel";
        case pipeline::Domain::Texel: return "texel";
    }
    return "";
}

std::string buffers() {
    std::string text =
        "\n## Buffers\n\n*k* is a light's index, from 0.\n\n"
        "| name | from | one per | numbers | unit, space | what |\n|---|---|---|---|---|---|\n";
    for (const pipeline::BufferInfo& info : pipeline::bufferTable()) {
        std::string unit(info.unit);
        if (!info.space.empty()) unit += (unit.empty() ? "" : ", ") + std::string(info.space);
        text += fmt::format("| `{}{}` | {} | {} | {} | {} | {} |\n", info.name, info.perLight ? ".k" : "",
                            pipeline::stageInfo(info.stage).name, domainText(info.domain), info.channels, unit,
                            info.meaning);
    }
    text += "\n[Derived](buffers.md#derived-buffers) of a frame:\n\n| name | numbers | what |\n|---|---|---|\n";
    for (const pipeline::BufferInfo& info : pipeline::derivedTable())
        text +=
            fmt::format("| `{}{}` | {} | {} |\n", info.name, info.perLight ? ".k" : "", info.channels, info.meaning);
    return text;
}

std::string valuesText(const pipeline::Setting& setting) {
    std::string text;
    for (const std::string_view choice : setting.choices)
        text += fmt::format("{}`{}`", text.empty() ? "" : ", ", choice);
    if (!text.empty()) return text;
    return shortestText(setting.min) + " to " + shortestText(setting.max);
}

std::string defaultText(const pipeline::Setting& setting, const pipeline::Scene& scene) {
    const pipeline::SettingRef ref{&setting, 0};
    const std::string text = formatSetting(ref, ref.get(scene));
    return setting.choices.empty() ? text : fmt::format("`{}`", text);
}

// A scene that gives nothing, with a light and an object that give nothing, as its reader completes it.
pipeline::Scene defaultScene() {
    return pipeline::readTomlScene({"[[light]]\n[[object]]\nshape = \"sphere\"\n", "defaults.toml"}, {}).value();
}

std::string settings() {
    std::string text =
        "\n## Settings\n\nFor `--set KEY=VALUE`, and for `set:` in a lesson. `#` is the index of a light or an "
        "object, from 0. The default is the value in a TOML scene without the key. There k_a (`kar` to `kab`) is k_d, "
        "and the colour of OpenGL's specular part is the light's.\n\n"
        "| key | values | default | unit | what |\n|---|---|---|---|---|\n";
    const pipeline::Scene scene = defaultScene();
    for (const pipeline::Setting& setting : pipeline::settingsTable())
        text += fmt::format("| `{}` | {} | {} | {} | {} |\n", setting.key, valuesText(setting),
                            defaultText(setting, scene), setting.unit, setting.meaning);
    return text;
}

std::string cell(std::string_view text) {  // of a table: | stands for its border
    std::string out;
    for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
    return out;
}

std::string ownFunctions() {
    std::string text =
        "\n## Functions to write\n\nWhat [`shadescope stage`](write-the-stage.md) hands over, what it takes back, and "
        "how far "
        "a result may be off. A list is named with …\n\n"
        "| function | stage | arguments | result | may be off | picture | mistakes with a name | lesson, page |\n"
        "|---|---|---|---|---|---|---|---|\n";
    for (std::size_t i = 0; i < pipeline::kOwnCount; ++i) {
        const pipeline::OwnContract& contract = pipeline::ownContract(pipeline::OwnFunction(i));
        std::string arguments, mistakes;
        for (const pipeline::OwnParameter& one : contract.taken())
            arguments += fmt::format("{}`{}`{} {}", arguments.empty() ? "" : "; ", one.name,
                                     isList(one.kind) ? " …" : "", one.meaning);
        for (const pipeline::OwnMistake& one : contract.mistakes)
            mistakes += fmt::format("{}`{}` {}", mistakes.empty() ? "" : "; ", one.id, one.name);
        constexpr std::array<std::string_view, 5> kUnits{"", "", " of the right one", "", " degrees, % of the length"};
        text += fmt::format("| `{}` | {} | {} | {} | {}{} | {} | {} | {}, {} |\n", signatureOf(contract),
                            stageInfo(contract.stage).name, arguments, contract.result,
                            shortestText(contract.tolerance), kUnits[std::size_t(contract.measure)],
                            contract.picture ? "yes" : "", mistakes, contract.lesson, contract.heading);
    }
    return text;
}

std::string defects() {
    std::string text =
        "\n## Planted defects\n\nValues of the setting `defect`, beside `none`. *Way* is the value of `defect_way`. "
        "[How to use them](defects.md).\n\n"
        "| defect | what | the line stands in | wrong | right | other ways |\n|---|---|---|---|---|---|\n";
    for (const pipeline::DefectRow& row : pipeline::defectTable()) {
        std::string ways;
        for (std::size_t i = 0; i < row.otherWays.size(); ++i)
            ways += fmt::format("{}{}: {}", ways.empty() ? "" : "; ", i + 1, row.otherWays[i]);
        text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", row.idText(), row.name,
                            row.stage ? pipeline::stageInfo(*row.stage).name : "the file", cell(row.wrong),
                            cell(row.fix), cell(ways));
    }
    return text;
}

std::string functions() {
    std::string text =
        "\n## Functions\n\nFor [formulas](formulas.md). A place is x, y for a buffer per pixel, and an index for one "
        "per vertex or polygon. A channel is r g b, x y z or 0 1 2; it may be left out. Angles are degrees.\n\n"
        "| call | gives |\n|---|---|\n";
    for (const lessons::Function& function : lessons::functionTable()) {
        std::string fields;
        for (const std::string_view field : lessons::fieldsOf(function.takes))
            fields += fmt::format("{}`{}`", fields.empty() ? " Fields: " : ", ", field);
        if (!fields.empty()) fields += '.';
        text += fmt::format("| `{}{}` | {}{} |\n", function.name, callText(function.takes), function.meaning, fields);
    }
    return text;
}

std::string contracts() {
    std::string text =
        "\n## Contracts\n\nProperties that every stage's output must have. `inspect SCENE --contracts` counts how "
        "often "
        "they hold; the manifest of an export does so for the exported buffers. u is the unit of rounding: 2⁻²⁴ in "
        "float, 2⁻⁵³ in double.\n\n"
        "| name | stage | formula | what | reads | may be off by | source |\n|---|---|---|---|---|---|---|\n";
    // A bar ends a cell.
    const auto cell = [](std::string_view words) {
        std::string escaped;
        for (const char c : words) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
        return escaped;
    };
    for (const pipeline::Contract& contract : pipeline::contractTable()) {
        std::string reads;
        for (const pipeline::BufferId id : contract.reads)
            reads += fmt::format("{}`{}{}`", reads.empty() ? "" : ", ", pipeline::bufferInfo(id).name,
                                 pipeline::bufferInfo(id).perLight ? ".k" : "");
        text +=
            fmt::format("| `{}` | {} | {} | {} | {} | {}{}{} | {} |\n", contract.id,
                        pipeline::stageInfo(contract.stage).name, cell(contract.formula), cell(contract.claim), reads,
                        cell(contract.bound), contract.unit.empty() ? "" : ", in ", contract.unit, contract.source);
    }
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    const bool check = argc == 3 && std::strcmp(argv[1], "--check") == 0;
    if (!check && argc != 2) {
        fmt::print(stderr, "usage: write_reference [--check] FILE\n");
        return 2;
    }
    const std::string text =
        "# Reference\n\n`resources/manual/write_reference.cpp` writes this page from the program's tables; do not edit "
        "it.\n\n" +
        stages() + buffers() + settings() + defects() + ownFunctions() + functions() + contracts();
    if (!check) {
        std::ofstream file(argv[1], std::ios::binary);
        return file << text && file.flush() ? 0 : 4;
    }
    std::ifstream file(argv[2], std::ios::binary);
    std::ostringstream found;
    found << file.rdbuf();
    if (found.str() == text) return 0;
    fmt::print(stderr, "{} is not what the tables say; build the target manual_reference\n", argv[2]);
    return 1;
}
