#pragma once
#include <string>
#include <string_view>

#include "pipeline/core/result.h"
#include "pipeline/core/stop.h"
#include "pipeline/export/json/json_value.h"
#include "pipeline/study/study.h"

namespace pipeline {

// All of a study: what studyFromJson reads back to an equal report. An error that is not a finite
// number becomes null, as one that a point does not have.
Json toJson(const StudyReport& report);

// The text of a study file: toJson laid out with one line a point. contents: of the files beside it
// (pipeline/export/folder/contents.h), or null.
std::string studyFileText(const StudyReport& report, const Json& contents = {});

// The report of a study file's text. `file` is named by errors, which give the place by a JSON
// pointer (RFC 6901): "study.json: /points/3/number is -1, expected a whole number from 0". Members
// that are not known are left alone. Besides its types it is checked that
//   - every point has a value for each axis, which is one of the axis's values,
//   - the points stand in order of their numbers, which tell their values (the last axis fastest),
//   - sizes and counts are within what the program itself can write; times are not below 0.
// Where it is stopped there is an error that says so.
Result<StudyReport> studyFromJson(std::string_view text, const std::string& file, const Stop& stop = {});

}  // namespace pipeline
