#include "app/cli/study_folder.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "pipeline/export/byte_file.h"
#include "pipeline/export/staging.h"
#include "pipeline/export/study_json.h"

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

}  // namespace

fs::path studyFile(const fs::path& folder, const StudyRequest& request) { return folder / fileName(request, ".json"); }
fs::path partFile(const fs::path& folder, const StudyRequest& request) {
    return folder / fileName(request, ".part.json");
}

Result<StudyReport> readStudy(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    if (!in || !(text << in.rdbuf())) return Error{{file.string()}, "could not read", {}};
    return pipeline::studyFromJson(text.str(), file.string());
}

Result<std::optional<StudyReport>> resumed(const fs::path& folder, const StudyRequest& request) {
    const fs::path file = partFile(folder, request);
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return std::optional<StudyReport>();
    const auto found = readStudy(file);
    if (!found) return found.errors();
    // Parts of one study have the same scene, settings and sweep.
    if (const auto both = pipeline::mergeStudies({pipeline::beginStudy(request), *found}); !both)
        return Error{{file.string()},
                     fmt::format("{}; this is another study", both.errors().front().found),
                     "another folder, or --restart to begin this one anew"};
    return std::optional(*found);
}

Result<std::monostate> writeJson(const StudyReport& report, const fs::path& file) {
    auto begun = pipeline::Staging::begin(file.parent_path());
    if (!begun) return begun.errors();
    pipeline::Staging staging = std::move(begun).value();
    pipeline::ByteFile out(staging.folder() / file.filename());
    out.write(studyFileText(report));
    if (const auto written = out.close(); !written) return written.errors();
    return staging.publish();
}

}  // namespace app
