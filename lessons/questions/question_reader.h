#pragma once
#include <array>

#include "lessons/lesson.h"
#include "lessons/lesson_text.h"
#include "lessons/questions/question.h"

namespace lessons {

inline constexpr std::array<std::string_view, 25> kQuestionKeys{
    "question", "prediction", "answer", "tolerance", "hint",  "unit",   "near",  "choice", "several",
    "click",    "until",      "free",   "order",     "ends",  "write",  "start", "trial",  "lines",
    "differs",  "mistake",    "works",  "right",     "wrong", "points", "paper"};

// Whether the lines after an entry with this key carry it on.
bool goesOn(std::string_view key);
EntryKeys questionKeys();

// The question that entries with these keys are. `names` gets the name "answer" where the answer is one number; the
// entries are not empty. Nothing where the complaints say why.
std::optional<Question> questionFrom(std::span<const Entry> entries, const pipeline::Scene& scene,
                                     const SceneSource& sceneNamed, Names& names, Complaints& complaints);

}  // namespace lessons
