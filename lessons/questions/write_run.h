#pragma once
#include <functional>
#include <string>

#include "lessons/questions/judge.h"
#include "pipeline/core/stop.h"

namespace lessons {

// Runs the text of a function, one result for each call. Errors: what its lines may not say, or why it was ended. Empty where
// nothing on this machine runs lines.
using LinesRunner = std::function<pipeline::Result<pipeline::OwnResults>(
    const pipeline::OwnContract& contract, const std::string& text, const std::vector<pipeline::OwnElement>& calls)>;

// What a text is judged to be on a page's scene and the trials, up to the first in which a result differs. Errors of `run`;
// "stopped".
pipeline::Result<Written> judgedIn(const WriteQuestion& write, const pipeline::Scene& scene, const std::string& text,
                                   const LinesRunner& run, const pipeline::Stop& stop = {});

// Of checkLesson: scenes that never call the function, mistakes of the contract that no scene shows or tells from another
// one; and with `run` an answer that is not right, a start that is.
pipeline::Errors writeErrorsOf(const Question& question, const WriteQuestion& write, const pipeline::Scene& scene,
                               const LinesRunner& run, const pipeline::Stop& stop = {});

}  // namespace lessons
