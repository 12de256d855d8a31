#include "lessons/questions/attempt.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "lessons/lesson_text.h"
#include "lessons/questions/typed_number.h"

namespace lessons {

namespace {

constexpr std::size_t kMostTries = 3;
constexpr double kPrice = 0.25, kLeast = 0.25;  // of the full points: of a wrong try or a hint; of a late right answer
constexpr std::size_t kMostGiven = 200;         // characters of an answer that are remembered
constexpr std::size_t kMostWritten = 10'000;

// Each step of a slider, and each run of lines, is a try.
bool isTrying(const Question& question) {
    return std::holds_alternative<UntilQuestion>(question.kind) || std::holds_alternative<WriteQuestion>(question.kind);
}

// Numbers by their value: 3/2 is 1.5.
bool wasTried(const Question& question, const std::vector<Try>& tries, const std::string& given) {
    if (isTrying(question)) return false;
    const auto* number = std::get_if<NumberQuestion>(&question.kind);
    const auto valueOf = [&](const std::string& text) {
        const auto typed = number ? typedNumber(text, number->unit) : pipeline::Error{};
        return typed ? std::optional(typed->value) : std::nullopt;
    };
    const auto value = valueOf(given);
    return std::ranges::any_of(
        tries, [&](const Try& one) { return one.given == given || (value && valueOf(one.given) == value); });
}

std::string optionName(std::size_t option) { return std::string(1, char('A' + option)); }

}  // namespace

std::string textOf(const Question& question, const Given& given) {
    if (const auto* typed = std::get_if<Typed>(&given)) return typed->text.substr(0, kMostGiven);
    if (const auto* chosen = std::get_if<Chosen>(&given)) {
        std::vector<std::string> names;
        for (const std::size_t option : chosen->options) names.push_back(optionName(option));
        std::ranges::sort(names);
        return fmt::format("{}", fmt::join(names, ", "));
    }
    if (const auto* ordered = std::get_if<Ordered>(&given)) {
        std::vector<std::string> names;
        for (const std::size_t item : ordered->items) names.push_back(optionName(item));
        return fmt::format("{}", fmt::join(names, ", "));
    }
    if (const auto* written = std::get_if<Written>(&given)) return written->text.substr(0, kMostWritten);
    const auto* pick = std::get_if<Pick>(&given);
    const auto* click = std::get_if<ClickQuestion>(&question.kind);
    if (!pick || !click) return "reached";
    if (click->kind == ThingKind::Pixel)
        return fmt::format("{:.0f}, {:.0f}", pick->x.value_or(-1), pick->y.value_or(-1));
    for (const PickField& field : pickFields())
        if (field.name == name(click->kind))
            return fmt::format("{} {:.0f}", field.name, (pick->*field.value).value_or(-1));
    return {};
}

Attempt::Attempt(const Question& question, Progress progress) : m_question(&question), m_progress(std::move(progress)) {
    m_progress.hints = std::min(m_progress.hints, question.hints.size());  // the lesson may have changed since
}

Attempt::State Attempt::state() const {
    if (m_progress.outcome == Progress::Outcome::Right) return State::Right;
    if (m_progress.outcome == Progress::Outcome::Shown) return State::Shown;
    if (m_progress.tries.empty()) return State::Open;
    return m_progress.tries.back().mistake.empty() ? State::WrongUnknown : State::WrongKnown;
}

pipeline::Result<Verdict> Attempt::check(const Given& given, const Context& context, double seconds) {
    assert(!isSettled());
    auto judged = judge(*m_question, given, context, m_progress.hints > 0);
    if (!judged || judged->mark == Mark::Again) return judged;
    Verdict verdict = std::move(judged).value();
    const bool right = verdict.mark == Mark::Right;
    std::string text = textOf(*m_question, given);
    if (!right && wasTried(*m_question, m_progress.tries, text))
        return Verdict{Mark::Again, {}, {}, "You tried this answer already. It costs nothing.\n\n" + verdict.said};
    if (!right && isFree()) verdict.said += "\n\nA wrong prediction costs nothing.";
    if (std::holds_alternative<Written>(given))  // the last text is enough
        for (Try& one : m_progress.tries) one.given.clear();
    m_progress.tries.push_back({std::move(text), right, verdict.mistake, m_progress.hints, seconds});
    if (right)
        m_progress.outcome = Progress::Outcome::Right;
    else if (triesLeft() == 0)
        m_progress.outcome = Progress::Outcome::Shown;
    return verdict;
}

pipeline::Result<std::string> Attempt::nextHint(const Context& context) {
    assert(!isSettled() && hintsSeen() < hintCount());
    auto text = filled(m_question->hints[m_progress.hints], context);
    if (text) ++m_progress.hints;
    return text;
}

pipeline::Result<std::string> Attempt::hint(std::size_t number, const Context& context) const {
    assert(number < hintsSeen());
    return filled(m_question->hints[number], context);
}

void Attempt::showMe() {
    assert(!isSettled());
    m_progress.outcome = Progress::Outcome::Shown;
}

pipeline::Result<Attempt::Solution> Attempt::solution(const Context& context) const {
    assert(isSettled());
    const auto answer = answerText(*m_question, context);
    if (!answer) return answer.errors();
    const auto works = filled(m_question->works, context);
    if (!works) return works.errors();
    Solution solution{*answer, {}};
    for (const Line& line : linesOf(*works, {}))
        if (!isBlank(line)) solution.steps.emplace_back(line.text);
    return solution;
}

double Attempt::points() const { return m_progress.outcome == Progress::Outcome::Right ? worth() : 0; }

double Attempt::worth() const {
    if (m_progress.outcome == Progress::Outcome::Shown) return 0;
    const double paid = kPrice * double(wrongTries() + m_progress.hints);
    return m_question->points * std::max(kLeast, 1 - paid);
}

std::size_t Attempt::wrongTries() const {
    if (isTrying(*m_question)) return 0;
    const auto wrong = std::size_t(std::ranges::count(m_progress.tries, false, &Try::right));
    return wrong - (m_question->isPrediction && wrong > 0);
}

std::optional<std::size_t> Attempt::triesLeft() const {
    if (isTrying(*m_question)) return {};
    std::size_t most = kMostTries;
    // The last option that is left over needs no try.
    if (const auto* choice = std::get_if<ChoiceQuestion>(&m_question->kind))
        most = std::min(most, choice->options.size() - 1);
    return most - std::min(most, wrongTries());
}

bool Attempt::isOff(std::size_t option) const {
    return std::holds_alternative<ChoiceQuestion>(m_question->kind) &&
           std::ranges::any_of(m_progress.tries,
                               [&](const Try& one) { return !one.right && one.given == optionName(option); });
}

}  // namespace lessons
