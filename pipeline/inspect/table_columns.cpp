#include "pipeline/inspect/table_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pipeline::table_columns {
namespace {

// Lecture 1's names for what a setting holds, as its sections "Data Structures" and "Scene
// Description Files" write them.
constexpr std::pair<std::string_view, std::string_view> kLectureNames[] = {
    {"material.#.kr", "kr"}, {"material.#.kg", "kg"},     {"material.#.kb", "kb"}, {"material.#.ks", "ks"},
    {"material.#.n", "n"},   {"object.#.sx", "sx"},       {"object.#.sy", "sy"},   {"object.#.sz", "sz"},
    {"object.#.rx", "αx"},   {"object.#.ry", "αy"},       {"object.#.rz", "αz"},   {"object.#.tx", "tx"},
    {"object.#.ty", "ty"},   {"object.#.tz", "tz"},       {"light.#.x", "Lx"},     {"light.#.y", "Ly"},
    {"light.#.z", "Lz"},     {"light.#.intensity", "Ip"},
};

std::string lectureName(std::string_view key) {
    const auto found = std::ranges::find(kLectureNames, key, &std::pair<std::string_view, std::string_view>::first);
    return found == std::end(kLectureNames) ? std::string() : std::string(found->second);
}

// "pixels, pixels, depth" says it for each channel.
std::string unitOf(const BufferInfo& info, std::size_t channel) {
    std::string_view rest = info.unit;
    if (rest.find(", ") == rest.npos) return std::string(rest);
    for (; channel > 0; --channel) rest.remove_prefix(std::min(rest.find(", "), rest.size() - 2) + 2);
    return std::string(rest.substr(0, rest.find(", ")));
}

}  // namespace

TableColumn rowNumber(std::string lecture, std::string name, std::string meaning) {
    return count(std::move(lecture), std::move(name), std::move(meaning), [](std::size_t row) { return row; });
}

void addSettings(const FramePtr& frame, SettingGroup group, std::vector<TableColumn>& columns,
                 const std::function<bool(std::string_view key)>& keeps) {
    for (const Setting& setting : settingsTable()) {
        if (setting.group != group || !keeps(setting.key)) continue;
        const std::string lecture = lectureName(setting.key);
        if (lecture.empty() && !setting.idle(frame->scene()).empty()) continue;
        const bool isWord = setting.kind == SettingKind::Choice || setting.kind == SettingKind::Switch;
        const bool isWhole = setting.kind == SettingKind::Integer;
        columns.push_back({lecture,
                           std::string(setting.key),
                           std::string(setting.unit),
                           std::string(setting.meaning),
                           -1,
                           {},
                           [frame, &setting, isWord, isWhole](std::size_t i) -> Cell {
                               if (!setting.absent(frame->scene(), i).empty()) return {};
                               const double value = setting.get(frame->scene(), i);
                               if (isWord) return std::string(setting.choices[std::size_t(value)]);
                               if (isWhole) return std::int64_t(value);
                               return value;
                           }});
    }
}

void addBuffer(const FramePtr& frame, BufferId id, std::array<std::string, 3> lecture, std::array<std::string, 3> parts,
               int decimals, SceneTable& table) {
    const BufferInfo& info = bufferInfo(id);
    // Shared by the three columns; it keeps the frame's data alive.
    const auto buffer = std::make_shared<const std::optional<AnyBuffer>>(frame->buffer({id}));
    const auto with =
        std::make_shared<const std::vector<bool>>(*buffer ? rowsWithValue(**buffer) : std::vector<bool>());
    if (const auto without = std::ranges::count(*with, false); without > 0)
        table.facts.push_back({"", std::string(info.withoutValue), "", std::int64_t(without)});
    for (std::size_t c = 0; c < 3; ++c)
        table.columns.push_back(
            {lecture[c], fmt::format("{}{}", info.name, parts[c]), unitOf(info, c), std::string(info.meaning), decimals,
             *buffer ? std::string() : frame->whyAbsent({id}), [frame, buffer, with, c](std::size_t row) -> Cell {
                 if (!*buffer || (!with->empty() && !(*with)[row])) return {};
                 return std::visit(
                     [i = 3 * row + c](const auto& numbers) -> Cell {
                         if constexpr (std::floating_point<typename std::decay_t<decltype(numbers)>::value_type>)
                             return numbers[i];
                         else
                             return std::int64_t(numbers[i]);
                     },
                     (*buffer)->data);
             }});
}

std::vector<TableFact> viewingFacts(const Scene& scene) {
    const Camera& camera = scene.camera;
    if (camera.kind == CameraKind::Spherical)
        return {{"scrn_dist", "camera.distance", "screen units", camera.screenDistance},
                {"ρ", "camera.rho", "world units", camera.rho},
                {"θ", "camera.theta", "degrees", camera.theta},
                {"φ", "camera.phi", "degrees", camera.phi}};
    std::vector<TableFact> facts;
    facts.reserve(6);
    for (int axis = 0; axis < 3; ++axis)
        facts.push_back({"", fmt::format("camera.eye_{}", "xyz"[axis]), "world units", camera.eye[axis]});
    for (int axis = 0; axis < 3; ++axis)
        facts.push_back({"", fmt::format("camera.target_{}", "xyz"[axis]), "world units", camera.target[axis]});
    return facts;
}

std::optional<double> largestIntensity(const Frame& frame) {
    return readStages(frame, [](const auto& data) -> std::optional<double> {
        if (!data.shading) return {};
        return data.shading->iMax;
    });
}

int lengthDecimals(const Frame& frame) {
    const double farthest = readStages(frame, [](const auto& data) {
        return data.transform ? std::max(std::abs(data.transform->view.near), std::abs(data.transform->view.far)) : 1.0;
    });
    constexpr int kDigits = 6, kMost = 12;
    return farthest > 0 ? std::clamp(kDigits - 1 - int(std::floor(std::log10(farthest))), 0, kMost) : kDigits;
}

int depthDecimals(const Frame& frame) {
    // Neighbours in float differ in the seventh digit.
    return frame.scene().settings.depthFormat == DepthFormat::Linear ? lengthDecimals(frame) + 1 : 7;
}

int intensityDecimals(const Frame& frame) { return modelFacts(frame.scene().settings.model).decimals; }

}  // namespace pipeline::table_columns
