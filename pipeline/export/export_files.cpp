#include "pipeline/export/export_frame.h"

#include <algorithm>

#include "pipeline/export/buffers/byte_file.h"
#include "pipeline/export/buffers/exporter.h"
#include "pipeline/export/buffers/png_file.h"
#include "pipeline/export/json/contracts_json.h"
#include "pipeline/export/manifest.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/toml/toml_writer.h"

namespace pipeline {

namespace fs = std::filesystem;

namespace {

// In text: a page's library has no operators of paths.
fs::path within(const fs::path& folder, const std::string& file) { return folder.string() + '/' + file; }

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

// The files that hold the whole frame.
Result<std::vector<WrittenScene>> writeScene(const Frame& frame, const ExportRequest& request, const fs::path& folder) {
    std::vector<WrittenScene> written;
    for (const FrameExporter& exporter : frameExporterTable()) {
        if (std::ranges::find(request.formats, exporter.name) == request.formats.end()) continue;
        const std::string file = sceneFileName(frame.scene().name, exporter);
        const auto bytes = exporter.write(frame, within(folder, file));
        if (!bytes) return bytes.errors();
        written.push_back({file, &exporter, *bytes});
    }
    return written;
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

Result<ExportFiles> writeExportFiles(const Frame& frame, const ExportRequest& request, const fs::path& folder,
                                     const ExportProgress& progress, const WriteViews& writeViews) {
    const std::vector<PlannedFile> files = plannedFiles(frame, request);
    const auto total = static_cast<double>(bytesOf(files) + 1);
    bool goesOn = true;  // who has said no is not asked again
    const auto goOn = [&](double share, std::string_view file) {
        return goesOn = goesOn && (!progress || progress(share, file));
    };
    ExportFiles made, cancelled;
    cancelled.cancelled = true;
    std::vector<WrittenBuffer> written;
    const std::shared_ptr<const std::string> scene = sceneToCarry(frame);
    const auto state = request.state.empty() ? nullptr : std::make_shared<const std::string>(request.state);
    double done = 0;
    std::string_view now = kManifest;  // the file that is being written
    const WriterWatch watch([&] { return goOn(done / total, now); });
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
        now = file.file;
        const auto bytes = exporter->write(written.back().item, within(folder, file.file));
        if (!goesOn) return cancelled;
        if (!bytes) return bytes.errors();
        written.back().files.push_back({file.file, exporter, *bytes});
        made.names.push_back(file.file);
        made.bytes += *bytes;
        done += static_cast<double>(file.bytes);
    }
    now = kManifest;
    const auto whole = writeScene(frame, request, folder);
    if (!goesOn) return cancelled;
    if (!whole) return whole.errors();
    for (const WrittenScene& file : *whole) {
        made.names.push_back(file.file);
        made.bytes += file.bytes;
    }
    if (!goOn(done / total, writeViews ? "views" : kManifest)) return cancelled;
    std::vector<std::string> views;
    if (writeViews) {
        auto names = writeViews(made.bytes);
        if (!names) return names.errors();
        views = std::move(names).value();
        made.names.insert(made.names.end(), views.begin(), views.end());
    }
    made.manifest = manifest(frame, askedFor(frame, request), written, *whole, views, request.at);
    if (!request.at.empty()) return made;  // between two steps of a stage nothing has to hold yet
    std::vector<BufferName> names;
    for (const WrittenBuffer& buffer : written) names.push_back(buffer.item.buffer.name);
    const ContractInput input = contractInput(frame, names);
    const auto contracts = checkContracts(input, [&] { return goOn(done / total, kManifest); });
    if (!goesOn) return cancelled;
    made.manifest["contracts"] = toJson(contracts, input, false);
    return made;
}

}  // namespace pipeline
