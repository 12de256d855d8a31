#pragma once
#include <cstdint>

#include "pipeline/export/folder/staging.h"

// What commands ask of Staging beside writing: whether they may, and when none of them is in the middle of it.
namespace pipeline {

// writeFiles() of names that may lead into a folder below, while the files `gone` go.
Result<std::vector<std::string>> replaceFiles(const std::vector<std::pair<std::string, std::string>>& files,
                                              const std::filesystem::path& folder,
                                              const std::vector<std::string>& gone);

// Why these files cannot come into the folder, or this file be written: tried before anything is computed. Empty where
// they can. An input (isInput()) is never replaced.
Errors whyNotInto(const std::filesystem::path& folder, const std::vector<std::string>& names);
Errors whyNotTo(const std::filesystem::path& file);

// How many folders and files this process has begun to publish; and end(), which does not come back, at a moment when none
// is being published, unless there have been more than `known`.
std::uint64_t publications();
void endBetweenPublications(std::uint64_t known, void (*end)());

}  // namespace pipeline
