#include "lessons/questions/judge.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "lessons/lesson_text.h"
#include "lessons/questions/known_mistakes.h"
#include "lessons/questions/misconceptions.h"
#include "pipeline/core/text.h"

namespace lessons {

namespace {

using pipeline::Errors;
using pipeline::Result;
using Kind = Node::Kind;

constexpr double kNearClick = 4;  // times the distance that is right

template <class... Ts>
struct Overloaded : Ts... {
    using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

Result<double> numberOf(const Expression& expression, const Context& context) {
    const auto value = evaluate(expression, context);
    if (!value) return value.errors();
    return value->numbers.front();
}

// The text filled in, in its own paragraph behind what is there.
void append(std::string& text, std::string_view more) {
    if (!text.empty() && !more.empty()) text += "\n\n";
    text += more;
}

// What is said about an answer, from the frame that it was judged by.
class Judge {
public:
    Judge(const Question& question, const Context& context, bool hinted)
        : m_question(question), m_context(context), m_hinted(hinted) {}

    Result<Verdict> judge(const Given& given) {
        const auto verdict = std::visit(
            Overloaded{[&](const NumberQuestion& number) { return typed(number, std::get_if<Typed>(&given)); },
                       [&](const ChoiceQuestion& choice) { return chosen(choice, std::get_if<Chosen>(&given)); },
                       [&](const SeveralQuestion& several) { return chosen(several, std::get_if<Chosen>(&given)); },
                       [&](const ClickQuestion& click) { return picked(click, std::get_if<Pick>(&given)); },
                       [&](const UntilQuestion& until) { return reached(until); },
                       [&](const OrderQuestion& order) { return ordered(order, std::get_if<Ordered>(&given)); },
                       [&](const WriteQuestion& write) { return written(write, std::get_if<Written>(&given)); }},
            m_question.kind);
        if (!m_errors.empty()) return m_errors;
        return verdict;
    }

private:
    std::string said(const Prose& prose) {
        auto text = filled(prose, m_context);
        if (text) return std::move(text).value();
        m_errors.insert(m_errors.end(), text.errors().begin(), text.errors().end());
        return {};
    }
    double number(const Expression& expression) {
        const auto value = numberOf(expression, m_context);
        if (value) return *value;
        m_errors.insert(m_errors.end(), value.errors().begin(), value.errors().end());
        return NAN;
    }
    bool holds(const Expression& expression) { return number(expression) == 1; }

    Verdict again(std::string text) { return {Mark::Again, {}, {}, std::move(text)}; }
    Verdict right(std::string text = {}) {
        append(text, said(m_question.right));
        return {Mark::Right, {}, {}, text.empty() ? "Right." : text};
    }
    Verdict wrong(std::string text, std::string_view mistake = {}) {
        if (!mistake.empty()) {
            const Misconception* row = findMisconception(mistake);
            return {Mark::Known, std::string(mistake), row ? row->name : std::string(), text};
        }
        append(text, said(m_question.wrong));
        return {Mark::NotYet, {}, {}, text.empty() ? "Not yet." : text};
    }

    Verdict typed(const NumberQuestion& question, const Typed* given) {
        const auto typed = typedNumber(given ? given->text : "", question.unit);
        if (!typed)
            return again(fmt::format("{}. Type {}.", typed.errors().front().found, typed.errors().front().expected));
        const double answer = number(question.answer), tolerance = toleranceOf(question, answer);
        if (std::abs(typed->value - answer) <= tolerance) return right(otherForm(given->text, *typed));
        // Of several mistakes that are near, the nearest.
        const Mistake* meant = nullptr;
        double least = INFINITY;
        for (const Mistake& mistake : question.mistakes) {
            const double value = number(mistake.value), off = std::abs(typed->value - value);
            if (off < least && isMeant(*typed, value, toleranceOf(question, value))) least = off, meant = &mistake;
        }
        if (meant) return wrong(said(meant->said), meant->id);
        if (hasTooFewDigits(*typed, answer)) return again("Right so far. Give more digits.");
        if (const auto known = knownMistake(*typed, answer, tolerance, question.unit))
            return wrong(known->said, known->id);
        if (typed->value * answer < 0) return wrong("Not yet: the sign is the other one, and the size differs.");
        return wrong(typed->value > answer ? "Not yet: too large." : "Not yet: too small.");
    }
    // What a number in another form is as a decimal.
    static std::string otherForm(std::string_view text, const TypedNumber& typed) {
        if (typed.form == TypedNumber::Form::Decimal) return {};
        const std::string decimal = toText({{typed.value}, {}});
        return fmt::format("Right: {} is {}{}.", pipeline::inQuotes(text),
                           numberIn(decimal) == typed.value ? "" : "about ", decimal);
    }

