#include "lessons/check.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "lessons/expression/changed_frames.h"
#include "lessons/library.h"
#include "lessons/questions/attempt.h"
#include "lessons/questions/misconceptions.h"
#include "pipeline/core/text.h"
#include "pipeline/run/runner.h"

namespace lessons {

namespace {

using pipeline::Errors;
using pipeline::SourceLocation;

constexpr std::size_t kMostThings = 4096;  // that a click is tried on
constexpr int kPixelStep = 4;              // every fourth pixel of every fourth row
constexpr double kOffTime = 1.0 / 3;       // of the minutes that a lesson says
// Words that only the window knows.
constexpr std::array<std::string_view, 12> kScreenWords{"click",         "drag ",  "press ",    "ctrl+",
                                                        "alt+",          "panel",  "inspector", "tooltip",
                                                        "in the window", "slider", "palette",   "status bar"};

// Tries one page.
class PageCheck {
public:
    PageCheck(const Page& page, const PageFrames& frames, const LinesRunner& run, const pipeline::Stop& stop)
        : m_page(page),
          m_frames(frames),
          m_run(run),
          m_context{.frame = *frames.first, .changed = &m_changed, .stop = stop} {}

    Errors run() {
        checkHalf(m_page.first, m_context);
        add(heldErrorsOf(m_page, m_frames, m_context.stop));
        if (m_page.then) checkHalf(*m_page.then, {.frame = *m_frames.then, .stop = m_context.stop});
        if (!m_page.question) return std::move(m_errors);
        for (const Prose* text : textsOf(question())) fill(*text, m_context);
        std::visit([this](const auto& kind) { check(kind); }, question().kind);
        checkHelp();
        checkPaper();
        add(leaksOf(m_page, m_context));
        return std::move(m_errors);
    }

private:
    const Question& question() const { return *m_page.question; }
    void add(const Errors& errors) { m_errors.insert(m_errors.end(), errors.begin(), errors.end()); }
    void add(const SourceLocation& where, std::string found, std::string expected = {}) {
        m_errors.push_back({where, std::move(found), std::move(expected)});
    }
    std::string fill(const Prose& prose, const Context& context) { return filled(prose, context, m_errors); }
    std::optional<double> number(const Expression& expression, const Context& context) {
        const auto value = evaluate(expression, context);
        if (value) return value->numbers.front();
        add(value.errors());
        return {};
    }
    std::optional<double> number(const Expression& expression) { return number(expression, m_context); }
    std::optional<Verdict> verdictOn(const Given& given) {
        auto verdict = judge(question(), given, m_context);
        if (verdict) return *verdict;
        add(verdict.errors());
        return {};
    }

    void checkHalf(const Half& half, const Context& context) {
        for (const pipeline::BufferName& name : shownBuffers(half.state))
            if (!pipeline::isDerived(name.id) && !context.frame.buffer(name))
                add(m_page.where, fmt::format("no {} to show: {}", name.text(), context.frame.whyAbsent(name)));
        fill(half.text, context);
        fill(half.paper, context);
    }

    void check(const NumberQuestion& kind) {
        const auto answer = number(kind.answer);
        if (!answer) return;
        const double tolerance = toleranceOf(kind, *answer);
        if (tolerance == 0 && *answer != std::trunc(*answer))
            add(question().where, fmt::format("the answer {} has more digits than anybody types", *answer),
                "a tolerance, or round(…)");
        if (const auto verdict = verdictOn(Typed{pipeline::shortestText(*answer)});
            verdict && verdict->mark != Mark::Right)
            add(question().where, "the answer is not judged right");
        std::vector<double> values;
        for (const Mistake& mistake : kind.mistakes) {
            const auto value = number(mistake.value);
            values.push_back(value.value_or(NAN));
            if (!value) continue;
            if (std::abs(*value - *answer) <= tolerance) {
                add(mistake.where, fmt::format("the mistake {} is {}, which is a right answer", mistake.id, *value),
                    "a value beyond the tolerance");
                continue;
            }
            for (std::size_t i = 0; i + 1 < values.size(); ++i)
                if (std::abs(values[i] - *value) <= tolerance)
                    add(mistake.where,
                        fmt::format("the mistakes {} and {} are both {}", kind.mistakes[i].id, mistake.id, *value),
                        "values that can be told apart");
            if (const auto verdict = verdictOn(Typed{pipeline::shortestText(*value)});
                verdict && verdict->mistake != mistake.id)
                add(mistake.where, fmt::format("the mistake {} is answered as {}", mistake.id,
                                               verdict->mistake.empty() ? "one without a name" : verdict->mistake));
        }
    }

