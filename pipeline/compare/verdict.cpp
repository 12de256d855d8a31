#include "pipeline/compare/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/compare/shadow_frame.h"
#include "pipeline/core/text.h"

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
        if (differs(report, verdict.stage)) right[index(verdict.stage)] = false;
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
    bool allRight = true, badInput = false;
    for (const StageId input : inputsOf(finding)) {
        allRight = allRight && right[index(input)];
        badInput = badInput || differs(report, input);
    }
    if (report.own[i] && !report.own[i]->finding.agrees) {
        // What else it got may be wrong where it was not handed in.
        const bool partly = !allRight && !badInput && finding.stage == StageId::Shading;
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

// 1 may stand for dropped polygons, or front and back are exchanged: what is drawn of them tells. Where nothing does, both
// are said.
void settleFlags(Report& report) {
    for (std::size_t i = 0; i < report.findings.size(); ++i) {
        ReadFile& file = report.conventions.files[i];
        if (file.file->name.buffer.id != BufferId::PolygonsVerdict || report.findings[i].agrees) continue;
        const bool isFlags = std::ranges::all_of(file.file->numbers.values, [](double v) { return v == 0 || v == 1; });
        if (!isFlags) continue;
        ReadFile turned = file;
        turned.reading.coding = file.file->name.form == Form::Visible ? Coding::DroppedIsOne : Coding::Flags;
        turned.mine = read(*file.file, turned.reading, report.conventions.context,
                           report.reference->values.at(file.file->name.buffer.text()));
        const Finding finding = compareValues(turned, *report.reference);
        if (!finding.agrees) continue;
        bool drawn = false, right = true;
        for (const Finding& later : report.findings)
            if (later.stage > StageId::Normals) drawn = true, right = right && later.agrees;
        const CodingInfo& info = codingInfo(turned.reading.coding);
        Convention said{file.file->name.text(), std::string(info.words), std::string(info.key),
                        std::string(info.value)};
        if (drawn && right) {
            report.conventions.said.push_back(said);
            file = turned, report.findings[i] = finding;
        } else if (!drawn) {
            said.words += "; or front and back are exchanged";
            said.certainty = Certainty::CannotTell, said.own = true;
            report.conventions.said.push_back(said);
        }
    }
}

// What a reading explains wholly is no error, however close the one that was taken came. Colours of a gamma are one, and
// of flags what is drawn decides.
// isUp: of vertices in the picture, whether y may run upwards.
void settleCoding(const StatedConventions& stated, const Reference& reference, Conventions& conventions, ReadFile& file,
                  Finding& finding, bool isUp = false) {
    std::vector<Reading> readings = readingsOf(*file.file, conventions.context);
    if (isUp) readings.push_back({false, false, false, Coding::FromTheFoot});
    const StatedConventions ofFile = stated.of(*file.file);
    const bool isOpen = file.file->name.buffer.id != BufferId::PolygonsVerdict;
    if (!isOpen || ofFile.states(*file.file, conventions.context)) return;
    for (const Reading& reading : readings) {
        Reading wanted = file.reading;
        wanted.coding = reading.coding;
        if (reading != wanted || reading == file.reading || reading.coding == Coding::Gamma22) continue;
        ReadFile other{
            file.file, reading,
            read(*file.file, reading, conventions.context, reference.values.at(file.file->name.buffer.text())),
            file.others};
        Finding found = compareValues(other, reference);
        if (!found.agrees) continue;
        const std::string name = file.file->name.text();
        const std::string key(codingInfo(file.reading.coding).key);
        std::erase_if(conventions.said, [&](const Convention& c) { return c.buffer == name && c.key == key; });
        const CodingInfo& info = codingInfo(reading.coding);
        if (reading.coding != Coding::AsIs)
            conventions.said.push_back({name, std::string(info.words), std::string(info.key), std::string(info.value),
                                        Certainty::Clear,
                                        double(finding.bad()) / double(std::max<std::size_t>(1, found.bad()))});
        file = std::move(other), finding = std::move(found);
        return;
    }
}

// Their files beside the reference. False where it was stopped.
bool readFiles(Report& report, const StatedConventions& stated) {
    const Reference& reference = *report.reference;
    report.conventions = findConventions(*report.in, reference.values, reference.context, reference.tolerances, stated);
    report.findings.clear();
    for (ReadFile& file : report.conventions.files) {
        if (report.options.stop.stop_requested()) return false;
        report.findings.push_back(compareValues(file, reference));
        Finding& finding = report.findings.back();
        if (!finding.agrees) settleCoding(stated, reference, report.conventions, file, finding);
    }
    // Where what is drawn of them differs, half a pixel of the vertices is the error.
    const bool drawnOtherwise = std::ranges::any_of(report.findings, [](const Finding& f) {
        const bool tells = f.stage == StageId::ZBuffer || f.name.buffer.id == BufferId::Color;
        return f.isPicture() && tells && !f.agrees;
    });
    for (std::size_t i = 0; i < report.findings.size() && drawnOtherwise; ++i) {
        ReadFile& file = report.conventions.files[i];
        const bool isWhole = file.reading.coding == Coding::PixelFromCentre;
        if (!isWhole || stated.of(*file.file).codings.contains("screen")) continue;
        file.reading.coding = Coding::AsIs;
        file.mine = read(*file.file, file.reading, report.conventions.context, reference.values.at("vertices.screen"));
        report.findings[i] = compareValues(file, reference);
        std::erase_if(report.conventions.said, [&](const Convention& c) { return c.buffer == file.file->name.text(); });
    }
    // A program whose rows run upwards has y in the picture upwards too. If it culls otherwise than the reference does, y
    // is the error.
    bool isUp = false, culls = true;
    for (const Finding& finding : report.findings) {
        isUp = isUp || (finding.isPicture() && finding.agrees && finding.reading.bottomUp);
        culls = culls && (finding.agrees || finding.name.buffer.id != BufferId::PolygonsVerdict);
    }
    for (std::size_t i = 0; i < report.findings.size() && isUp && culls; ++i)
        if (!report.findings[i].agrees && report.findings[i].name.buffer.id == BufferId::VerticesScreen)
            settleCoding(stated, reference, report.conventions, report.conventions.files[i], report.findings[i], true);
    return true;
}

// Pixels that are wrong, and those of them next to another polygon: there alone it shows where a pixel is sampled.
struct WrongPixels {
    std::size_t all = 0, atOutlines = 0;
    bool differ = false;
};
WrongPixels wrongPixels(const Report& report, const std::vector<std::uint8_t>& outline) {
    WrongPixels out;
    for (const Finding& finding : report.findings) {
        if (!finding.isPicture()) continue;
        out.differ = out.differ || !finding.agrees;
        for (std::size_t i = 0; i < finding.classes.size(); ++i) {
            const Class of = finding.classes[i];
            if (of != Class::Wrong && of != Class::Missing && of != Class::Extra) continue;
            ++out.all, out.atOutlines += outline[i];
        }
    }
    return out;
}

// Pixels may be sampled at their corner: the first of their rows and columns. Taken where it explains the outlines.
bool settleSamples(Report& report, const StatedConventions& stated) {
    constexpr double kFewer = 3;  // times as few wrong pixels at outlines
    constexpr std::size_t kFewest = 12;
    const auto reference = report.reference;
    if (reference->outline.empty()) return true;
    const WrongPixels atCentre = wrongPixels(report, reference->outline);
    if (!stated.atCorner() && (!atCentre.differ || atCentre.atOutlines < kFewest)) return true;
    const auto bottomUp =
        std::ranges::count_if(report.conventions.files, [](const ReadFile& file) { return file.reading.bottomUp; });
    const auto corner = bottomUp > 0 ? PixelCorner::LowerLeft : PixelCorner::UpperLeft;
    auto other = makeReference(*report.scene, report.options.tolerances, report.options.stop, corner);
    if (!other) return false;
    Report moved = report;
    moved.reference = std::make_shared<const Reference>(std::move(*other));
    if (!readFiles(moved, stated)) return false;
    const WrongPixels atCorner = wrongPixels(moved, reference->outline);
    const bool explains = !atCorner.differ || (double(atCorner.atOutlines) * kFewer <= double(atCentre.atOutlines) &&
                                               atCorner.all < atCentre.all);
    if (!stated.atCorner() && !explains) return true;
    report = std::move(moved);
    const CodingInfo& info = codingInfo(Coding::Corner);
    report.conventions.said.push_back(
        {"pictures", std::string(info.words), std::string(info.key), std::string(info.value),
         stated.atCorner() ? Certainty::Stated : Certainty::Clear,
         double(atCentre.atOutlines) / double(std::max<std::size_t>(1, atCorner.atOutlines))});
    return true;
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
                        inQuotes(file.path.filename().string()), file.name.buffer.light));
        return true;
    });
}

