#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/export/study/study_html.h"

namespace pipeline {

std::vector<std::string> studyFiles();  // the names of the files below
// Everything about a study in a folder, all files or none; what else is in the folder stays:
// study.csv, report.html, plot.svg, plot.png, plot-dark.svg, plot-dark.png, and study.json, which goes first, comes last
// and has the hashes of the others. Gives the names of the files.
Result<std::vector<std::string>> writeStudyFiles(const StudyReport& report, const StudyAnalysis& analysis,
                                                 const StudyLimits& limits, const std::vector<StudyPictures>& pictures,
                                                 const std::filesystem::path& folder);

}  // namespace pipeline