    void check(const ChoiceQuestion& kind) {
        const auto holding = holdingOptions(kind.options, m_context);
        if (!holding) return add(holding.errors());
        if (holding->size() != 1)
            add(question().where, fmt::format("{} of {} options hold", holding->size(), kind.options.size()),
                "exactly one");
        refuseIds(kind.options, *holding);
    }
    void check(const SeveralQuestion& kind) {
        const auto holding = holdingOptions(kind.options, m_context);
        if (!holding) return add(holding.errors());
        if (holding->empty() || holding->size() == kind.options.size())
            add(question().where, fmt::format("{} of {} options hold", holding->size(), kind.options.size()),
                "one or more, not all");
        refuseIds(kind.options, *holding);
    }
    void refuseIds(std::span<const Option> options, const std::vector<std::size_t>& holding) {
        for (const std::size_t i : holding)
            if (!options[i].mistake.empty())
                add(options[i].where, fmt::format("the option of the mistake {} holds", options[i].mistake));
    }

    void check(const ClickQuestion& kind) {
        std::size_t all = 0, right = 0;
        std::vector<std::size_t> named(kind.mistakes.size());
        KeptValues kept;
        for (const Pick& pick : picksOf(kind.kind)) {
            Context context = m_context;
            context.pick = &pick, context.kept = &kept;
            const auto holds = number(kind.holds, context);
            if (!holds) return;
            ++all;
            right += *holds == 1;
            for (std::size_t i = 0; *holds != 1 && i < kind.mistakes.size(); ++i) {
                const auto is = number(kind.mistakes[i].value, context);
                if (!is) return;
                if (*is == 1) {
                    ++named[i];
                    break;
                }
            }
        }
        if (right == 0 && !kind.near) add(question().where, fmt::format("no {} is right", name(kind.kind)));
        if (right == all) add(question().where, fmt::format("every {} is right", name(kind.kind)));
        for (std::size_t i = 0; i < named.size(); ++i)
            if (named[i] == 0)
                add(kind.mistakes[i].where,
                    fmt::format("no wrong {} is the mistake {}", name(kind.kind), kind.mistakes[i].id));
        if (!kind.near) return;
        const auto place = evaluate(*kind.near, m_context);
        if (!place) return add(place.errors());
        const pipeline::Settings& settings = m_page.first.state.scene.settings;
        if (place->numbers[0] < 0 || place->numbers[0] >= settings.width || place->numbers[1] < 0 ||
            place->numbers[1] >= settings.height)
            add(question().where, fmt::format("the place {} is outside of the picture", toText(*place)));
    }
    std::vector<Pick> picksOf(ThingKind kind) const {
        std::vector<Pick> picks;
        const pipeline::Scene& scene = m_page.first.state.scene;
        if (kind != ThingKind::Pixel)
            for (std::size_t i = 0; i < std::min(countOf(kind, scene), kMostThings); ++i)
                picks.push_back(pickOf({kind, i}));
        else
            for (int y = 0; y < scene.settings.height; y += kPixelStep)
                for (int x = 0; x < scene.settings.width; x += kPixelStep) picks.push_back(pickAt(x, y));
        return picks;
    }
    // A click on a pixel picks its polygon too.
    Pick pickAt(int x, int y) const {
        Pick pick{.x = x, .y = y};
        if (const auto ids = m_context.frame.buffer({pipeline::BufferId::PolygonId}))
            if (const double id = ids->value(std::size_t(x), std::size_t(y)); id >= 0) pick.polygon = id;
        return pick;
    }

    void check(const WriteQuestion& kind) {
        add(writeErrorsOf(question(), kind, m_page.first.state.scene, m_run, m_context.stop));
    }
    void check(const UntilQuestion& kind) {
        if (const auto holds = number(kind.holds); holds && *holds == 1)
            add(question().where, "the condition holds from the beginning", "a page on which it does not");
        std::vector<std::string> changes;
        for (const UntilQuestion::Setting& setting : kind.answer) {
            std::string value = setting.word;
            if (setting.number) {
                const auto wanted = number(*setting.number);
                if (!wanted) return;
                value = pipeline::shortestText(*wanted);
            }
            changes.push_back(setting.key + '=' + value);
        }
        const auto frame = m_changed.frame(m_context.frame, changes, m_context.frame.wanted(), m_context.stop);
        if (!frame) return add(frame.errors());
        const Context there{.frame = **frame, .changed = &m_changed, .stop = m_context.stop};
        if (const auto holds = number(kind.holds, there); holds && *holds != 1)
            add(question().where, fmt::format("the condition does not hold with {}", fmt::join(changes, ", ")));
        for (const Mistake& mistake : kind.mistakes) {
            if (const auto here = number(mistake.value); here && *here == 1)
                add(mistake.where, fmt::format("the mistake {} holds from the beginning", mistake.id));
            if (const auto right = number(mistake.value, there); right && *right == 1)
                add(mistake.where, fmt::format("the mistake {} holds with the answer", mistake.id));
        }
    }

