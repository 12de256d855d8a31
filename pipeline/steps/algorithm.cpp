#include "pipeline/steps/algorithm.h"

#include <algorithm>
#include <array>

#include "pipeline/scene/area_light.h"
#include "pipeline/scene/settings_table.h"

namespace pipeline {
namespace {

// Calls visit(word) for each word between separators, until it returns true. Returns whether it did.
template <class Visit>
bool anyWord(std::string_view words, char separator, Visit visit) {
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(separator), words.size());
        if (end > 0 && visit(words.substr(0, end))) return true;
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return false;
}

bool isAmong(std::string_view value, std::string_view alternatives) {
    return anyWord(alternatives, '|', [&](std::string_view one) { return one == value; });
}

bool hasMeans(const Scene& scene) {
    return scene.settings.shadowFilter > 0 || std::ranges::any_of(scene.lights, [](const Light& light) {
               return light.castsShadow && sampleGrid(light).count() > 1;
           });
}

// A model whose terms have no lines of their own shows values alone.
std::string_view formulaOf(Model model) {
    const std::string_view word = modelFacts(model).word;
    const auto namesIt = [&](std::string_view condition) {
        constexpr std::string_view kKey = "formula=";
        return condition.starts_with(kKey) && isAmong(word, condition.substr(kKey.size()));
    };
    const bool isWritten = std::ranges::any_of(algorithmTable(), [&](const AlgorithmText& text) {
        return std::ranges::any_of(text.lines,
                                   [&](const AlgorithmLine& line) { return anyWord(line.when, ' ', namesIt); });
    });
    return isWritten ? word : "other";
}

std::string_view highlightOf(const Scene& scene) {
    if (modelFacts(scene.settings.model).lobe == Lobe::None) return "none";
    const auto halfway = std::size_t(std::ranges::count_if(
        scene.objects, [&](const Object& object) { return usesHalfway(scene.settings.model, object.material); }));
    return halfway == 0 ? "R" : halfway == scene.objects.size() ? "H" : "R or H";
}

// What lines depend on apart from single settings.
struct SceneFact {
    std::string_view key;
    std::string_view (*value)(const Scene&, ElementKind);
};
constexpr std::array kSceneFacts{
    // The kind of element of the step, as a place names it.
    SceneFact{"element", [](const Scene&, ElementKind kind) { return name(kind); }},
    // Whether the illumination model is evaluated in this step.
    SceneFact{"evaluated",
              [](const Scene& scene, ElementKind kind) -> std::string_view {
                  return kind != ElementKind::Polygon || scene.settings.shading == Shading::Phong ? "here" : "before";
              }},
    SceneFact{"highlight", [](const Scene& scene, ElementKind) { return highlightOf(scene); }},
    SceneFact{"formula", [](const Scene& scene, ElementKind) { return formulaOf(scene.settings.model); }},
    // Whether the illumination model has shadows, and whether it clamps its results.
    SceneFact{"shadows",
              [](const Scene& scene, ElementKind) -> std::string_view {
                  return modelFacts(scene.settings.model).shadows ? "on" : "off";
              }},
    SceneFact{"clamped",
              [](const Scene& scene, ElementKind) -> std::string_view {
                  return modelFacts(scene.settings.model).clamps ? "on" : "off";
              }},
    // Whether S is one comparison or a mean of several.
    SceneFact{
        "shadow",
        [](const Scene& scene, ElementKind) -> std::string_view { return hasMeans(scene) ? "mean" : "comparison"; }},
};

std::string valueOf(std::string_view key, const Scene& scene, ElementKind kind) {
    const auto fact = std::ranges::find(kSceneFacts, key, &SceneFact::key);
    if (fact != kSceneFacts.end()) return std::string(fact->value(scene, kind));
    const auto setting = findSetting(scene, key);
    return setting ? formatSetting(*setting, setting->get(scene)) : std::string();
}

// The plan's reason for leaving out "shading/ambient term" or the stage "shadow-buffer"; empty if it runs.
std::string whyLeftOut(const Plan& plan, std::string_view part) {
    const std::size_t slash = std::min(part.find('/'), part.size());
    const auto stage = findStage(part.substr(0, slash));
    if (!stage) return {};
    const PlanStep& step = plan[index(*stage)];
    if (step.action == Action::LeaveOut) return step.why;
    if (slash == part.size()) return {};
    const bool isPrefix = part.ends_with('*');
    const std::string_view name = part.substr(slash + 1, part.size() - slash - (isPrefix ? 2 : 1));
    std::string why;
    for (const PlanPart& one : step.parts) {
        if (isPrefix ? !one.name.starts_with(name) : one.name != name) continue;
        if (one.action != Action::LeaveOut) return {};
        why = one.why;
    }
    return why;
}

Algorithm::Line resolved(const AlgorithmLine& row, const Plan& plan, StageId stage) {
    const std::size_t spaces = row.text.find_first_not_of(' ');
    Algorithm::Line line{&row, {}, int(spaces / 2), {}};
    for (const char c : row.text.substr(spaces))
        if (c != '{' && c != '}') line.text += c;
    if (plan[index(stage)].action == Action::LeaveOut)
        line.leftOut = plan[index(stage)].why;
    else if (!row.part.empty())
        line.leftOut = whyLeftOut(plan, row.part);
    return line;
}

}  // namespace

bool holds(std::string_view when, const Scene& scene, ElementKind kind) {
    return !anyWord(when, ' ', [&](std::string_view condition) {
        const std::size_t equals = condition.find('=');
        const bool unlike = condition[equals - 1] == '!';
        return isAmong(valueOf(condition.substr(0, equals - (unlike ? 1 : 0)), scene, kind),
                       condition.substr(equals + 1)) == unlike;
    });
}

std::optional<Algorithm> algorithmOf(const Frame& frame, StageId stage, ElementKind kind) {
    const auto row = std::ranges::find_if(algorithmTable(), [&](const AlgorithmText& text) {
        return text.stage == stage && isAmong(name(kind), text.elements) && holds(text.when, frame.scene(), kind);
    });
    if (row == algorithmTable().end()) return std::nullopt;
    Algorithm algorithm{&*row, {}};
    int left = -1;  // indentation of a loop or branch that is left out, with everything inside it
    for (const AlgorithmLine& one : row->lines) {
        if (!holds(one.when, frame.scene(), kind)) continue;
        Algorithm::Line line = resolved(one, frame.plan(), stage);
        if (left >= 0 && line.indent <= left) left = -1;
        if (left >= 0 && line.leftOut.empty()) line.leftOut = algorithm.lines.back().leftOut;
        if (left < 0 && !line.leftOut.empty()) left = line.indent;
        algorithm.lines.push_back(std::move(line));
    }
    return algorithm;
}

std::array<int, 2> Walk::numbersOf(std::size_t visit) const {
    const std::size_t line = visits[visit].line;
    int time = 1;
    for (std::size_t i = 0; i < visit; ++i) time += visits[i].line == line;
    return {int(line) + 1, time};
}

std::optional<std::size_t> Walk::visitOf(int line, int time) const {
    std::optional<std::size_t> after;
    for (std::size_t i = 0; i < visits.size(); ++i) {
        const std::array<int, 2> numbers = numbersOf(i);
        if (numbers == std::array{line, time}) return i;
        if (!after && numbers[1] >= time && numbers[0] > line) after = i;
    }
    return after;
}

}  // namespace pipeline
