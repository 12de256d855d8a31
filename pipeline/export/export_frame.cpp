#include "pipeline/export/export_frame.h"

#include <algorithm>

#include "pipeline/export/byte_file.h"
#include "pipeline/export/contents.h"
#include "pipeline/export/contracts_json.h"
#include "pipeline/export/exporter.h"
#include "pipeline/export/manifest.h"
#include "pipeline/export/png_file.h"
#include "pipeline/export/staging.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/toml_writer.h"

namespace pipeline {

namespace fs = std::filesystem;

namespace {

// Every buffer that the scene could have and the request does not exclude, and what was derived.
std::vector<BufferName> askedFor(const Frame& frame, const ExportRequest& request) {
    std::vector<BufferName> names = request.buffers.empty() ? allBuffers(frame.scene().lights.size()) : request.buffers;
    for (const ExportRequest::Derived& derived : request.derived)
        if (std::ranges::find(names, derived.buffer.name) == names.end()) names.push_back(derived.buffer.name);
    return names;
}

const ExportRequest::Derived* findDerived(const ExportRequest& request, const BufferName& name) {
    const auto found =
        std::ranges::find(request.derived, name, [](const ExportRequest::Derived& one) { return one.buffer.name; });
    return found == request.derived.end() ? nullptr : &*found;
}

std::optional<AnyBuffer> bufferOf(const Frame& frame, const ExportRequest& request, const BufferName& name) {
    if (!isDerived(name.id)) return frame.buffer(name);
    const ExportRequest::Derived* derived = findDerived(request, name);
    return derived ? std::optional(derived->buffer) : std::nullopt;
}

std::string fileName(const BufferName& buffer, const Exporter& exporter) {
    return buffer.text() + '.' + std::string(exporter.name);
}

ExportItem makeItem(const Frame& frame, const AnyBuffer& buffer, std::shared_ptr<const std::string> scene,
                    std::shared_ptr<const std::string> state) {
    const BufferStatistics found = statistics(buffer);
    return {buffer, found, fittingRange(buffer, found, frame.scene().settings.depthFormat), std::move(scene),
            std::move(state)};
}

// What a picture carries: nothing where it would be larger than the picture.
std::shared_ptr<const std::string> sceneToCarry(const Frame& frame) {
    auto text = toTomlScene(frame.scene());
    if (!text || text->size() > kMaxCarriedScene) return nullptr;
    return std::make_shared<const std::string>(*std::move(text));
}

std::uint64_t bytesOf(const std::vector<PlannedFile>& files) {
    std::uint64_t bytes = 0;
    for (const PlannedFile& file : files) bytes += file.bytes;
    return bytes;
}

Result<std::vector<std::string>> writeViews(const ExportRequest& request, const fs::path& folder) {
    std::vector<std::string> names;
    if (!request.writeMore) return names;
    const auto files = request.writeMore(folder);
    if (!files) return files.errors();
    for (const fs::path& file : *files) names.push_back(file.filename().string());
    return names;
}

// The files that hold the whole frame.
Result<std::vector<WrittenScene>> writeScene(const Frame& frame, const ExportRequest& request, const fs::path& folder) {
    std::vector<WrittenScene> written;
    for (const FrameExporter& exporter : frameExporterTable()) {
        if (std::ranges::find(request.formats, exporter.name) == request.formats.end()) continue;
        const std::string file = sceneFileName(frame.scene().name, exporter);
        const auto bytes = exporter.write(frame, folder / file);
        if (!bytes) return bytes.errors();
        written.push_back({file, &exporter, *bytes});
    }
    return written;
}

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

std::vector<std::string> wholeFiles(const Scene& scene, const std::vector<std::string>& formats) {
    std::vector<std::string> names;
    for (const FrameExporter& exporter : frameExporterTable())
        if (std::ranges::find(formats, exporter.name) != formats.end())
            names.push_back(sceneFileName(scene.name, exporter));
    names.emplace_back(kManifest);
    return names;
}

std::vector<PlannedFile> plannedFiles(const Frame& frame, const ExportRequest& request) {
    std::vector<PlannedFile> files;
    for (const BufferName& name : askedFor(frame, request)) {
        const auto buffer = bufferOf(frame, request, name);
        for (const std::string& format : request.formats) {
            if (findFrameExporter(format)) continue;
            const Exporter* exporter = findExporter(format);
            PlannedFile file{name, format, {}, 0, false, {}};
            if (!exporter)
                file.whyNot = "There is no such format.";
            else if (!buffer)
                file.whyNot = frame.whyAbsent(name);
            else
                file.whyNot = exporter->refuses(*buffer->info);
            if (exporter && buffer && file.whyNot.empty()) {
                file.file = fileName(name, *exporter);
                file.bytes = exporter->estimate(*buffer);
                file.exact = exporter->sizeIsExact;
            }
            const auto same = [&](const PlannedFile& other) { return other.buffer == name && other.format == format; };
            if (std::ranges::none_of(files, same)) files.push_back(std::move(file));  // a format given twice
        }
    }
    return files;
}

Result<ExportSummary> exportFrame(const Frame& frame, const ExportRequest& request, const ExportProgress& progress) {
    const std::vector<PlannedFile> files = plannedFiles(frame, request);
    const auto total = static_cast<double>(bytesOf(files) + 1);
    const auto goOn = [&](double share, std::string_view file) { return !progress || progress(share, file); };

    auto begun = Staging::begin(request.folder);
    if (!begun) return begun.errors();
    Staging staging = std::move(begun).value();
    if (!request.replacesAny) {
        std::vector<std::string> names = wholeFiles(frame.scene(), request.formats);
        for (const PlannedFile& file : files)
            if (!file.file.empty()) names.push_back(file.file);
        if (Errors errors = whyNotReplaced(request.folder, names, kManifest); !errors.empty()) return errors;
    }

    ExportSummary summary, cancelled;
    cancelled.cancelled = true;
    std::vector<WrittenBuffer> written;
    const std::shared_ptr<const std::string> scene = sceneToCarry(frame);
    const auto state = request.state.empty() ? nullptr : std::make_shared<const std::string>(request.state);
    double done = 0;
    for (const PlannedFile& file : files) {
        const auto buffer = bufferOf(frame, request, file.buffer);
        if (!buffer) continue;
        if (written.empty() || !(written.back().item.buffer.name == file.buffer)) {
            const ExportRequest::Derived* derived = findDerived(request, file.buffer);
            written.push_back({makeItem(frame, *buffer, scene, state), {}, derived ? derived->meaning : std::string()});
        }
        if (file.file.empty()) continue;
        if (!goOn(done / total, file.file)) return cancelled;
        const Exporter* exporter = findExporter(file.format);
        const auto bytes = exporter->write(written.back().item, staging.folder() / file.file);
        if (!bytes) return inFolder(bytes.errors(), request.folder);
        written.back().files.push_back({file.file, exporter, *bytes});
        summary.files.push_back(file.file);
        summary.bytes += *bytes;
        done += static_cast<double>(file.bytes);
    }

    const auto whole = writeScene(frame, request, staging.folder());
    if (!whole) return inFolder(whole.errors(), request.folder);
    for (const WrittenScene& file : *whole) {
        summary.files.push_back(file.file);
        summary.bytes += file.bytes;
    }

    if (!goOn(done / total, request.writeMore ? "views" : kManifest)) return cancelled;
    const auto views = writeViews(request, staging.folder());
    if (!views) return inFolder(views.errors(), request.folder);
    for (const std::string& view : *views) {
        std::error_code error;
        const auto size = fs::file_size(staging.folder() / view, error);
        summary.files.push_back(view);
        if (!error) summary.bytes += size;
    }

    Json all = manifest(frame, askedFor(frame, request), written, *whole, *views, request.at);
    if (request.at.empty()) {  // between two steps of a stage nothing has to hold yet
        std::vector<BufferName> names;
        for (const WrittenBuffer& buffer : written) names.push_back(buffer.item.buffer.name);
        const ContractInput input = contractInput(frame, names);
        bool goesOn = true;  // who has said no is not asked again
        const auto contracts = checkContracts(input, [&] { return goesOn = goesOn && goOn(done / total, kManifest); });
        if (!goesOn) return cancelled;
        all["contracts"] = toJson(contracts, input, false);
    }
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

    if (!goOn(1, kManifest)) return cancelled;
    const auto published = staging.publish(summary.removed, kManifest);
    if (!published) return published.errors();
    return summary;
}

}  // namespace pipeline
