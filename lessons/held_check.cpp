#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "lessons/check.h"
#include "lessons/questions/hidden.h"
#include "pipeline/scene/key_places.h"

namespace lessons {

namespace {

using pipeline::SourceLocation;

constexpr std::size_t kMostWordsHeld = 60, kMostWords = 100, kMostWordsOfPlay = 14;
constexpr int kPlaces = 9;  // over the range of a hold

std::size_t wordsOf(std::string_view text) {
    Prose prose;
    prose.pieces.emplace_back(text);
    return wordsIn(prose);
}

class HeldCheck {
public:
    HeldCheck(const Page& page, const PageFrames& frames, const pipeline::Stop& stop)
        : m_page(page), m_frames(frames), m_stop(stop) {}

    pipeline::Errors run() {
        const Held& first = m_page.first.held;
        half(first, m_page.first.state.scene, *m_frames.first);
        if (m_page.then) half(m_page.then->held, m_page.then->state.scene, *m_frames.then);
        const bool holds = !first.holds.empty();
        if (m_page.question) limit(m_page.first.text, "before the question", holds);
        if (m_page.then && !m_page.then->held.holds.empty()) limit(m_page.then->text, "after the question", true);
        if (m_page.question) secrets(first);
        return std::move(m_errors);
    }

private:
    void add(const SourceLocation& where, std::string found, std::string expected = {}) {
        m_errors.push_back({where, std::move(found), std::move(expected)});
    }
    void limit(const Prose& text, std::string_view where, bool holds) {
        if (const std::size_t words = wordsIn(text); words > (holds ? kMostWordsHeld : kMostWords))
            add(m_page.where, fmt::format("this page has {} words {}", words, where),
                holds ? "at most 60 where something is held" : "at most 100");
    }

    void half(const Held& held, const pipeline::Scene& scene, const pipeline::Frame& frame) {
        filled(held.shows, {.frame = frame, .stop = m_stop}, m_errors);
        if (held.play) play(*held.play, frame);
        for (const pipeline::Hold& hold : held.holds) {
            if (!placeOf(scene, hold)) add(held.where, fmt::format("{} is not in the picture", hold.name));
            if (hold.kind != pipeline::Hold::Kind::Number) continue;
            for (int i = 0; i < kPlaces; ++i)
                tried(
                    scene,
                    pipeline::toText(valuesAt(scene, hold, placeOf(scene, hold)->at, glm::dvec2(i / (kPlaces - 1.0)))),
                    held);
        }
        for (const std::string& values : held.strip) tried(scene, values, held);
    }
    void tried(const pipeline::Scene& scene, const std::string& values, const Held& held) {
        auto changed = withSettings(scene, values);
        const pipeline::Errors errors = changed ? checkScene(*changed) : changed.errors();
        if (!errors.empty()) add(held.where, fmt::format("with {}: {}", values, errors.front().found));
    }
    void play(const Play& play, const pipeline::Frame& frame) {
        if (const std::size_t words = wordsOf(play.text); words > kMostWordsOfPlay)
            add(play.where, fmt::format("this play has {} words", words), "at most 14");
        if ((play.text + play.done).find('*') != std::string::npos)
            add(play.where, "this play has Markdown", "plain text, as the picture shows it");
        const auto holds = evaluate(play.until, {.frame = frame, .stop = m_stop});
        if (!holds)
            m_errors.insert(m_errors.end(), holds.errors().begin(), holds.errors().end());
        else if (holds->numbers[0] == 1)
            add(play.where, "the play has reached its end from the beginning", "a page on which it has not");
    }

    // A hand must not tell what the page hides, nor lead to the second half.
    void secrets(const Held& held) {
        const Hidden hidden = hiddenOn(m_page, false);
        for (const Prose::Hole& hole : held.shows.holes) reads(hole.expression.root, hidden);
        const bool hidesEquation = hidden.hides(Part::Equation) || hidden.hides(Part::Inspector);
        if (held.figure == Figure::Equation && hidesEquation)
            add(held.where, "the figure shows the equation, which this page hides", "it after \"## then\"");
        if (!m_page.then || std::holds_alternative<UntilQuestion>(m_page.question->kind)) return;
        for (const pipeline::Hold& hold : held.holds)
            for (const std::string& key : hold.keys)
                if (valueOf(m_page.first, key) != valueOf(*m_page.then, key))
                    add(held.where, fmt::format("{} is held, and the second half sets it to another value", key),
                        "a page of the kind until, or nothing held");
    }
    static std::optional<double> valueOf(const Half& half, const std::string& key) {
        const auto ref = findSetting(half.state.scene, key);
        return ref ? std::optional(ref->get(half.state.scene)) : std::nullopt;
    }
    void reads(const Node& node, const Hidden& hidden) {
        if (node.buffer && hidden.hides(*node.buffer))
            add(node.where, fmt::format("\"shows\" reads {}, which this page hides", node.buffer->text()),
                "it after \"## then\"");
        for (const Node& operand : node.operands) reads(operand, hidden);
    }

    const Page& m_page;
    const PageFrames& m_frames;
    const pipeline::Stop& m_stop;
    pipeline::Errors m_errors;
};

}  // namespace

std::size_t wordsIn(const Prose& prose) {
    const std::string text = withGaps(prose);
    std::size_t words = 0;
    bool counted = false;  // a dash or an equals sign is no word
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\n' || c == '\t', sign = c > 0 && !std::isalnum(c);
        words += !blank && !sign && !counted;
        counted = !blank && (counted || !sign);
    }
    return words;
}

pipeline::Errors heldErrorsOf(const Page& page, const PageFrames& frames, const pipeline::Stop& stop) {
    return HeldCheck(page, frames, stop).run();
}

}  // namespace lessons
