#include "pipeline/compare/handed_in/settle_readings.h"

#include <algorithm>

namespace pipeline::foreign {

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
        // Depths and ids tell which polygons are drawn; the picture only where it has no error of its own.
        bool drawn = false, right = true;
        for (const Finding& later : report.findings)
            if (later.stage == StageId::ZBuffer) drawn = true, right = right && later.agrees;
        for (const Finding& later : report.findings)
            if (later.stage == StageId::Shading && !drawn && later.agrees) drawn = true;
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

namespace {

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
        const auto towards = pointsTowards(reading.coding);
        if (towards && conventions.towardsViewer && towards != conventions.towardsViewer) continue;
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
bool readFilesAs(Report& report, const StatedConventions& stated, Together together) {
    const Reference& reference = *report.reference;
    report.conventions =
        findConventions(*report.in, reference.values, reference.context, reference.tolerances, stated, together);
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

}  // namespace

bool readFiles(Report& report, const StatedConventions& stated) {
    if (!readFilesAs(report, stated, Together::No)) return false;
    // What differs may be turned round to fit: then the folder has one order of rows and columns.
    const ReadFile* first = nullptr;
    bool isMixed = false;
    for (const ReadFile& file : report.conventions.files) {
        if (bufferInfo(file.file->name.buffer.id).domain != Domain::Pixel) continue;
        if (!first) first = &file;
        isMixed = isMixed || first->reading.bottomUp != file.reading.bottomUp ||
                  first->reading.mirrored != file.reading.mirrored;
    }
    return !isMixed || report.agrees() || readFilesAs(report, stated, Together::Yes);
}

namespace {

// Pixels that are wrong, and those of them next to another polygon: there alone it shows where a pixel is sampled.
struct WrongPixels {
    std::size_t all = 0, atOutlines = 0;
    bool differ = false;
};
WrongPixels wrongPixels(const Finding& finding, const std::vector<std::uint8_t>& outline) {
    WrongPixels out;
    if (!finding.isPicture()) return out;
    out.differ = !finding.agrees;
    for (std::size_t i = 0; i < finding.classes.size(); ++i)
        if (isBad(finding.classes[i])) ++out.all, out.atOutlines += outline[i];
    return out;
}
WrongPixels wrongPixels(const std::vector<Finding>& findings, const std::vector<std::uint8_t>& outline) {
    WrongPixels sum;
    for (const Finding& finding : findings) {
        const WrongPixels one = wrongPixels(finding, outline);
        sum.all += one.all, sum.atOutlines += one.atOutlines, sum.differ = sum.differ || one.differ;
    }
    return sum;
}

// A file, as it is read, beside another reference that has its buffer.
Finding againstReference(const ReadFile& file, const Conventions& conventions, const Reference& reference) {
    const Values& right = reference.values.at(file.file->name.buffer.text());
    ReadingContext context = reference.context;
    context.background = conventions.context.background;
    return compareValues({file.file, file.reading, read(*file.file, file.reading, context, right)}, right, reference);
}

}  // namespace

bool settleSamples(Report& report, const StatedConventions& stated) {
    constexpr double kFewer = 3;                           // times as few wrong pixels at outlines
    constexpr std::size_t kFewest = 12, kLeastShare = 10;  // of those wrong one in so many is at an outline
    const auto reference = report.reference;
    if (reference->outline.empty()) return true;
    const WrongPixels atCentre = wrongPixels(report.findings, reference->outline);
    if (!stated.atCorner() && (!atCentre.differ || atCentre.atOutlines < kFewest)) return true;
    if (!stated.atCorner() && kLeastShare * atCentre.atOutlines < atCentre.all) return true;  // another error
    const auto bottomUp =
        std::ranges::count_if(report.conventions.files, [](const ReadFile& file) { return file.reading.bottomUp; });
    const auto corner = bottomUp > 0 ? PixelCorner::LowerLeft : PixelCorner::UpperLeft;
    const Stop& stop = report.options.stop;
    // Before all is read anew: whether it can be, by the picture that has the most wrong pixels there. A frame with the
    // buffers of all files would be as large as the reference.
    if (!stated.atCorner()) {
        const auto most = std::ranges::max_element(report.findings, {}, [&](const Finding& finding) {
            return wrongPixels(finding, reference->outline).atOutlines;
        });
        const auto handedIn = BufferSet().set(index(most->name.buffer.id));
        const auto other = makeHypothesis(*report.scene, *reference, handedIn, corner, {}, stop);
        if (!other) return false;
        const Finding moved = againstReference(report.fileOf(*most), report.conventions, *other);
        if (!moved.agrees &&
            wrongPixels(moved, reference->outline).atOutlines > wrongPixels(*most, reference->outline).atOutlines)
            return true;
    }
    auto other = makeReference(*report.scene, report.options.tolerances, stop, corner);
    if (!other) return false;
    Report moved = report;
    moved.reference = std::make_shared<const Reference>(std::move(*other));
    if (!readFiles(moved, stated)) return false;
    const WrongPixels atCorner = wrongPixels(moved.findings, reference->outline);
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

namespace {

// The key that a file's codings have in mine.toml: "depth".
std::string keyOf(const HandedFile& file, const ReadingContext& context) {
    for (const Reading& reading : readingsOf(file, context))
        if (const std::string_view key = codingInfo(reading.coding).key; !key.empty()) return std::string(key);
    return {};
}

}  // namespace

bool readAs(Report& report, const StatedConventions& stated, const Misfit& misfit) {
    StatedConventions named = stated;
    bool isOther = false;
    for (std::size_t i = 0; i < report.conventions.files.size(); ++i) {
        const ReadFile& file = report.conventions.files[i];
        const Reading& wanted = misfit.readings[i];
        if (wanted == file.reading) continue;
        isOther = true;
        StatedConventions& own = named.files[file.file->name.buffer.text()];
        if (bufferInfo(file.file->name.buffer.id).domain == Domain::Pixel) {
            own.bottomUp = wanted.bottomUp, own.mirrored = wanted.mirrored;
            if (file.file->name.buffer.id == BufferId::Color) own.bgr = wanted.bgr;
        }
        if (const std::string key = keyOf(*file.file, report.conventions.context); !key.empty())
            own.codings[key] = wanted.coding;
    }
    if (!isOther) return true;
    if (!readFilesAs(report, named, Together::No)) return false;
    for (Convention& said : report.conventions.said) {
        if (said.certainty != Certainty::Stated) continue;
        const auto file = std::ranges::find_if(report.conventions.files,
                                               [&](const ReadFile& f) { return f.file->name.text() == said.buffer; });
        if (file == report.conventions.files.end()) continue;
        const StatedConventions theirs = stated.of(*file->file);
        const bool isTheirs = said.key == "rows"       ? theirs.bottomUp.has_value()
                              : said.key == "columns"  ? theirs.mirrored.has_value()
                              : said.key == "channels" ? theirs.bgr.has_value()
                                                       : theirs.codings.contains(said.key);
        if (!isTheirs) said.certainty = Certainty::Explains;
    }
    std::erase_if(report.conventions.said,
                  [](const Convention& c) { return c.own && c.certainty == Certainty::Explains; });
    return true;
}

}  // namespace pipeline::foreign