    void check(const OrderQuestion& kind) {
        const auto right = rightOrder(kind, m_context);
        if (!right) return add(right.errors());
        if (std::ranges::is_sorted(*right))
            add(question().where, "the items stand in the right order from the beginning",
                "another order of the lines");
        const std::vector<std::size_t> opposite(right->rbegin(), right->rend());
        std::vector<std::vector<std::size_t>> wrong;
        for (const OrderQuestion::Wrong& one : kind.mistakes) {
            wrong.push_back(one.order.empty() ? opposite : one.order);
            if (wrong.back() == *right)
                add(one.mistake.where, fmt::format("the mistake {} is the right order", one.mistake.id),
                    "another order");
            if (std::ranges::count(wrong, wrong.back()) > 1)
                add(one.mistake.where, fmt::format("the mistake {} has the order of another one", one.mistake.id),
                    "orders that can be told apart");
        }
    }

    void checkHelp() {
        if (question().hints.empty()) add(question().where, "this question has no hint", "\"hint: …\"");
        if (question().works.empty()) add(question().where, "this question has no working", "\"works: …\" for Show me");
    }

    void checkPaper() {
        refuseScreenWords(m_page.first.paper, m_page.where);
        refuseScreenWords(question().paper.empty() ? question().text : question().paper, question().where);
        if (m_page.then) refuseScreenWords(m_page.then->paper, m_page.where);
    }
    void refuseScreenWords(const Prose& prose, const SourceLocation& where) {
        std::string text = withGaps(prose);
        std::ranges::transform(text, text.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
        for (const std::string_view word : kScreenWords)
            if (text.find(word) != text.npos)
                return add(where, fmt::format("on paper this page says \"{}\"", word),
                           "a paragraph with \"screen: \" before it, or the question with \"paper: \"");
    }

    const Page& m_page;
    const PageFrames& m_frames;
    const LinesRunner& m_run;
    ChangedFrames m_changed;
    Context m_context;
    Errors m_errors;
};

void checkHeader(const Lesson& lesson, Errors& errors) {
    const SourceLocation where{lesson.pages.back().where.file, 1, 1};  // the first may be another lesson's
    const double minutes = minutesOf(lesson);
    if (lesson.minutes > 0 && std::abs(minutes - lesson.minutes) > kOffTime * std::max(minutes, double(lesson.minutes)))
        errors.push_back({where,
                          fmt::format("the lesson says {} minutes and takes about {:.0f}", lesson.minutes, minutes),
                          "a number within a third of that"});
    if (lesson.can.empty()) errors.push_back({where, "no line says what a reader can do afterwards", "\"can: …\""});
    const std::vector<std::string> names = lessonNames();
    if (!lesson.next.empty() && std::ranges::find(names, lesson.next) == names.end())
        errors.push_back({where, "no lesson " + pipeline::inQuotes(lesson.next) + " comes next; " +
                                     pipeline::insteadOf(lesson.next, names)});
}

}  // namespace

double minutesOf(const Lesson& lesson) {
    constexpr double kWordsAMinute = 180, kAPage = 0.5, kAQuestion = 1.5;
    double minutes = 0;
    for (const Page& page : lesson.pages) {
        std::size_t words = wordsIn(page.first.text);
        if (page.then) words += wordsIn(page.then->text);
        if (page.question) words += wordsIn(page.question->text);
        minutes += double(words) / kWordsAMinute + kAPage + (page.question ? kAQuestion : 0);
    }
    return minutes;
}

Errors checkLesson(const Lesson& lesson, const pipeline::Stop& stop, const CheckProgress& progress,
                   const LinesRunner& run) {
    Errors errors;
    checkHeader(lesson, errors);
    const bool all = runPages(lesson, stop, [&](const Page& page, std::size_t number, const PageFrames& frames) {
        if (progress) progress(number);
        const Errors found = PageCheck(page, frames, run, stop).run();
        errors.insert(errors.end(), found.begin(), found.end());
    });
    if (!all) return {pipeline::Error{{}, "stopped", {}}};
    if (errors.size() > pipeline::kMaxErrors) errors.resize(pipeline::kMaxErrors);
    return errors;
}

}  // namespace lessons