    Verdict chosen(const ChoiceQuestion& question, const Chosen* given) {
        if (!given || given->options.size() != 1 || given->options[0] >= question.options.size())
            return again("Choose one option.");
        const Option& option = question.options[given->options[0]];
        if (holds(option.holds)) return right(said(option.said));
        if (question.ofStages) return wrong(stageText(question, given->options[0], said(option.said)), option.mistake);
        return wrong(said(option.said), option.mistake);
    }
    // What is wrong with a stage that is not the first to differ.
    std::string stageText(const ChoiceQuestion& question, std::size_t chosen, std::string own) {
        std::size_t first = 0;
        while (first < question.options.size() && !holds(question.options[first].holds)) ++first;
        const std::string name = said(question.options[chosen].text);
        std::string text = chosen < first ? fmt::format("Not yet: nothing that {} leaves differs.", name)
                                          : fmt::format("Not yet: what {} gets differs already.", name);
        append(text, own);
        return text;
    }

    Verdict ordered(const OrderQuestion& question, const Ordered* given) {
        if (!given || !isOrderOf(given->items, question.items.size())) return again("Put all of them in order.");
        const auto answer = rightOrder(question, m_context);
        if (!answer) {
            m_errors.insert(m_errors.end(), answer.errors().begin(), answer.errors().end());
            return {};
        }
        if (given->items == *answer) return right();
        const std::vector<std::size_t> opposite(answer->rbegin(), answer->rend());
        for (const OrderQuestion::Wrong& known : question.mistakes)
            if (given->items == (known.order.empty() ? opposite : known.order))
                return wrong(said(known.mistake.said), known.mistake.id);
        std::size_t at = 0;  // of the first two neighbours that stand the wrong way round
        const auto place = [&](std::size_t i) { return std::ranges::find(*answer, given->items[i]) - answer->begin(); };
        while (place(at) < place(at + 1)) ++at;
        const OrderItem &before = question.items[given->items[at]], &after = question.items[given->items[at + 1]];
        return wrong(fmt::format("Not yet: {} stands before {}.", withKey(before), withKey(after)));
    }
    // The item, and the number that it is ordered by where the scene gives that.
    std::string withKey(const OrderItem& item) {
        const std::string text = said(item.text);
        if (item.stage || item.key.root.kind == Kind::Number) return text;
        return fmt::format("{} ({})", text, toText({{number(item.key)}, {}}));
    }

    Verdict chosen(const SeveralQuestion& question, const Chosen* given) {
        if (!given || given->options.empty()) return again("Choose at least one option.");
        std::size_t found = 0, missing = 0, wrongly = 0;
        const Option* named = nullptr;  // the first that does not hold
        for (std::size_t i = 0; i < question.options.size(); ++i) {
            const bool isChosen = std::ranges::find(given->options, i) != given->options.end();
            const bool isRight = holds(question.options[i].holds);
            found += isChosen && isRight;
            missing += !isChosen && isRight;
            wrongly += isChosen && !isRight;
            if (isChosen && !isRight && (!named || named->mistake.empty())) named = &question.options[i];
        }
        if (missing == 0 && wrongly == 0) return right();
        if (found == 0 && found + missing + wrongly == question.options.size() && question.opposite)
            return wrong(said(question.opposite->said), question.opposite->id);
        std::string text =
            fmt::format("{} of {} {} right.", found, given->options.size(), given->options.size() == 1 ? "is" : "are");
        if (missing > 0) text += fmt::format(" {} {} missing.", missing, missing == 1 ? "is" : "are");
        if (named) append(text, said(named->said));
        return wrong(text, named ? named->mistake : std::string());
    }

    Verdict picked(const ClickQuestion& question, const Pick* given) {
        const Pick none;
        const Pick& pick = given ? *given : none;
        if (!isThere(question.kind, pick)) return again(fmt::format("Click a {} first.", name(question.kind)));
        m_context.pick = &pick;
        if (holds(question.holds)) return right();
        if (const Mistake* mistake = heldOf(question.mistakes)) return wrong(said(mistake->said), mistake->id);
        return wrong(question.near ? distanceText(question, pick) : std::string());
    }
    const Mistake* heldOf(std::span<const Mistake> mistakes) {
        const auto found = std::ranges::find_if(mistakes, [&](const Mistake& one) { return holds(one.value); });
        return found == mistakes.end() ? nullptr : &*found;
    }
    static bool isThere(ThingKind kind, const Pick& pick) {
        switch (kind) {
            case ThingKind::Pixel: return pick.x && pick.y;
            case ThingKind::Polygon: return pick.polygon.has_value();
            case ThingKind::Vertex: return pick.vertex.has_value();
            case ThingKind::Object: return pick.object.has_value();
            case ThingKind::Light: return pick.light.has_value();
        }
        return false;
    }
    // Near or far; the direction as well once a hint was seen: else a few clicks would find any place. Rows run down.
    std::string distanceText(const ClickQuestion& question, const Pick& pick) {
        const auto place = evaluate(*question.near, m_context);
        if (!place) {
            m_errors.insert(m_errors.end(), place.errors().begin(), place.errors().end());
            return {};
        }
        const glm::dvec2 off{place->numbers[0] - *pick.x, place->numbers[1] - *pick.y};
        const bool isNear = glm::length(off) <= kNearClick * question.within;
        std::string text = isNear ? "Not yet, but you are near." : "Not yet: it is far from here.";
        if (!m_hinted) return text;
        std::vector<std::string> ways;
        if (std::abs(off.x) > question.within / 2) ways.push_back(off.x > 0 ? "right" : "left");
        if (std::abs(off.y) > question.within / 2) ways.push_back(off.y > 0 ? "down" : "up");
        return text + fmt::format(" Go {}.", listed(ways));
    }

