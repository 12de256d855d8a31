#include "pipeline/compare/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/core/text.h"

namespace pipeline::foreign {

namespace {

bool differs(const Report& report, StageId stage) {
    return std::ranges::any_of(report.findings, [&](const Finding& f) { return f.stage == stage && !f.agrees; });
}

// Which stages hand something to this one.
std::vector<StageId> inputsOf(StageId stage) {
    using enum StageId;
    switch (stage) {
        case Transform: return {};
        case Cull:
        case Normals:
        case ShadowBuffer: return {Transform};
        case ZBuffer: return {Transform, Cull};
        case Shading: return {Transform, Cull, Normals, ShadowBuffer, ZBuffer};
    }
    return {};
}

// By the chain alone: the first stage that differs is wrong where all that it gets was handed in and is right.
void judgeByChain(Report& report) {
    std::array<bool, kStageCount> bad{};
    for (const StageId stage : kStages) {
        StageVerdict& verdict = report.stages[index(stage)];
        if (verdict.findings.empty()) continue;
        if (!differs(report, stage)) {
            verdict.standing = Standing::Agrees;
            continue;
        }
        bad[index(stage)] = true;
        bool badInput = false, unknownInput = false;
        for (const StageId input : inputsOf(stage)) {
            badInput = badInput || bad[index(input)];
            const bool needed = input != StageId::ShadowBuffer;  // S is handed in by shading itself
            unknownInput = unknownInput || (needed && report.stages[index(input)].findings.empty());
        }
        verdict.standing = badInput ? Standing::GivenInput : unknownInput ? Standing::CannotTell : Standing::WrongHere;
    }
}

void nameFirstWrong(Report& report) {
    for (const StageId stage : kStages)
        if (report.stages[index(stage)].standing == Standing::WrongHere) {
            report.firstWrong = stage, report.isCertain = true;
            return;
        }
    if (report.suspects && report.suspects->candidates.size() == 1) {
        report.firstWrong = report.suspects->candidates[0].error.stage;
        return;
    }
    for (const StageId stage : kStages)
        if (differs(report, stage)) {
            // A picture alone says nothing of the stage.
            const bool onlyColor = std::ranges::all_of(
                report.findings, [](const Finding& f) { return f.name.buffer.id == BufferId::Color; });
            if (!onlyColor) report.firstWrong = stage;
            return;
        }
}

}  // namespace

std::string_view words(Standing standing) {
    switch (standing) {
        case Standing::Agrees: return "agrees";
        case Standing::WrongHere: return "wrong here";
        case Standing::GivenInput: return "given what it got";
        case Standing::NoFile: return "no file";
        case Standing::CannotTell: return "cannot tell";
    }
    return {};
}

bool Report::agrees() const { return std::ranges::all_of(findings, &Finding::agrees); }
bool Report::conventionsDiffer() const {
    return std::ranges::any_of(conventions.said, [](const Convention& said) { return !said.own; });
}

const Finding* Report::firstDifference() const {
    for (const Finding& finding : findings)
        if (!finding.agrees && (!firstWrong || finding.stage == *firstWrong || !isCertain)) return &finding;
    return nullptr;
}

const ReadFile& Report::fileOf(const Finding& finding) const {
    return *std::ranges::find_if(conventions.files, [&](const ReadFile& f) { return f.file->name == finding.name; });
}

std::vector<std::string> Report::notHandedIn() const {
    std::vector<std::string> missing;
    for (const char* name :
         {"vertices.screen", "polygons.visible", "vertices.normal", "polygon_id", "depth", "normal", "color"}) {
        const auto wanted = *findHanded(name, scene->lights.size());
        const bool there =
            std::ranges::any_of(findings, [&](const Finding& f) { return f.name.buffer == wanted.buffer; });
        if (!there && reference->values.contains(wanted.buffer.text())) missing.emplace_back(name);
    }
    return missing;
}

Result<Report> compareRenderer(const Scene& scene, const std::vector<std::string>& paths,
                               const CompareOptions& options) {
    Report out;
    out.options = options;
    for (const std::string& path : paths) out.given += (out.given.empty() ? "" : " ") + path;
    const auto tell = [&](std::string_view what, std::size_t done, std::size_t all) {
        if (options.progress) options.progress(what, done, all);
    };
    tell("reference", 0, 1);
    auto reference = makeReference(scene, options.tolerances, options.stop);
    if (!reference) return Error{{}, "cancelled", {}};
    out.scene = std::make_shared<const Scene>(scene);
    out.reference = std::make_shared<const Reference>(std::move(*reference));
    auto in = readHandedIn(paths, *out.reference->frame, options.stop);
    std::erase_if(in.files,
                  [&](const HandedFile& file) { return bufferInfo(file.name.buffer.id).stage > options.until; });
    auto stated = readStated(in.conventions, in.conventionsName);
    if (!stated) return stated.errors();
    out.in = std::make_shared<const HandedIn>(std::move(in));
    if (out.in->files.empty()) {
        if (!out.in->errors.empty()) return out.in->errors;
        std::string others;
        for (const std::string& other : out.in->others) others += (others.empty() ? "; " : ", ") + other;
        return Error{
            {out.given},
            "no file here has a known name" + others,
            "color.png, depth.npy, normal.npy, … (shadescope compare --starter python -o mine writes what to hand in)"};
    }
    tell("conventions", 0, 1);
    out.conventions =
        findConventions(*out.in, out.reference->values, out.reference->context, out.reference->tolerances, *stated);
    for (std::size_t i = 0; i < kStageCount; ++i) out.stages[i].stage = kStages[i];
    for (std::size_t i = 0; i < out.conventions.files.size(); ++i) {
        tell("stages", i, out.conventions.files.size());
        if (options.stop.stop_requested()) return Error{{}, "cancelled", {}};
        out.findings.push_back(compareValues(out.conventions.files[i], *out.reference));
        out.stages[index(out.findings.back().stage)].findings.push_back(i);
    }
    judgeByChain(out);
    if (options.known && !out.agrees()) {
        out.suspects = findSuspects(scene, *out.reference, out.conventions, options.stop,
                                    [&](std::size_t done, std::size_t all) { tell("known errors", done, all); });
        if (out.suspects->stopped) return Error{{}, "cancelled", {}};
    }
    nameFirstWrong(out);
    return out;
}

std::string headline(const Report& report) {
    if (report.agrees()) return "Everything handed in agrees.";
    if (report.options.hints < 1) return "Something differs.";
    const bool two = report.suspects && report.suspects->candidates.size() > 1;
    if (report.firstWrong) {
        const std::string_view stage = stageInfo(*report.firstWrong).label;
        if (report.isCertain) return fmt::format("{} is the first wrong stage.", stage);
        if (report.suspects && report.suspects->candidates.size() == 1)
            return fmt::format("{} is most likely the first wrong stage.", stage);
        return fmt::format("{} is the first stage that differs.", stage);
    }
    const bool onlyColor = report.findings.size() == 1 && report.findings[0].name.buffer.id == BufferId::Color;
    const std::string_view what = onlyColor ? "Colour alone" : "What was handed in";
    if (two)
        return fmt::format(
            "The picture differs. {} cannot decide between {} known errors.", what,
            report.suspects->candidates.size() == 2 ? "two" : std::to_string(report.suspects->candidates.size()));
    return fmt::format("The picture differs. {} cannot tell which stage is wrong.", what);
}

std::string evidence(const Report& report) {
    if (report.agrees()) {
        std::size_t said = 0;
        for (const Convention& one : report.conventions.said) said += !one.own;
        return said == 0 ? std::string()
                         : fmt::format("{} of yours {} read as such.", plural(std::int64_t(said), "convention"),
                                       said == 1 ? "was" : "were");
    }
    const Finding* const first = report.firstDifference();
    if (!first || report.options.hints < 1) return {};
    return fmt::format("{}: {}.", first->name.text(), findingText(*first));
}

std::vector<std::string> hints(const Report& report) {
    std::vector<std::string> out;
    if (report.agrees()) return out;
    const Finding* const first = report.firstDifference();
    if (report.options.hints >= 1)
        out.push_back(report.firstWrong ? fmt::format("Stage: {}.", stageInfo(*report.firstWrong).label)
                                        : "The files do not tell the stage. Hand in more of them.");
    if (report.options.hints >= 2 && first)
        out.push_back(first->worst
                          ? fmt::format("Look at {} of {}.", placeText(*first, *first->worst), first->name.text())
                          : fmt::format("Look at {}.", first->name.text()));
    if (report.options.hints >= 3 && report.suspects) {
        if (report.suspects->candidates.empty()) out.push_back("None of the known errors explains this.");
        for (const Candidate& one : report.suspects->candidates)
            out.push_back(fmt::format("{}: {} in place of {}.", one.error.name, one.error.wrong, one.error.right));
    }
    return out;
}

}  // namespace pipeline::foreign
