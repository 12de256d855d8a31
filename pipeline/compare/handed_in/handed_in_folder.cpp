#include <algorithm>
#include <filesystem>

#include "pipeline/compare/verdict.h"
#include "pipeline/formats/scene_folder.h"

// What reads folders; a page gives the files that it was given (takeHandedIn).

namespace pipeline::foreign {

HandedIn readHandedIn(const std::vector<std::string>& paths, const Frame& reference, const Stop& stop) {
    std::vector<OfferedFile> files;
    Errors errors;
    const auto offer = [&](const std::filesystem::path& path, bool asked) {
        files.push_back({path.string(), asked, [path](std::size_t most) { return readFile(path, most); }});
    };
    for (const std::string& given : paths) {
        const std::filesystem::path path(given);
        std::error_code failed;
        if (!std::filesystem::exists(path, failed)) {
            errors.push_back(noSuchFile(given));
            continue;
        }
        if (!std::filesystem::is_directory(path, failed)) {
            offer(path, true);
            continue;
        }
        constexpr std::size_t kMostEntries = 10000;
        std::vector<std::filesystem::path> entries;
        for (std::filesystem::directory_iterator at(path, failed), end;
             !failed && at != end && entries.size() < kMostEntries; at.increment(failed))
            if (at->is_regular_file(failed)) entries.push_back(at->path());
        if (failed) errors.push_back({{given}, "the folder cannot be read: " + failed.message(), {}});
        std::ranges::sort(entries);
        for (const auto& entry : entries) offer(entry, false);
    }
    HandedIn in = takeHandedIn(files, reference, stop);
    in.errors.insert(in.errors.begin(), errors.begin(), errors.end());
    return in;
}

Result<Report> compareRenderer(const Scene& scene, const std::vector<std::string>& paths,
                               const CompareOptions& options) {
    std::string given;
    for (const std::string& path : paths) given += (given.empty() ? "" : " ") + path;
    auto reference = makeReference(scene, options.tolerances, options.stop);
    if (!reference) return Error{{}, "cancelled", {}};
    HandedIn in = readHandedIn(paths, *reference->frame, options.stop);
    return compareRenderer(scene, std::make_shared<const Reference>(std::move(*reference)), std::move(in), given,
                           options);
}

}  // namespace pipeline::foreign
