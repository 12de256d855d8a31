#include "lessons/questions/question.h"

#include <algorithm>
#include <array>

namespace lessons {

std::string_view name(ThingKind kind) {
    static constexpr std::array<std::string_view, 5> kNames{"pixel", "polygon", "vertex", "object", "light"};
    return kNames[std::size_t(kind)];
}

std::optional<ThingKind> thingNamed(std::string_view word) {
    for (int i = 0; i <= int(ThingKind::Light); ++i)
        if (name(ThingKind(i)) == word) return ThingKind(i);
    return {};
}

std::size_t countOf(ThingKind kind, const pipeline::Scene& scene) {
    std::size_t count = kind == ThingKind::Object ? scene.objects.size() : 0;
    if (kind == ThingKind::Light) count = scene.lights.size();
    for (const pipeline::Object& object : scene.objects) {
        if (kind == ThingKind::Vertex) count += object.mesh->positions.size();
        if (kind == ThingKind::Polygon) count += object.mesh->polygonCount();
    }
    return count;
}

std::string_view kindName(const Question& question) {
    static constexpr std::array<std::string_view, 7> kNames{"number", "choice", "several", "click",
                                                            "until",  "order",  "write"};
    static_assert(kNames.size() == std::variant_size_v<decltype(question.kind)>);
    return kNames[question.kind.index()];
}

std::span<const Option> optionsOf(const Question& question) {
    if (const auto* choice = std::get_if<ChoiceQuestion>(&question.kind)) return choice->options;
    if (const auto* several = std::get_if<SeveralQuestion>(&question.kind)) return several->options;
    return {};
}

std::vector<const Prose*> rowsOf(const Question& question) {
    std::vector<const Prose*> rows;
    for (const Option& option : optionsOf(question)) rows.push_back(&option.text);
    if (const auto* order = std::get_if<OrderQuestion>(&question.kind))
        for (const OrderItem& item : order->items) rows.push_back(&item.text);
    return rows;
}

std::span<const Mistake> mistakesOf(const Question& question) {
    if (const auto* number = std::get_if<NumberQuestion>(&question.kind)) return number->mistakes;
    if (const auto* click = std::get_if<ClickQuestion>(&question.kind)) return click->mistakes;
    if (const auto* until = std::get_if<UntilQuestion>(&question.kind)) return until->mistakes;
    if (const auto* write = std::get_if<WriteQuestion>(&question.kind)) return write->mistakes;
    return {};
}

std::set<std::string> mistakeIds(const Question& question) {
    std::set<std::string> ids;
    for (const Mistake& mistake : mistakesOf(question)) ids.insert(mistake.id);
    for (const Option& option : optionsOf(question)) ids.insert(option.mistake);
    if (const auto* several = std::get_if<SeveralQuestion>(&question.kind); several && several->opposite)
        ids.insert(several->opposite->id);
    if (const auto* order = std::get_if<OrderQuestion>(&question.kind))
        for (const OrderQuestion::Wrong& wrong : order->mistakes) ids.insert(wrong.mistake.id);
    ids.erase("");
    return ids;
}

bool isOrderOf(std::vector<std::size_t> order, std::size_t count) {
    std::ranges::sort(order);
    for (std::size_t i = 0; i < order.size(); ++i)
        if (order[i] != i) return false;
    return order.size() == count;
}

std::vector<const Prose*> textsOf(const Question& question) {
    std::vector<const Prose*> texts{&question.text, &question.paper, &question.works, &question.right, &question.wrong};
    for (const Prose& hint : question.hints) texts.push_back(&hint);
    for (const Mistake& mistake : mistakesOf(question)) texts.push_back(&mistake.said);
    for (const Option& option : optionsOf(question)) {
        texts.push_back(&option.text);
        texts.push_back(&option.said);
    }
    if (const auto* several = std::get_if<SeveralQuestion>(&question.kind); several && several->opposite)
        texts.push_back(&several->opposite->said);
    if (const auto* order = std::get_if<OrderQuestion>(&question.kind)) {
        for (const OrderItem& item : order->items) texts.push_back(&item.text);
        for (const OrderQuestion::Wrong& wrong : order->mistakes) texts.push_back(&wrong.mistake.said);
    }
    return texts;
}

namespace {

using Expressions = std::vector<const Expression*>;
// One for each kind, so that the compiler asks for that of a new one.
Expressions answersIn(std::span<const Option> options) {
    Expressions all;
    for (const Option& option : options) all.push_back(&option.holds);
    return all;
}
Expressions answersIn(const NumberQuestion& number) { return {&number.answer}; }
Expressions answersIn(const ChoiceQuestion& choice) { return answersIn(std::span<const Option>(choice.options)); }
Expressions answersIn(const SeveralQuestion& several) { return answersIn(std::span<const Option>(several.options)); }
Expressions answersIn(const ClickQuestion& click) { return {&click.holds}; }
Expressions answersIn(const UntilQuestion&) { return {}; }
Expressions answersIn(const WriteQuestion&) { return {}; }
Expressions answersIn(const OrderQuestion& order) {
    Expressions all;
    for (const OrderItem& item : order.items) all.push_back(&item.key);
    return all;
}

}  // namespace

std::vector<const Expression*> answersOf(const Question& question) {
    return std::visit([](const auto& kind) { return answersIn(kind); }, question.kind);
}

std::vector<const Expression*> expressionsOf(const Question& question) {
    std::vector<const Expression*> all = answersOf(question);
    if (const auto* click = std::get_if<ClickQuestion>(&question.kind); click && click->near)
        all.push_back(&*click->near);
    if (const auto* until = std::get_if<UntilQuestion>(&question.kind)) {
        all.push_back(&until->holds);
        for (const UntilQuestion::Setting& setting : until->answer)
            if (setting.number) all.push_back(&*setting.number);
    }
    if (!std::holds_alternative<WriteQuestion>(question.kind))
        for (const Mistake& mistake : mistakesOf(question)) all.push_back(&mistake.value);
    return all;
}

}  // namespace lessons