FirstWrong firstWrongOf(const Report& report) {
    FirstWrong out;
    for (std::size_t i = 0; i < report.findings.size(); ++i) {
        const bool here = report.standings[i] == Standing::WrongHere;
        if (here && !out.stage) out.stage = report.findings[i].stage;
        const bool also = out.stage == report.findings[i].stage && *out.stage != StageId::Shading;
        if (here || (also && !report.findings[i].agrees)) out.wrongHere.push_back(i);
    }
    return out;
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

bool Report::agrees() const { return std::ranges::all_of(findings, &Finding::agrees); }
bool Report::conventionsDiffer() const {
    return std::ranges::any_of(conventions.said, [](const Convention& said) { return !said.own; });
}

const Finding* Report::firstDifference() const {
    for (std::size_t i = 0; i < findings.size(); ++i)
        if (isCertain && firstWrong == findings[i].stage && standings[i] == Standing::WrongHere) return &findings[i];
    const auto first = std::ranges::find(findings, false, &Finding::agrees);
    return first == findings.end() ? nullptr : &*first;
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
    std::string given;
    for (const std::string& path : paths) given += (given.empty() ? "" : " ") + path;
    auto reference = makeReference(scene, options.tolerances, options.stop);
    if (!reference) return Error{{}, "cancelled", {}};
    HandedIn in = readHandedIn(paths, *reference->frame, options.stop);
    return compareRenderer(scene, std::make_shared<const Reference>(std::move(*reference)), std::move(in), given,
                           options);
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
    for (std::size_t i = 0; i < kStageCount; ++i) out.stages[i].stage = kStages[i];
    if (!readFiles(out, *stated) || !settleSamples(out, *stated)) return Error{{}, "cancelled", {}};
    for (std::size_t i = 0; i < out.findings.size(); ++i)
        out.stages[index(out.findings[i].stage)].findings.push_back(i);
    settleFlags(out);
    out.own = compareOwn(out.conventions, out.findings, *out.reference, options.stop);
    judgeStages(out);
    if (!out.agrees()) out.broken = brokenContracts(out.conventions, *out.reference, options.stop);
    if (options.known && !out.agrees()) {
        const HypothesisProgress progress = [&](std::size_t done, std::size_t all) {
            if (options.progress) options.progress("known errors", done, all);
        };
        out.suspects = findSuspects(scene, *out.reference, out.conventions, out.findings, firstWrongOf(out),
                                    options.stop, progress);
        if (out.suspects->stopped) return Error{{}, "cancelled", {}};
    }
    nameFirstWrong(out);
    return out;
}

}  // namespace pipeline::foreign
