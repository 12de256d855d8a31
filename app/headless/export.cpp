#include "app/headless/export.h"

#include <algorithm>

#include "app/headless/pixel_text.h"
#include "app/headless/read_buffers.h"
#include "app/headless/wanted_frame.h"
#include "pipeline/core/text.h"
#include "pipeline/export/buffers/exporter.h"
#include "pipeline/export/folder/size_text.h"
#include "pipeline/plan/needs.h"
#include "pipeline/run/runner.h"
#include "pipeline/steps/steps.h"

namespace app {

std::vector<std::string> formatNames() {
    std::vector<std::string> names;
    for (const pipeline::Exporter& exporter : pipeline::exporterTable()) names.emplace_back(exporter.name);
    for (const pipeline::FrameExporter& exporter : pipeline::frameExporterTable()) names.emplace_back(exporter.name);
    return names;
}

std::string wrongFormats(const std::vector<std::string>& formats) {
    const std::vector<std::string> known = formatNames();
    for (const std::string& format : formats)
        if (std::ranges::find(known, format) == known.end())
            return fmt::format("no format {}, expected {}", pipeline::inQuotes(format), fmt::join(known, ", "));
    return {};
}

namespace {

// Takes out the formats that cannot hold this scene. One line for each: the format and the reason.
std::vector<std::string> takeRefused(const pipeline::Scene& scene, std::vector<std::string>& formats) {
    std::vector<std::string> reasons;
    std::erase_if(formats, [&](const std::string& format) {
        const pipeline::FrameExporter* exporter = pipeline::findFrameExporter(format);
        const std::string why = exporter ? exporter->refuses(scene) : std::string();
        if (!why.empty()) reasons.push_back(fmt::format("--format {}: {}", format, why));
        return !why.empty();
    });
    return reasons;
}

// Buffers asked for by name that no chosen format can hold; the manifest alone would not be read.
void tellLeftOut(const pipeline::Frame& frame, const pipeline::ExportRequest& request, const CommandHost& host) {
    if (request.buffers.empty()) return;
    const auto files = plannedFiles(frame, request);
    for (const pipeline::BufferName& buffer : request.buffers) {
        const auto of = [&](const pipeline::PlannedFile& file) { return file.buffer == buffer; };
        const auto written = [&](const pipeline::PlannedFile& file) { return of(file) && !file.file.empty(); };
        const auto why = std::ranges::find_if(files, of);
        if (why == files.end() || std::ranges::any_of(files, written)) continue;  // no format for buffers
        host.tell("{}: no file. {}\n", buffer.text(), why->whyNot);
    }
}

// Whether an export would write its manifest alone, and with that remove the export before.
bool isWithoutFiles(const pipeline::Frame& frame, const pipeline::ExportRequest& request, bool writesViews) {
    const auto isWhole = [](const std::string& format) { return pipeline::findFrameExporter(format) != nullptr; };
    if (writesViews || std::ranges::any_of(request.formats, isWhole)) return false;
    return std::ranges::all_of(plannedFiles(frame, request), [](const auto& file) { return file.file.empty(); });
}

// The derived ones of buffers by name, which leave the others behind.
std::vector<pipeline::BufferName> takeDerived(std::vector<std::string>& names) {
    std::vector<pipeline::BufferName> derived;
    std::erase_if(names, [&](const std::string& text) {
        const auto name = pipeline::findDerived(text);
        if (name) derived.push_back(*name);
        return name.has_value();
    });
    return derived;
}

}  // namespace

int exportBuffers(const std::shared_ptr<const pipeline::Scene>& scene, ExportOptions options, const ExportPlace& to,
                  const CommandHost& host) {
    for (const std::string& why : takeRefused(*scene, options.formats))
        host.tell("{}{}\n", options.formats.empty() ? "shadescope export: " : "left out: ", why);
    if (options.formats.empty()) return kWrongUsage;
    std::optional<pipeline::Place> at;
    std::optional<pipeline::StageId> until = pipeline::findStage(options.frame.until);
    if (!options.at.empty()) {
        const auto place = pipeline::parsePlace(options.at, *scene);
        if (!place) return host.refuse(place.errors(), kWrongUsage);
        at = *place;
        until = at->stage;  // nothing later is looked at
    }
    if (const auto errors = to.prepare(options, until); !errors.empty()) return host.refuse(errors, kBadInput);
    FrameArgument argument = options.frame;
    argument.makesDerived = true;
    if (at) argument.until = pipeline::stageInfo(at->stage).name;
    const std::vector<pipeline::BufferName> named = takeDerived(argument.buffers);
    const auto wanted = wantedFrame(*scene, argument);
    if (!wanted) return host.refuse(wanted.errors(), kWrongUsage);
    const auto derivedOnes = derivedWanted(options.derived, named, *scene, until);
    if (!derivedOnes) return host.refuse(derivedOnes.errors(), kWrongUsage);
    std::optional<glm::ivec2> pixel;
    if (!options.pixel.empty()) {
        const auto in = pixelIn(*scene, options.pixel);
        if (!in) return host.refuse(in.errors(), kWrongUsage);
        pixel = *in;
    }

    pipeline::FrameRequest frameRequest = wanted->request;
    if (argument.until.empty()) frameRequest.until = std::max(frameRequest.until, lastStageOf(derivedOnes->buffers));
    frameRequest.stop = host.stop;
    frameRequest.wanted |= derivedOnes->buffers;
    // The calls hold normals, also where the run ends before anybody shades with them.
    if (std::ranges::find(options.formats, "opengl") != options.formats.end())
        frameRequest.wanted |= pipeline::normalsOfShading(*scene);
    if (int status = kDone; !host.fits(*scene, frameRequest, status)) return status;
    if (!to.mayWrite(pipeline::wholeFiles(*scene, options.formats))) return kCouldNotWrite;
    pipeline::FramePtr frame = runFrame(scene, frameRequest, nullptr);
    if (frame) host.messages(remarksText(*frame));
    // Derived ones alone: and no other.
    const auto& buffers = argument.buffers.empty() ? derivedOnes->names : wanted->buffers;
    pipeline::ExportRequest request{options.folder, buffers, options.formats, {}, {}, {}};
    if (at && frame) {
        const pipeline::Steps steps(frame);
        const pipeline::Moment moment = steps.momentOf(*at);
        request.at = text(steps.placeOf(moment));
        if (!steps.comesTo(*at))
            host.tell("This frame does not come to {}; what is written is {}.\n", options.at, request.at);
        frame = steps.frameAt(moment, options.frame.threads, host.stop);
    }
    request.replacesAny = options.force;
    if (!frame || !readBuffers(*frame, buffers, host.stop)) return host.cancelled();
    auto derived = derivedOf(*derivedOnes, *frame, options.frame.threads, host.stop);
    if (!derived) return host.refuse(derived.errors(), kBadInput);
    if (host.stop.stop_requested()) return host.cancelled();
    request.derived = std::move(derived).value();
    if (isWithoutFiles(*frame, request, to.writesViews)) {
        tellLeftOut(*frame, request, host);
        host.tell("shadescope export: no buffer has a file in {}. Nothing was written.\n",
                  fmt::join(options.formats, ", "));
        return kWrongUsage;
    }
    const auto summary = to.write(*frame, request, options, at, pixel);
    if (!summary) return host.refuse(summary.errors(), kCouldNotWrite);
    if (summary->cancelled) return host.cancelled();
    tellLeftOut(*frame, request, host);
    if (!summary->inDoubt.empty())
        host.tell("{}: {}; the export there was replaced\n", options.folder, summary->inDoubt);
    const std::size_t removed = summary->removed.size();
    // With the manifest two at least.
    host.tell("{} files, {}, in {}{}\n", summary->files.size(), pipeline::sizeText(summary->bytes), options.folder,
              removed == 0 ? "" : fmt::format("; {} of the export before removed", removed));
    return kDone;
}

}  // namespace app
