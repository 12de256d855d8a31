#pragma once
#include <optional>
#include <string>

#include "pipeline/study/run_study.h"

namespace app {

// The error that a study is about, as --error names it.

// "normal:mean angle:model"; the kind may be missing: model. Nothing where it is no such thing.
std::optional<pipeline::ErrorChoice> parseChoice(const std::string& text);

// Why no study of the scene can have the error; empty where one may.
std::string whyNoError(const pipeline::Scene& scene, const pipeline::ErrorChoice& choice);

// Makes the report be about an error that its points have: the one that is asked for, or else that of its sweep, or the
// first of those there are. Gives what is wrong with one that is asked for, if anything.
std::string chooseError(const pipeline::StudyRequest& request, pipeline::StudyReport& report);

}  // namespace app
