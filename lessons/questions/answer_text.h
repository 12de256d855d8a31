#pragma once
#include <string>

#include "lessons/questions/judge.h"

// What a wrong answer is, in words; answerText in judge.h has the right one.

namespace lessons {

// Of one of its mistakes, a number or a click: "169", "for example x 226, y 280", which is neither right nor one of the
// mistakes before it. "other values" of settings, whose frames are not searched.
pipeline::Result<std::string> mistakeText(const Question& question, std::size_t mistake, const Context& context);

}  // namespace lessons
