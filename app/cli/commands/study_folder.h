#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/study/run_study.h"

namespace app {

// What a study leaves in its folder.
//   study.json and the rest    pipeline/export/study/study_files.h
//   study-3-of-16.json         a part of a study that is shared out
//   *.part.json                as far as a study has come that was interrupted

std::filesystem::path studyFile(const std::filesystem::path& folder, const pipeline::StudyRequest& request);
std::filesystem::path partFile(const std::filesystem::path& folder, const pipeline::StudyRequest& request);

pipeline::Result<pipeline::StudyReport> readStudy(const std::filesystem::path& file, const pipeline::Stop& stop = {});

// How far an interrupted study has come: nothing where there is no such file. Of another study: an error.
pipeline::Result<std::optional<pipeline::StudyReport>> resumed(const std::filesystem::path& folder,
                                                               const pipeline::StudyRequest& request,
                                                               const pipeline::Stop& stop = {});

// Files appear whole or not at all.
pipeline::Result<std::monostate> writeJson(const pipeline::StudyReport& report, const std::filesystem::path& file);

}  // namespace app
