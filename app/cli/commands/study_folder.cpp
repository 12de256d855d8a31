#include "app/cli/commands/study_folder.h"

#include <fmt/format.h>

#include "pipeline/export/folder/staging.h"
#include "pipeline/export/json/study_json.h"
#include "pipeline/formats/text/inputs.h"
#include "pipeline/scene/key_places.h"

namespace app {

namespace fs = std::filesystem;
using pipeline::Error;
using pipeline::Result;
using pipeline::StudyReport;
using pipeline::StudyRequest;

namespace {

std::string fileName(const StudyRequest& request, const char* ending) {
    if (request.shards == 1) return fmt::format("study{}", ending);
    return fmt::format("study-{}-of-{}{}", request.shard + 1, request.shards, ending);
}

Result<StudyReport> parsed(const Result<std::string>& text, const fs::path& file, const pipeline::Stop& stop) {
    if (text) return pipeline::studyFromJson(*text, file.string(), stop);
    return pipeline::namedAt({file.string()}, text.errors());
}

}  // namespace

fs::path studyFile(const fs::path& folder, const StudyRequest& request) { return folder / fileName(request, ".json"); }
fs::path partFile(const fs::path& folder, const StudyRequest& request) {
    return folder / fileName(request, ".part.json");
}

Result<StudyReport> readStudy(const fs::path& file, const pipeline::Stop& stop) {
    return parsed(pipeline::readFile(file), file, stop);
}

Result<std::optional<StudyReport>> resumed(const fs::path& folder, const StudyRequest& request,
                                           const pipeline::Stop& stop) {
    const fs::path file = partFile(folder, request);
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return std::optional<StudyReport>();
    const auto found = parsed(pipeline::readOwnFile(file), file, stop);  // which this study writes again
    if (stop.stop_requested()) return pipeline::readingStopped(file.string());
    if (!found) {
        pipeline::Errors errors = found.errors();
        for (Error& error : errors)
            (error.expected.empty() ? error.found : error.expected) += "; --restart begins this study anew";
        return errors;
    }
    // Parts of one study have the same scene, settings and sweep.
    if (const auto both = pipeline::mergeStudies({pipeline::beginStudy(request), *found}); !both)
        return Error{{file.string()},
                     fmt::format("{}; this is another study", both.errors().front().found),
                     "another folder, or --restart to begin this one anew"};
    return std::optional(*found);
}

Result<std::monostate> writeJson(const StudyReport& report, const fs::path& file) {
    const auto written = pipeline::writeFiles({{file.filename().string(), studyFileText(report)}}, file.parent_path());
    if (!written) return written.errors();
    return std::monostate{};
}

}  // namespace app
