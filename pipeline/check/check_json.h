#pragma once
#include "pipeline/check/case.h"
#include "pipeline/export/json/json_value.h"

namespace pipeline::check {

// A case in words and numbers, not run.
Json toJson(const Case& which);
// The same with what was found. A number that is none becomes null; the texts say what it is.
Json toJson(const CaseResult& result);
// All of a run: cases, hold, seconds, results.
Json toJson(const std::vector<CaseResult>& results, double seconds);

}  // namespace pipeline::check