    Verdict reached(const UntilQuestion& question) {
        if (holds(question.holds)) return right();
        if (const Mistake* mistake = heldOf(question.mistakes)) return wrong(said(mistake->said), mistake->id);
        const auto gauge = gaugeOf(question, m_context);
        return wrong(gauge && *gauge ? fmt::format("Not yet: {}.", (*gauge)->said) : std::string());
    }

    Verdict written(const WriteQuestion& question, const Written* given) {
        if (!given || given->verdict.all == 0) return again("Run your lines first.");
        const pipeline::OwnVerdict& found = given->verdict;
        if (found.isRight()) return right(fmt::format("All results of {} agree.", question.contract.name));
        std::string text = fmt::format("{} of {} results differ.", found.wrong, found.all);
        if (!given->trial.empty()) text = fmt::format("Right on this page, but not in {}: {}", given->trial, text);
        if (found.names.size() != 1) {
            std::vector<std::string> names;
            for (const pipeline::OwnMistake* one : found.names) names.emplace_back(one->name);
            if (!names.empty()) append(text, "One of these explains them: " + listed(names) + ".");
            return wrong(text);
        }
        const pipeline::OwnMistake& known = *found.names[0];
        for (const Mistake& one : question.mistakes)
            if (one.id == known.id) append(text, said(one.said));
        return {Mark::Known, std::string(known.id), std::string(known.name), text};
    }

    const Question& m_question;
    Context m_context;
    bool m_hinted;
    Errors m_errors;
};

}  // namespace

double toleranceOf(const NumberQuestion& number, double answer) {
    return number.relative ? number.tolerance * std::abs(answer) : number.tolerance;
}

Result<Verdict> judge(const Question& question, const Given& given, const Context& context, bool hinted) {
    return Judge(question, context, hinted).judge(given);
}

Result<std::vector<std::size_t>> holdingOptions(std::span<const Option> options, const Context& context) {
    std::vector<std::size_t> holding;
    for (std::size_t i = 0; i < options.size(); ++i) {
        const auto holds = numberOf(options[i].holds, context);
        if (!holds) return holds.errors();
        if (*holds == 1) holding.push_back(i);
    }
    return holding;
}

Result<std::vector<std::size_t>> rightOrder(const OrderQuestion& order, const Context& context) {
    std::vector<std::pair<double, std::size_t>> keys;
    for (std::size_t i = 0; i < order.items.size(); ++i) {
        const auto key = numberOf(order.items[i].key, context);
        if (!key) return key.errors();
        keys.emplace_back(*key, i);
    }
    std::ranges::sort(keys);
    std::vector<std::size_t> sorted;
    for (const auto& [key, item] : keys) {
        if (!sorted.empty() && keys[sorted.size() - 1].first == key)
            return pipeline::Error{order.items[item].where, "two items have the same place", "keys that are apart"};
        sorted.push_back(item);
    }
    return sorted;
}

double shareInOrder(std::span<const std::size_t> right, std::span<const std::size_t> given) {
    const auto place = [&](std::size_t item) { return std::ranges::find(right, item) - right.begin(); };
    int apart = 0, pairs = 0;
    for (std::size_t i = 0; i < given.size(); ++i)
        for (std::size_t k = i + 1; k < given.size(); ++k, ++pairs) apart += place(given[i]) < place(given[k]) ? 1 : -1;
    return pairs == 0 ? 0 : std::max(0.0, double(apart) / pairs);
}

Result<std::optional<Gauge>> gaugeOf(const UntilQuestion& until, const Context& context) {
    const Node& root = until.holds.root;
    const bool compares = root.kind == Kind::Less || root.kind == Kind::LessEqual || root.kind == Kind::Greater ||
                          root.kind == Kind::GreaterEqual;
    if (!compares || root.operands[0].size != 1 || root.operands[1].size != 1) return std::optional<Gauge>();
    const auto side = [&](std::size_t i) { return numberOf(Expression{{}, root.operands[i], {}, 0}, context); };
    const auto value = side(0), needed = side(1), holds = numberOf(until.holds, context);
    for (const auto* part : {&value, &needed, &holds})
        if (!*part) return part->errors();
    Gauge gauge{*value, *needed, {}, *holds == 1, {}};
    gauge.comparison = root.kind == Kind::Less        ? "<"
                       : root.kind == Kind::LessEqual ? "≤"
                       : root.kind == Kind::Greater   ? ">"
                                                      : "≥";
    gauge.said = fmt::format("{}, needed {} {}", toText({{*value}, {}}), gauge.comparison, toText({{*needed}, {}}));
    return std::optional(gauge);
}

}  // namespace lessons
