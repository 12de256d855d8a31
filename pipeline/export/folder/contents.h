#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/export/json/json_value.h"

namespace pipeline {

// An index is the file of a folder that names the others: manifest.json, film.json, study.json. Its member "contents"
// lists them with their sizes in bytes and their SHA-256.

// The list for files in `folder`, by their names.
Json contentsOf(const std::filesystem::path& folder, const std::vector<std::string>& names);
// The same for files that are whole in memory: (name, bytes) each.
Json contentsOf(const std::vector<std::pair<std::string, std::string>>& files);

// The index in the folder; null where there is none or it is no JSON. A stranger may have written it: levels deeper than
// any index has are left out, for they would be copied one by one, and so is "settings", which nobody reads.
Json readIndex(const std::filesystem::path& folder, const std::string& index);

// The plain names that an index lists; nothing that leads out of its folder.
std::vector<std::string> namesIn(const Json& index);

// Why the files in the folder are not those of its index: "depth.npy is not as manifest.json has it". Empty where they
// are, and where nothing was there. What somebody has taken away is no reason.
std::string whyInDoubt(const std::filesystem::path& folder, const std::string& index, const Json& found);

// What a JSON index says under "program": by it a folder is known as one that the program has written into.
Json programMark();

// Which of these files are there and may be lost for good: the folder's index lacks the program's mark (a page's is its
// footer, which counts for that page alone too), or does not list them, or they are scenes that were changed since. What was on its way when a process was
// ended may go.
Errors whyNotReplaced(const std::filesystem::path& folder, const std::vector<std::string>& names,
                      const std::string& index);

// While an index is away, the file INDEX.unfinished says so and lists the files that are on their way, old and new. It
// stays where a process was ended by force. Of an index in a folder below it stands in the outer one.
std::string unfinishedName(const std::string& index);
std::string unfinishedText(const std::vector<std::string>& names);

}  // namespace pipeline
