#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lessons/questions/judge.h"

namespace lessons {

// One answer that was judged wrong or right.
struct Try {
    std::string given;  // as typed, "B", "A, C", "polygon 3", "268, 281"
    bool right = false;
    std::string mistake;    // id, where it has a name
    std::size_t hints = 0;  // seen before it
    double seconds = 0;     // since the page was opened
    bool operator==(const Try&) const = default;
};

// How far somebody has come with a question; enough to continue later.
struct Progress {
    enum class Outcome : std::uint8_t { Open, Right, Shown };  // Shown: after Show me, or after the last try
    Outcome outcome = Outcome::Open;
    std::size_t hints = 0;   // seen
    std::vector<Try> tries;  // in their order
    bool operator==(const Progress&) const = default;
};

// The state of one question: takes answers, gives hints, keeps the points.
//
//   Attempt attempt(*page.question);
//   const auto verdict = attempt.check(Typed{"0,67"}, {.frame = *frame}, seconds);   // of requestFor(page)
//   card.setMark(attempt.state()); card.say(verdict->said); next.setEnabled(attempt.isSettled());
//
class Attempt {
public:
    enum class State : std::uint8_t { Open, WrongKnown, WrongUnknown, Right, Shown };

    // question: has to outlive this.
    explicit Attempt(const Question& question, Progress progress = {});

    State state() const;
    bool isSettled() const { return m_progress.outcome != Progress::Outcome::Open; }
    const Progress& progress() const { return m_progress; }

    // Judges and remembers an answer; Mark::Again, which a value that was tried before gets too, is not remembered and
    // costs nothing. The question must be open. After the last try the state is Shown. Errors as judge's: then nothing
    // has happened.
    pipeline::Result<Verdict> check(const Given& given, const Context& context, double seconds = 0);

    std::size_t hintsSeen() const { return m_progress.hints; }
    std::size_t hintCount() const { return m_question->hints.size(); }
    // Shows the next hint, Markdown; there must be one, and the question be open.
    pipeline::Result<std::string> nextHint(const Context& context);
    // One that was seen, from 0.
    pipeline::Result<std::string> hint(std::size_t number, const Context& context) const;

    // Gives up: the state is Shown.
    void showMe();
    // The answer and how it is worked out, a step a line, Markdown. For a settled question.
    struct Solution {
        std::string answer;
        std::vector<std::string> steps;
    };
    pipeline::Result<Solution> solution(const Context& context) const;

    double points() const;  // got: 0 while it is open
    double worth() const;   // what a right answer gives now
    double full() const { return m_question->points; }
    std::size_t wrongTries() const;  // those that cost: not the first of a prediction
    bool isFree() const { return m_question->isPrediction && m_progress.tries.empty(); }  // the next answer
    // How many more answers are taken; nothing: as many as one likes (until).
    std::optional<std::size_t> triesLeft() const;
    // Whether an option of a choice was tried and is off.
    bool isOff(std::size_t option) const;

private:
    const Question* m_question;
    Progress m_progress;
};

// How an answer is recorded.
std::string textOf(const Question& question, const Given& given);

}  // namespace lessons
