#include <fmt/format.h>

#include "lessons/judge.h"
#include "lessons/lesson_text.h"
#include "pipeline/core/text.h"

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

Result<bool> holdsAt(const Expression& condition, Context context, glm::ivec2 pixel) {
    Pick pick;
    pick.x = pixel.x, pick.y = pixel.y;
    context.pick = &pick;
    const auto holds = evaluate(condition, context);
    if (!holds) return holds.errors();
    return holds->numbers[0] == 1;
}

// A pixel at which a condition holds, and around which it does, so that a finger hits it: on a coarse grid, then on
// finer ones. Nothing where there is none so large.
Result<std::optional<glm::ivec2>> exampleOf(const Expression& condition, Context context) {
    KeptValues kept;
    context.kept = &kept;
    const glm::ivec2 size(context.frame.scene().settings.width, context.frame.scene().settings.height);
    for (const auto& [step, around] : {std::pair{24, 6}, std::pair{8, 3}, std::pair{3, 1}})
        for (int y = step; y < size.y - step; y += step)
            for (int x = step; x < size.x - step; x += step) {
                bool all = true;
                for (const glm::ivec2 beside : {glm::ivec2(0), {around, 0}, {-around, 0}, {0, around}, {0, -around}}) {
                    const auto holds = holdsAt(condition, context, glm::ivec2(x, y) + beside);
                    if (!holds) return holds.errors();
                    if (!*holds) {
                        all = false;
                        break;
                    }
                }
                if (all) return std::optional(glm::ivec2(x, y));
            }
    return std::optional<glm::ivec2>();
}

Result<std::string> textOf(const ClickQuestion& click, Context context) {
    if (click.near) {
        const auto place = evaluate(*click.near, context);
        if (!place) return place.errors();
        return fmt::format("x {}, y {}, within {} px", toText({{place->numbers[0]}, {}}, 0),
                           toText({{place->numbers[1]}, {}}, 0), pipeline::shortestText(click.within));
    }
    if (click.kind == ThingKind::Pixel) {
        const auto example = exampleOf(click.holds, context);
        if (!example) return example.errors();
        if (!*example) return fmt::format("a pixel with `{}`", click.holds.text);
        return fmt::format("for example x {}, y {}", (*example)->x, (*example)->y);
    }
    std::vector<std::string> words;
    for (std::size_t i = 0; i < countOf(click.kind, context.frame.scene()); ++i) {
        const Pick pick = pickOf({click.kind, i});
        context.pick = &pick;
        const auto holds = evaluate(click.holds, context);
        if (!holds) return holds.errors();
        if (holds->numbers[0] != 1) continue;
        if (words.size() == kMostNamed) {
            words.emplace_back("more");
            break;
        }
        words.push_back(std::to_string(i));
    }
    return fmt::format("{} {}", name(click.kind), listed(words));
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
