#pragma once
#include <optional>

#include "lessons/lesson.h"
#include "lessons/lesson_text.h"

namespace lessons {

// Of the entries of a question of kind write its own part; `write` is the one that names the function. scope: of the texts.
// Nothing where the complaints say why.
std::optional<WriteQuestion> writeFrom(std::span<const Entry> entries, const Entry& write,
                                       const SceneSource& sceneNamed, const Scope& scope, Complaints& complaints);

}  // namespace lessons
