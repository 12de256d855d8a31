#include "lessons/questions/answer_text.h"

#include <fmt/format.h>

#include <functional>

#include "lessons/lesson_text.h"
#include "pipeline/core/text.h"
#include "pipeline/defects/own_words.h"
#include "pipeline/inspect/own_calls.h"

// What an answer is, in words.

namespace lessons {

namespace {

using pipeline::Result;

constexpr std::size_t kMostNamed = 12;  // things that are listed

Result<std::string> textOf(const NumberQuestion& number, const Context& context) {
    const auto answer = evaluate(number.answer, context);
    if (!answer) return answer.errors();
    std::string text = toText(*answer);
    if (number.tolerance > 0)
        text += number.relative ? fmt::format(" ± {} %", pipeline::shortestText(100 * number.tolerance))
                                : fmt::format(" ± {}", pipeline::shortestText(number.tolerance));
    if (!number.unit.empty()) text += ' ' + number.unit;
    return text;
}

Result<std::string> textOf(std::span<const Option> options, const Context& context) {
    const auto holding = holdingOptions(options, context);
    if (!holding) return holding.errors();
    std::vector<std::string> words;
    pipeline::Errors errors;
    for (const std::size_t i : *holding)
        words.push_back(fmt::format("{}: {}", char('A' + i), filled(options[i].text, context, errors)));
    if (!errors.empty()) return errors;
    return fmt::format("{}", fmt::join(words, "; "));
}

// Whether something that can be picked is meant.
using Meant = std::function<Result<bool>(const Pick&)>;

// A pixel that is meant, and around which all are, so that a finger hits it: on a coarse grid, then on finer ones. The
// last takes any pixel. Nothing where none is meant.
Result<std::optional<glm::ivec2>> exampleOf(const Meant& isMeant, glm::ivec2 size) {
    for (const auto& [step, around] : {std::pair{24, 6}, std::pair{8, 3}, std::pair{3, 1}, std::pair{1, 0}})
        for (int y = around; y < size.y - around; y += step)
            for (int x = around; x < size.x - around; x += step) {
                bool all = true;
                for (const glm::ivec2 beside : {glm::ivec2(0), {around, 0}, {-around, 0}, {0, around}, {0, -around}}) {
                    Pick pick;
                    pick.x = x + beside.x, pick.y = y + beside.y;
                    const auto meant = isMeant(pick);
                    if (!meant) return meant.errors();
                    if (!*meant) {
                        all = false;
                        break;
                    }
                }
                if (all) return std::optional(glm::ivec2(x, y));
            }
    return std::optional<glm::ivec2>();
}

// What `condition` holds for and none of `others`: "for example x 226, y 280", or "vertex 1 and 3".
Result<std::string> pickText(const ClickQuestion& click, const Expression& condition,
                             const std::vector<const Expression*>& others, Context context) {
    KeptValues kept;
    context.kept = &kept;
    const Meant isMeant = [&](const Pick& pick) -> Result<bool> {
        context.pick = &pick;
        const auto holds = evaluate(condition, context);
        if (!holds) return holds.errors();
        if (holds->numbers[0] != 1) return false;
        for (const Expression* other : others) {
            const auto is = evaluate(*other, context);
            if (!is) return is.errors();
            if (is->numbers[0] == 1) return false;
        }
        return true;
    };
    const pipeline::Scene& scene = context.frame.scene();
    if (click.kind == ThingKind::Pixel) {
        const auto example = exampleOf(isMeant, {scene.settings.width, scene.settings.height});
        if (!example) return example.errors();
        if (!*example) return std::string("nowhere in this picture");
        return fmt::format("for example x {}, y {}", (*example)->x, (*example)->y);
    }
    std::vector<std::string> words;
    for (std::size_t i = 0; i < countOf(click.kind, scene); ++i) {
        const auto meant = isMeant(pickOf({click.kind, i}));
        if (!meant) return meant.errors();
        if (!*meant) continue;
        if (words.size() == kMostNamed) {
            words.emplace_back("more");
            break;
        }
        words.push_back(std::to_string(i));
    }
    return fmt::format("{} {}", name(click.kind), listed(words));
}

Result<std::string> textOf(const ClickQuestion& click, const Context& context) {
    if (!click.near) return pickText(click, click.holds, {}, context);
    const auto place = evaluate(*click.near, context);
    if (!place) return place.errors();
    return fmt::format("x {}, y {}, within {} px", toText({{place->numbers[0]}, {}}, 0),
                       toText({{place->numbers[1]}, {}}, 0), pipeline::shortestText(click.within));
}

Result<std::string> textOf(const OrderQuestion& order, const Context& context) {
    const auto right = rightOrder(order, context);
    if (!right) return right.errors();
    std::vector<std::string> letters, words;
    pipeline::Errors errors;
    for (const std::size_t i : *right) {
        letters.emplace_back(1, char('A' + i));
        words.push_back(filled(order.items[i].text, context, errors));
    }
    if (!errors.empty()) return errors;
    return fmt::format("{}: {}", fmt::join(letters, ", "), fmt::join(words, "; "));
}

Result<std::string> textOf(const UntilQuestion& until, const Context& context) {
    std::vector<std::string> words;
    for (const UntilQuestion::Setting& setting : until.answer) {
        std::string value = setting.word;
        if (setting.number) {
            const auto number = evaluate(*setting.number, context);
            if (!number) return number.errors();
            value = toText(*number);
        }
        words.push_back(fmt::format("`{}` = {}", setting.key, value));
    }
    return listed(words);
}

Result<std::string> textOf(const WriteQuestion& write, const Context&) { return "```\n" + write.answer + "\n```"; }

// The first result of a scene that a mistake makes wrong.
std::string firstWrong(const WriteQuestion& write, std::string_view id, const pipeline::Scene& scene) {
    const pipeline::OwnContract& contract = write.contract;
    const auto own = ownFrame(pipeline::ownScene(scene), contract.id, std::make_shared<pipeline::OwnRecord>(), {});
    const auto known = std::ranges::find(contract.mistakes, id, &pipeline::OwnMistake::id);
    for (std::size_t i = 0; known != contract.mistakes.end() && i < own.unknown.size(); ++i) {
        const auto mine = valueOf(contract, known->formula, own.unknown[i].in);
        if (differenceOf(contract, mine, own.unknown[i].right) > contract.tolerance)
            return fmt::format("{}: {} instead of {}",
                               placeText(own.unknown[i], i, pipeline::ownScene(scene).settings.width),
                               resultText(contract, mine), resultText(contract, own.unknown[i].right));
    }
    return "in another scene";
}

}  // namespace

Pick pickOf(const Thing& thing) {
    Pick pick;
    const auto index = double(thing.index);
    if (thing.kind == ThingKind::Polygon) pick.polygon = index;
    if (thing.kind == ThingKind::Vertex) pick.vertex = index;
    if (thing.kind == ThingKind::Object) pick.object = index;
    if (thing.kind == ThingKind::Light) pick.light = index;
    return pick;
}

Result<std::string> mistakeText(const Question& question, std::size_t mistake, const Context& context) {
    if (std::holds_alternative<UntilQuestion>(question.kind)) return std::string("other values");
    if (const auto* const write = std::get_if<WriteQuestion>(&question.kind))
        return firstWrong(*write, write->mistakes[mistake].id, context.frame.scene());
    const auto* const click = std::get_if<ClickQuestion>(&question.kind);
    if (!click) {
        const auto value = evaluate(mistakesOf(question)[mistake].value, context);
        if (!value) return value.errors();
        return toText(*value);
    }
    std::vector<const Expression*> before{&click->holds};
    for (std::size_t i = 0; i < mistake; ++i) before.push_back(&click->mistakes[i].value);
    return pickText(*click, click->mistakes[mistake].value, before, context);
}

Result<std::string> answerText(const Question& question, const Context& context) {
    return std::visit(
        [&](const auto& kind) -> Result<std::string> {
            if constexpr (requires { kind.options; })
                return textOf(std::span<const Option>(kind.options), context);
            else
                return textOf(kind, context);
        },
        question.kind);
}

}  // namespace lessons
