#pragma once
#include <string>

#include "pipeline/study/study.h"

namespace pipeline {

// A study as a table for other programs (RFC 4180, decimal points, one line of names): a row for
// each point and measure, in the order of both. Of a point stand in each of its rows its number, its
// value of each axis, why it failed, the times of the frame in milliseconds (smallest, median, 95th
// percentile, interval of the median), the median of each stage, megabytes and the counters. A point
// without measures has one row. What is not known is empty.
std::string studyCsv(const StudyReport& report);

}  // namespace pipeline
