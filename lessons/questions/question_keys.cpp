// Which keys a question has, and how often.
#include "lessons/questions/question_reader.h"

namespace lessons {

namespace {

constexpr std::array<std::string_view, 6> kRepeatedQuestionKeys{"choice",  "several", "order",
                                                                "mistake", "hint",    "trial"};
constexpr std::array<std::string_view, 3> kQuestionKeysWithId{"choice", "several", "mistake"};
constexpr std::array<std::string_view, 12> kOneLineKeys{"tolerance", "unit", "near",    "click", "until", "free",
                                                        "order",     "ends", "differs", "write", "trial", "lines"};
constexpr std::array<std::string_view, 3> kBlockKeys{"start", "answer", "mistake"};

}  // namespace

bool goesOn(std::string_view key) { return !has(kOneLineKeys, key); }

EntryKeys questionKeys() { return {kQuestionKeys, kRepeatedQuestionKeys, kQuestionKeysWithId, kBlockKeys}; }

}  // namespace lessons
