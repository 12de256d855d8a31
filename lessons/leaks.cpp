#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "lessons/check.h"
#include "lessons/expression/function_table.h"
#include "lessons/questions/hidden.h"
#include "lessons/questions/judge.h"

// Whether the first half of a page gives its answer away.

namespace lessons {

namespace {

using pipeline::Errors;
using pipeline::SourceLocation;

constexpr int kLeastDigits = 3;
constexpr std::string_view kGroup = "\u202f";

// The numbers in a text with three digits and more, without their signs.
std::vector<double> numbersIn(std::string text) {
    for (std::size_t at; (at = text.find(kGroup)) != std::string::npos;) text.erase(at, kGroup.size());
    const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    std::vector<double> numbers;
    for (std::size_t at = 0; at < text.size();) {
        if (!isDigit(text[at])) {
            ++at;
            continue;
        }
        std::size_t end = at;
        while (end < text.size() &&
               (isDigit(text[end]) || (text[end] == '.' && end + 1 < text.size() && isDigit(text[end + 1]))))
            ++end;
        const std::string digits = text.substr(at, end - at);
        const std::size_t first = std::min(digits.find_first_not_of("0."), digits.size());
        if (std::ranges::count_if(digits.begin() + std::ptrdiff_t(first), digits.end(), isDigit) >= kLeastDigits)
            if (const auto number = numberIn(digits)) numbers.push_back(*number);
        at = end;
    }
    return numbers;
}

// Looks for one number.
class Search {
public:
    Search(const Context& context, double answer, double tolerance)
        : m_context(context), m_answer(std::abs(answer)), m_tolerance(tolerance) {}

    bool isAnswer(double number) const {
        return std::abs(std::abs(number) - m_answer) <= m_tolerance + 1e-12 * m_answer;
    }
    void look(const Prose& prose, const SourceLocation& where, const char* what) {
        for (const std::string& piece : prose.pieces) lookIn(piece, where, what);
        for (const Prose::Hole& hole : prose.holes)
            if (const auto value = evaluate(hole.expression, m_context))
                lookIn(toText(*value, hole.digits), hole.expression.root.where, what);
    }
    void look(const pipeline::AnyBuffer& buffer, const SourceLocation& where) {
        if (buffer.info->domain == pipeline::Domain::Pixel || buffer.info->domain == pipeline::Domain::Texel) return;
        for (std::size_t i = 0; i < buffer.count(); ++i)
            if (isAnswer(buffer.flat(i))) return tell(where, fmt::format("the table of {}", buffer.name.text()));
    }
    // What the answer is read from, if that is the answer itself.
    void lookAtReads(const Node& node, std::span<const pipeline::BufferName> shown, const SourceLocation& where) {
        if (node.kind == Node::Kind::Call && node.function->takes == Takes::Element && node.buffer &&
            std::ranges::find(shown, *node.buffer) != shown.end())
            if (const auto value = evaluate(Expression{{}, node, {}, 0}, m_context);
                value && std::ranges::any_of(value->numbers, [&](double v) { return isAnswer(v); }))
                tell(where, fmt::format("the view of {}", node.buffer->text()));
        if (node.changes.empty())
            for (const Node& operand : node.operands) lookAtReads(operand, shown, where);
    }
    void lookIn(const std::string& text, const SourceLocation& where, const char* what) {
        for (const double number : numbersIn(text))
            if (isAnswer(number)) return tell(where, what);
    }
    Errors take() { return std::move(m_errors); }

private:
    void tell(const SourceLocation& where, const std::string& what) {
        m_errors.push_back({where, fmt::format("{} gives the answer before it is asked for", what),
                            "it after \"## then\", or in \"works\""});
    }

    const Context& m_context;
    double m_answer, m_tolerance;
    Errors m_errors;
};

int digitsOf(double answer, double tolerance) {
    const double size = std::abs(answer);
    if (size == 0) return 1;
    const double step = tolerance > 0 ? 2 * tolerance : answer == std::trunc(answer) ? 1 : 1e-12 * size;
    return int(std::floor(std::log10(size)) - std::floor(std::log10(step))) + 1;
}

void lookForHidden(const Prose& prose, const Hidden& hidden, Errors& errors) {
    const auto look = [&](const auto& self, const Node& node) -> void {
        if (node.buffer && hidden.hides(*node.buffer))
            errors.push_back({node.where, fmt::format("the text reads {}, which this page hides", node.buffer->text()),
                              "it after \"## then\""});
        if (node.changes.empty())
            for (const Node& operand : node.operands) self(self, operand);
    };
    for (const Prose::Hole& hole : prose.holes) look(look, hole.expression.root);
}

}  // namespace

Errors leaksOf(const Page& page, const Context& context) {
    Errors errors;
    if (!page.question) return errors;
    const Question& question = *page.question;
    const std::vector<pipeline::BufferName> shown = shownBuffers(page.first.state);
    for (const pipeline::BufferName& name : page.hiddenBuffers)
        if (std::ranges::find(shown, name) != shown.end())
            errors.push_back({page.where, fmt::format("this page hides {} and shows it", name.text()), "one of both"});
    Hidden named;
    named.buffers = page.hiddenBuffers;
    lookForHidden(page.first.text, named, errors);
    lookForHidden(page.first.paper, named, errors);
    lookForHidden(question.text, named, errors);

    const auto* number = std::get_if<NumberQuestion>(&question.kind);
    const auto answer = number ? evaluate(number->answer, context) : Value();
    if (!number || !answer) return errors;
    const double value = answer->numbers.front(), tolerance = toleranceOf(*number, value);
    if (digitsOf(value, tolerance) < kLeastDigits) return errors;
    Search search(context, value, tolerance);
    search.look(page.first.text, page.where, "the first half");
    search.look(page.first.paper, page.where, "the first half on paper");
    const Held& held = page.first.held;
    search.look(held.shows, held.where, "what is shown beside the hand");
    for (const pipeline::Hold& hold : held.holds)
        search.lookIn(wordsOf(context.frame.scene(), hold), held.where, "the value beside the hand");
    search.look(question.text, question.where, "the question");
    search.look(question.paper, question.where, "the question on paper");
    search.look(question.wrong, question.where, "\"wrong\"");
    for (const Prose& hint : question.hints) search.look(hint, question.where, "a hint");
    for (const Mistake& mistake : number->mistakes)
        search.look(mistake.said, mistake.where, "what is said of a mistake");
    for (const pipeline::BufferName& name : shown)
        if (const auto buffer = context.frame.buffer(name)) search.look(*buffer, page.where);
    search.lookAtReads(number->answer.root, shown, question.where);
    const Errors found = search.take();
    errors.insert(errors.end(), found.begin(), found.end());
    return errors;
}

}  // namespace lessons
