#pragma once
#include "pipeline/compare/verdict.h"

// The options of a comparison as texts, as the command line and a page take them. Each gives what is wrong, or nothing.

namespace pipeline::foreign {

// "color=2": a buffer's name without a light's index, and a number.
std::optional<std::string> readTolerance(const std::string& text, std::map<std::string, double>& into);
// "shading": compare no further.
std::optional<std::string> readUntil(const std::string& text, StageId& until);
// The id of a known error of the scene.
std::optional<std::string> readWithout(const std::string& id, const Scene& scene, std::vector<std::string>& into);

// Of the command: 0 agrees, 1 does not, 3 some of the files could not be read.
int exitStatus(const Report& report);

}  // namespace pipeline::foreign
