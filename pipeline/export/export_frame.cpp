#include <algorithm>

#include "pipeline/export/buffers/byte_file.h"
#include "pipeline/export/export_frame.h"
#include "pipeline/export/folder/contents.h"
#include "pipeline/export/folder/staging.h"
#include "pipeline/export/manifest.h"
#include "pipeline/formats/scene_folder.h"

namespace pipeline {

namespace fs = std::filesystem;

namespace {

// The files of an earlier export in the folder which the new one does not write itself.
std::vector<std::string> remaining(std::vector<std::string> names, const fs::path& folder,
                                   const std::vector<std::string>& written) {
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    std::erase_if(names, [&](const std::string& name) {
        std::error_code ignored;
        const fs::file_status status = fs::symlink_status(folder / name, ignored);
        return !(fs::is_regular_file(status) || fs::is_symlink(status)) ||
               std::ranges::find(written, name) != written.end();
    });
    return names;
}

}  // namespace

Result<ExportSummary> exportFrame(const Frame& frame, const ExportRequest& request, const ExportProgress& progress) {
    auto begun = Staging::begin(request.folder);
    if (!begun) return begun.errors();
    Staging staging = std::move(begun).value();
    if (!request.replacesAny) {
        std::vector<std::string> names = wholeFiles(frame.scene(), request.formats);
        for (const PlannedFile& file : plannedFiles(frame, request))
            if (!file.file.empty()) names.push_back(file.file);
        if (Errors errors = whyNotReplaced(request.folder, names, kManifest); !errors.empty()) return errors;
    }
    const WriteViews views = [&](std::uint64_t& bytes) -> Result<std::vector<std::string>> {
        const auto files = request.writeMore(staging.folder());
        if (!files) return files.errors();
        std::vector<std::string> names;
        for (const fs::path& file : *files) {
            names.push_back(file.filename().string());
            std::error_code error;
            const auto size = fs::file_size(staging.folder() / names.back(), error);
            if (!error) bytes += size;
        }
        return names;
    };
    auto written = writeExportFiles(frame, request, staging.folder(), progress, request.writeMore ? views : nullptr);
    if (!written) return inFolder(written.errors(), request.folder);
    ExportFiles made = std::move(written).value();
    ExportSummary summary, cancelled;
    cancelled.cancelled = true;
    if (made.cancelled) return cancelled;
    summary.files = std::move(made.names), summary.bytes = made.bytes;
    Json& all = made.manifest;
    all["contents"] = contentsOf(staging.folder(), summary.files);
    staging.waitForOthers();  // what the export before has left has to be known when this one takes its place
    const Json earlier = readIndex(request.folder, kManifest);
    const std::string mark = unfinishedName(kManifest);
    std::vector<std::string> names = filesNamedBy(earlier);
    for (const std::string& name : namesIn(readIndex(request.folder, mark)))
        if (isWritten(name)) names.push_back(name);
    const std::vector<std::string> old = remaining(names, request.folder, summary.files);
    summary.inDoubt = whyInDoubt(request.folder, kManifest, earlier);
    if (summary.inDoubt.empty() && areOfOneFrame(earlier, all))
        addEarlier(earlier, old, all);
    else
        summary.removed = old;
    ByteFile out(staging.folder() / kManifest);
    // Replacing what is not UTF-8: a file's name may hold any bytes.
    out.write(all.dump(2) + '\n');
    const auto bytes = out.close();
    if (!bytes) return inFolder(bytes.errors(), request.folder);
    summary.files.push_back(kManifest);
    summary.bytes += *bytes;

    if (progress && !progress(1, kManifest)) return cancelled;
    const auto published = staging.publish(summary.removed, kManifest);
    if (!published) return published.errors();
    return summary;
}

}  // namespace pipeline
