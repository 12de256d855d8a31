#include "pipeline/compare/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/compare/handed_in/settle_readings.h"
#include "pipeline/compare/handed_in/shadow_frame.h"
#include "pipeline/compare/measured_errors.h"
#include "pipeline/compare/seen_surfaces.h"
#include "pipeline/core/text.h"
#include "pipeline/scene/any_exponent.h"

namespace pipeline::foreign {

namespace {

bool differs(const Report& report, StageId stage) {
    return std::ranges::any_of(report.findings, [&](const Finding& f) { return f.stage == stage && !f.agrees; });
}

// Which stages hand something to a buffer.
std::vector<StageId> inputsOf(const Finding& finding) {
    using enum StageId;
    switch (finding.stage) {
        case Transform: return {};
        case Cull:
        case Normals:
        case ShadowBuffer: return {Transform};
        case ZBuffer: return {Transform, Cull};
        case Shading: break;
    }
    if (finding.name.buffer.id == BufferId::Shadow) return {Transform, ShadowBuffer, ZBuffer};
    if (finding.name.buffer.id == BufferId::Ambient || finding.name.buffer.id == BufferId::Position) return {ZBuffer};
    return {Transform, Cull, Normals, ZBuffer};
}

// Whether another polygon is seen somewhere, by what is handed in: then the pictures differ too, whoever is to blame.
bool seesOtherwise(const Report& report) {
    return std::ranges::any_of(report.findings, [](const Finding& f) {
        return f.stage == StageId::ZBuffer && f.isPicture() && f.name.buffer.id != BufferId::Overdraw && !f.agrees;
    });
}
bool seesTheSame(const Report& report) {
    const auto tells = [](const Finding& f) {
        return f.name.buffer.id == BufferId::ZView || f.name.buffer.id == BufferId::PolygonId;
    };
    return std::ranges::any_of(report.findings, tells) && !seesOtherwise(report);
}

// Transform and culling are not accused where they lead to the right polygons at the right depths: their tables may follow
// a convention that nobody knows.
bool leadsToTheSame(const Report& report, StageId stage) {
    return (stage == StageId::Transform || stage == StageId::Cull) && seesTheSame(report);
}

// Stages that are right, as what they leave is, or what is made of it.
std::array<bool, kStageCount> rightStages(const Report& report) {
    std::array<bool, kStageCount> right{};
    for (const StageVerdict& verdict : report.stages)
        right[index(verdict.stage)] = !verdict.findings.empty() && !differs(report, verdict.stage);
    right[index(StageId::Shading)] = false;
    for (const Finding& finding : report.findings) {
        if (!finding.agrees) continue;
        using enum BufferId;
        const BufferId id = finding.name.buffer.id;
        const bool ofSurface = id == Normal || id == NDotL || id == RDotV || id == NDotH;
        if (id == ZView || id == PolygonId || id == Position || ofSurface)
            for (const StageId stage : {StageId::Transform, StageId::Cull, StageId::ZBuffer})
                if (stage != StageId::ZBuffer || id != PolygonId) right[index(stage)] = true;
        if (ofSurface) right[index(StageId::Normals)] = true;
        if (id == Shadow) right[index(StageId::ShadowBuffer)] = true;
    }
    for (const StageVerdict& verdict : report.stages)  // no buffer of its own may differ
        if (differs(report, verdict.stage) && !leadsToTheSame(report, verdict.stage))
            right[index(verdict.stage)] = false;
    return right;
}

std::string ownText(const Finding& finding, const OwnResult& own) {
    const std::string from = fmt::format("{}", fmt::join(own.from, ", "));
    if (own.finding.agrees) return fmt::format("{}: right with your {}", finding.name.text(), from);
    return fmt::format("{}: wrong also with your {}", finding.name.text(), from);
}

// A buffer that differs is wrong here if what its stage got is right, or if our stage makes another one of what it got.
Standing judge(const Report& report, std::size_t i, const std::array<bool, kStageCount>& right) {
    const Finding& finding = report.findings[i];
    if (finding.agrees) return Standing::Agrees;
    if (leadsToTheSame(report, finding.stage)) return Standing::CannotTell;
    bool allRight = true, badInput = false;
    for (const StageId input : inputsOf(finding)) {
        allRight = allRight && right[index(input)];
        badInput = badInput || (differs(report, input) && !leadsToTheSame(report, input));
    }
    if (report.own[i] && !report.own[i]->finding.agrees) {
        // What else it got may be wrong where it was not handed in.
        const bool partly = finding.stage == StageId::Shading && (seesOtherwise(report) || (!allRight && !badInput));
        return partly ? Standing::CannotTell : Standing::WrongHere;
    }
    if (report.own[i]) return Standing::GivenInput;
    return allRight ? Standing::WrongHere : badInput ? Standing::GivenInput : Standing::CannotTell;
}

void judgeStages(Report& report) {
    const auto right = rightStages(report);
    for (std::size_t i = 0; i < report.findings.size(); ++i) report.standings.push_back(judge(report, i, right));
    for (StageVerdict& verdict : report.stages) {
        if (verdict.findings.empty()) continue;
        verdict.standing = Standing::Agrees;
        // The first of its buffers that differs decides, if a later one is not known to be wrong by itself.
        for (const std::size_t i : verdict.findings) {
            const Standing standing = report.standings[i];
            if (standing == Standing::Agrees) continue;
            if (report.own[i] && verdict.own.empty()) verdict.own = ownText(report.findings[i], *report.own[i]);
            if (verdict.standing == Standing::Agrees || standing == Standing::WrongHere) verdict.standing = standing;
        }
    }
    // Behind a stage that is wrong one is wrong too only if it has made something else of all that it got.
    bool isBehind = false;
    for (StageVerdict& verdict : report.stages) {
        if (verdict.standing != Standing::WrongHere) continue;
        const bool isRight = std::ranges::any_of(verdict.findings, [&](std::size_t i) {
            return !report.findings[i].agrees && report.own[i] && report.own[i]->finding.agrees;
        });
        const bool isTold = std::ranges::any_of(
            verdict.findings, [&](std::size_t i) { return report.own[i] && !report.own[i]->finding.agrees; });
        if (isBehind && (isRight || !isTold)) verdict.standing = Standing::GivenInput;
        isBehind = true;
    }
}

// A light's frame and extent are everybody's own: a shadow buffer is compared if its frame is found.
void leaveOutShadowBuffers(const Reference& reference, HandedIn& in) {
    std::erase_if(in.files, [&](const HandedFile& file) {
        if (file.name.buffer.id != BufferId::ShadowBuffer) return false;
        const Values& right = reference.values.at(file.name.buffer.text());
        if (inFrameOf(file.numbers, right, reference.context.ofShadowBuffers)) return false;
        in.others.push_back(
            fmt::format("{} is not compared: no frame of the light was found in which it is the reference's. Hand in "
                        "shadow.{}, which does not depend on the frame",
                        inQuotes(file.fileName()), file.name.buffer.light));
        return true;
    });
}

// What the stages have done, by the findings.
void judgeAll(Report& report) {
    report.standings.clear(), report.broken.clear();
    for (std::size_t i = 0; i < kStageCount; ++i) report.stages[i] = {kStages[i], Standing::NoFile, {}, {}};
    for (std::size_t i = 0; i < report.findings.size(); ++i)
        report.stages[index(report.findings[i].stage)].findings.push_back(i);
    const Stop& stop = report.options.stop;
    report.own = compareOwn(report.conventions, report.findings, *report.reference, stop);
    judgeStages(report);
    if (!report.agrees()) report.broken = brokenContracts(report.conventions, *report.reference, stop);
}

FirstWrong firstWrongOf(const Report& report) {
    FirstWrong out;
    out.possible = report.possiblyWrong;
    for (std::size_t i = 0; i < report.findings.size(); ++i) {
        const bool here = report.standings[i] == Standing::WrongHere;
        if (here && !out.certain) out.certain = report.findings[i].stage;
        const bool also = out.certain == report.findings[i].stage && *out.certain != StageId::Shading;
        if (here || (also && !report.findings[i].agrees)) out.wrongHere.push_back(i);
    }
    return out;
}

// What the depths tell where nothing else is certain.
std::vector<StageId> toldByDepths(const Report& report) {
    const auto depths = std::ranges::find_if(
        report.findings, [](const Finding& f) { return f.name.buffer.id == BufferId::ZView && !f.agrees; });
    const auto stated = readStated(report.in->conventions, report.in->conventionsName);
    if (depths == report.findings.end() || !stated) return {};
    const ReadFile& file = report.fileOf(*depths);
    const ReadingContext& context = report.conventions.context;
    return stagesOfDepths(file, allowedReadings(*file.file, context, *stated), context, *report.reference);
}

void nameFirstWrong(Report& report) {
    using enum StageId;
    const auto only = [&](std::vector<StageId> stages, bool isCertain = false) {
        report.possiblyWrong = std::move(stages), report.isCertain = isCertain;
        if (report.possiblyWrong.size() == 1) report.firstWrong = report.possiblyWrong[0];
    };
    report.firstWrong.reset(), report.possiblyWrong.clear(), report.isCertain = false;
    if (report.agrees()) return;
    // A picture that tells nothing accuses nobody.
    if (report.evidence.isEmpty && std::ranges::all_of(report.findings, [](const Finding& f) {
            return f.agrees || f.name.buffer.id == BufferId::Color;
        }))
        return;
    for (const StageId stage : kStages)
        if (report.stages[index(stage)].standing == Standing::WrongHere) return only({stage}, true);
    if (report.suspects && !report.suspects->candidates.empty()) {
        std::vector<StageId> stages;
        for (const StageId stage : kStages)
            if (std::ranges::any_of(report.suspects->candidates,
                                    [&](const Candidate& c) { return c.error.stage == stage; }))
                stages.push_back(stage);
        if (report.suspects->areTogether && stages.size() > 1) stages.resize(1);
        if (stages.size() > 1)
            if (const auto told = toldByDepths(report); std::ranges::includes(stages, told) && !told.empty())
                stages = told;
        return only(std::move(stages));
    }
    for (const StageId stage : {Transform, Cull, Normals, ShadowBuffer})
        if (differs(report, stage) && !leadsToTheSame(report, stage)) return only({stage});
    if (!differs(report, ZBuffer) && !differs(report, Shading))  // one of these tables alone
        return only({differs(report, Transform) ? Transform : Cull});
    if (differs(report, ZBuffer)) {
        auto told = toldByDepths(report);
        return only(told.empty() ? std::vector{Transform, Cull, ZBuffer} : std::move(told));
    }
    const auto ofNormals =
        std::ranges::find_if(report.findings, [](const Finding& f) { return f.name.buffer.id == BufferId::Normal; });
    const bool isThere = ofNormals != report.findings.end();
    if (seesTheSame(report) || isThere)
        only(isThere && ofNormals->agrees ? std::vector{Shading} : std::vector{Normals, Shading});
}

}  // namespace

bool Report::agrees() const { return std::ranges::all_of(findings, &Finding::agrees); }
bool Report::conventionsDiffer() const {
    return std::ranges::any_of(conventions.said, [](const Convention& said) { return !said.own; });
}

const Finding* Report::firstDifference() const {
    for (std::size_t i = 0; i < findings.size(); ++i)
        if (isCertain && firstWrong == findings[i].stage && standings[i] == Standing::WrongHere) return &findings[i];
    for (const bool isAccused : {true, false})
        for (const Finding& finding : findings)
            if (!finding.agrees && leadsToTheSame(*this, finding.stage) != isAccused) return &finding;
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

Result<Report> compareRenderer(const Scene& scene, std::shared_ptr<const Reference> reference, HandedIn in,
                               const std::string& given, const CompareOptions& options) {
    Report out;
    out.options = options, out.given = given;
    out.scene = std::make_shared<const Scene>(scene);
    out.reference = std::move(reference);
    std::erase_if(in.files,
                  [&](const HandedFile& file) { return bufferInfo(file.name.buffer.id).stage > options.until; });
    auto stated = readStated(in.conventions, in.conventionsName);
    if (!stated) return stated.errors();
    leaveOutShadowBuffers(*out.reference, in);
    out.evidence = weigh(in, *out.reference);
    out.in = std::make_shared<const HandedIn>(std::move(in));
    if (out.in->files.empty()) {
        if (!out.in->errors.empty()) return out.in->errors;
        std::string others;
        for (const std::string& other : out.in->others) others += (others.empty() ? "; " : ", ") + other;
        return Error{{given},
                     "no file here has a known name" + others,
                     "color.png, depth.npy, normal.npy, … (shadescope compare --starter python -o mine writes what to "
                     "hand in)"};
    }
    if (!readFiles(out, *stated) || !settleSamples(out, *stated)) return Error{{}, "cancelled", {}};
    settleFlags(out);
    judgeAll(out);
    nameFirstWrong(out);
    if (options.known && !nameKnownErrors(out)) return Error{{}, "cancelled", {}};
    return out;
}

namespace {

std::vector<KnownError> errorsToTry(const Report& report) {
    std::vector<KnownError> errors = knownErrors(*report.scene);
    const auto& without = report.options.without;
    std::erase_if(errors,
                  [&](const KnownError& error) { return std::ranges::find(without, error.id) != without.end(); });
    return errors;
}
HypothesisProgress progressOf(const Report& report) {
    return [&report](std::size_t done, std::size_t all) {
        if (report.options.progress) report.options.progress("known errors", done, all);
    };
}

}  // namespace

std::optional<MeasuredErrors> measureKnownErrors(const Report& report, std::size_t part, std::size_t parts) {
    if (report.agrees() || report.evidence.isEmpty) return MeasuredErrors();
    const AnyExponent any;
    const auto stated = readStated(report.in->conventions, report.in->conventionsName);
    return measureErrors(*report.scene, errorsToTry(report), *report.reference, report.conventions, *stated, part,
                         parts, report.options.stop, progressOf(report));
}

bool nameKnownErrors(Report& report) { return nameKnownErrors(report, {}); }

bool nameKnownErrors(Report& report, const MeasuredErrors& given) {
    if (report.agrees() || report.evidence.isEmpty) return true;
    const AnyExponent any;
    const auto stated = readStated(report.in->conventions, report.in->conventionsName);
    report.suspects =
        findSuspects(*report.scene, errorsToTry(report), *report.reference, report.conventions, *stated,
                     report.findings, firstWrongOf(report), report.options.stop, progressOf(report), given);
    if (report.suspects->stopped) return false;
    // The files as they are read if that is the error, for all that follows.
    if (!report.suspects->candidates.empty()) {
        if (!readAs(report, *stated, report.suspects->candidates[0].misfit)) return false;
        settleFlags(report);
        judgeAll(report);
    }
    nameFirstWrong(report);
    return true;
}

}  // namespace pipeline::foreign
