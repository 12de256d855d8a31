#include "app/web/core/core.h"
#include "app/web/core/progress.h"
#include "pipeline/compare/compare_options.h"
#include "pipeline/compare/handed_in/convention_choices.h"
#include "pipeline/compare/measured_errors.h"
#include "pipeline/compare/report/compare_html.h"
#include "pipeline/compare/report/compare_text.h"
#include "pipeline/compare/report/worst_pixels.h"
#include "pipeline/core/printable.h"

// Somebody else's renderer: its files, the verdict, pictures of it.

namespace pipeline {

Result<NumberFile> readExrNumbers(std::string_view, const std::string& name, std::size_t) {
    return wrongAt(name, 0, "an OpenEXR file", "npy or pfm: only the installed program reads it");
}
Result<NumberFile> readExrNumbers(std::string_view bytes, const std::string& name, std::size_t most,
                                  const std::string&) {
    return readExrNumbers(bytes, name, most);
}
// None: the whole file is refused.
std::vector<std::string> exrLayers(std::string_view) { return {}; }

}  // namespace pipeline

namespace web {

namespace {

namespace foreign = pipeline::foreign;

struct Handed {
    std::string path, bytes;
    bool asked = false;
};
struct Renderer {
    std::vector<Handed> files;  // in the order in which they were handed in
    pipeline::Errors errors;    // of paths at which there is nothing
    std::shared_ptr<const foreign::Reference> reference;
    std::shared_ptr<const pipeline::Scene> referenceOf;
    std::map<std::string, double> tolerances;  // of the reference
    foreign::CompareOptions options;
    foreign::StatedByHand stated;  // beside mine.toml, and before it
    std::optional<foreign::Report> report;
    foreign::MeasuredErrors measured;  // by other workers, for this report
};
Renderer s_renderer;
std::vector<std::uint8_t> s_rgba;

const foreign::Finding* findingNamed(std::string_view name) {
    if (s_renderer.report)
        for (const foreign::Finding& finding : s_renderer.report->findings)
            if (finding.name.text() == name) return &finding;
    return nullptr;
}

int giveReport() {
    return giveText(pipeline::escapedLines(reportJson(*s_renderer.report, exitStatus(*s_renderer.report)).dump(2)));
}

Json misfitJson(std::size_t number, const foreign::Misfit& misfit) {
    Json readings = Json::array();
    for (const foreign::Reading& one : misfit.readings)
        readings.push_back({one.bottomUp, one.mirrored, one.bgr, int(one.coding)});
    return {{"error", number},
            {"geometry", {misfit.geometry.bottomUp, misfit.geometry.mirrored}},
            {"readings", readings},
            {"wrong", misfit.wrong},
            {"drawn", misfit.drawn}};
}
// From another worker of the same page.
foreign::Misfit misfitFrom(const Json& json) {
    const auto isSet = [](const Json& flag) { return flag == Json(true); };
    const Json &geometry = json["geometry"], &readings = json["readings"];
    foreign::Misfit misfit;
    misfit.geometry = {isSet(geometry[0]), isSet(geometry[1])}, misfit.drawn = json["drawn"].get<std::size_t>();
    for (const Json& one : readings)
        misfit.readings.push_back(
            {isSet(one[0]), isSet(one[1]), isSet(one[2]), foreign::Coding(one[3].get<long long>())});
    for (const Json& wrong : json["wrong"]) misfit.wrong.push_back(wrong.get<double>());
    return misfit;
}

// What is wrong with the options, or empty.
std::string readOptions(const Json& json, foreign::CompareOptions& options) {
    if (const Json* hints = json.find("hints"); hints && hints->is(Json::kWhole))
        options.hints = int(hints->get<long long>());
    options.known = json["known"] != Json(false) && options.hints >= 3;
    options.strict = json["strict"] == Json(true);
    for (const Json& text : json["tolerance"])
        if (const auto wrong = foreign::readTolerance(text.text(), options.tolerances)) return *wrong;
    if (const std::string stage = json["stage"].text(); !stage.empty())
        if (const auto wrong = foreign::readUntil(stage, options.until)) return *wrong;
    options.progress = [](std::string_view what, std::size_t done, std::size_t all) {
        tellProgress(what.data(), int(what.size()), int(done), int(all));
    };
    return {};
}

}  // namespace

// A file of the renderer; the core keeps a copy until take_back(). asked: it was named by itself, not its folder.
WEB_CALL(hand) int webHand(const char* path, int pathSize, const char* bytes, int size, int asked) {
    s_renderer.files.push_back({std::string(textAt(path, pathSize)), std::string(textAt(bytes, size)), asked != 0});
    return give(true);
}
// A path that was named, at which there is nothing.
WEB_CALL(hand_nothing) int webHandNothing(const char* path, int size) {
    s_renderer.errors.push_back(foreign::noSuchFile(std::string(textAt(path, size))));
    return give(true);
}
WEB_CALL(take_back) int webTakeBack() {
    s_renderer.files.clear(), s_renderer.errors.clear(), s_renderer.report.reset(), s_renderer.measured.clear();
    return give(true);
}

// How verdict() compares: {"known", "hints", "strict", "tolerance": ["color=2"], "stage"}, as the command takes them, and
// "stated": {"rows": "bottom-up"}, conventions that count before those of mine.toml.
WEB_CALL(verdict_options) int webVerdictOptions(const char* text, int size) {
    foreign::CompareOptions options;
    const Json json = Json::read(textAt(text, size)).value_or(Json());
    const std::string wrong = readOptions(json, options);
    if (!wrong.empty()) return refuse(wrong);
    s_renderer.options = std::move(options), s_renderer.stated.clear();
    for (const Json::Item& one : json["stated"].items()) s_renderer.stated[one.key] = one.value.text();
    return give(true);
}

// The scene beside what was handed in: what `shadescope compare --json` prints, byte for byte. given: the folder, for
// messages.
WEB_CALL(verdict) int webVerdict(const char* given, int givenSize) {
    const auto& scene = core().own.scene;
    const foreign::CompareOptions& asked = s_renderer.options;
    if (!scene) return refuse("no scene is open");
    if (s_renderer.referenceOf != scene || s_renderer.tolerances != asked.tolerances) {
        auto reference = foreign::makeReference(*scene, asked.tolerances, {});
        s_renderer.reference = std::make_shared<const foreign::Reference>(std::move(*reference));
        s_renderer.referenceOf = scene, s_renderer.tolerances = asked.tolerances;
    }
    std::vector<foreign::OfferedFile> offered;
    for (const Handed& file : s_renderer.files)
        offered.push_back({file.path, file.asked, [&file](std::size_t most) -> pipeline::Result<std::string> {
                               if (file.bytes.size() > most)
                                   return pipeline::Error{{file.path}, "the file is too large", {}};
                               return file.bytes;
                           }});
    foreign::HandedIn in = takeHandedIn(offered, *s_renderer.reference->frame, {});
    if (!s_renderer.stated.empty()) in.conventions = foreign::withStated(in.conventions, s_renderer.stated);
    in.errors.insert(in.errors.begin(), s_renderer.errors.begin(), s_renderer.errors.end());
    auto report =
        compareRenderer(*scene, s_renderer.reference, std::move(in), std::string(textAt(given, givenSize)), asked);
    s_renderer.report.reset(), s_renderer.measured.clear();
    if (!report) return refuse(report.errors());
    s_renderer.report = std::move(report).value();
    return giveReport();
}

// Measures the known errors whose numbers leave `part`, divided by `parts`: what one of several workers does.
WEB_CALL(names_part) int webNamesPart(int part, int parts) {
    if (!s_renderer.report) return refuse("nothing was compared");
    const auto measured = measureKnownErrors(*s_renderer.report, std::size_t(part), std::size_t(parts));
    Json list = Json::array();
    for (const auto& [number, misfit] : *measured) list.push_back(misfitJson(number, misfit));
    return give(list);
}
// Takes over what another worker has measured.
WEB_CALL(names_given) int webNamesGiven(const char* text, int size) {
    const Json list = Json::read(textAt(text, size)).value_or(Json());
    for (const Json& one : list) s_renderer.measured[one["error"].get<std::size_t>()] = misfitFrom(one);
    return give(true);
}

// Tries the known errors, which verdict() was told to leave and nobody has measured, and gives the same anew.
WEB_CALL(verdict_names) int webVerdictNames() {
    if (!s_renderer.report) return refuse("nothing was compared");
    s_renderer.report->options.known = true;
    nameKnownErrors(*s_renderer.report, s_renderer.measured);
    return giveReport();
}

// The same for people, as the terminal shows it: [{"text", "bold"}].
WEB_CALL(verdict_text) int webVerdictText(int columns) {
    if (!s_renderer.report) return refuse("nothing was compared");
    Json lines = Json::array();
    for (const foreign::TextLine& line : reportText(*s_renderer.report, false, std::size_t(columns)))
        lines.push_back({{"text", line.text}, {"bold", line.bold}});
    return give(lines);
}

// The page that `-o report.html` writes. command: what is named in it.
WEB_CALL(verdict_html) int webVerdictHtml(const char* command, int size) {
    if (!s_renderer.report) return refuse("nothing was compared");
    return giveText(reportHtml(*s_renderer.report, std::string(textAt(command, size))));
}

// The buffer in which the error shows first, and its pixels to look at.
WEB_CALL(verdict_worst) int webVerdictWorst() {
    if (!s_renderer.report) return refuse("nothing was compared");
    const foreign::Finding* const picture = firstWrongPicture(*s_renderer.report);
    Json pixels = Json::array();
    for (const glm::ivec2 pixel : worstPixels(*s_renderer.report)) pixels.push_back({pixel.x, pixel.y});
    return give({{"buffer", picture ? Json(picture->name.text()) : Json()}, {"pixels", pixels}});
}

// RGBA of a buffer that was compared. kind: 0 mine, 1 the reference, 2 the difference, 3 classes.
WEB_CALL(verdict_picture) int webVerdictPicture(const char* name, int size, int kind) {
    const foreign::Finding* const finding = findingNamed(textAt(name, size));
    if (!finding || !finding->isPicture()) return refuse("no picture was compared that is called so");
    const foreign::PicturePair pair = picturesOf(*s_renderer.report, *finding);
    const auto picture = kind == 0   ? pair.mine
                         : kind == 1 ? pair.reference
                         : kind == 2 ? differencePicture(*s_renderer.report, *finding)
                                     : classPicture(*finding, pair.reference);
    s_rgba.clear();
    for (const pipeline::Color8 c : picture.pixels) s_rgba.insert(s_rgba.end(), {c[0], c[1], c[2], 255});
    return give({{"pixels", std::uintptr_t(s_rgba.data())}, {"width", picture.size.x}, {"height", picture.size.y}});
}

// Every number of a pixel, of both renderers, in the order of the stages.
WEB_CALL(verdict_pixel) int webVerdictPixel(int x, int y) {
    if (!s_renderer.report) return refuse("nothing was compared");
    const foreign::Report& report = *s_renderer.report;
    Json rows = Json::array();
    for (const foreign::Finding& finding : report.findings) {
        if (!finding.isPicture()) continue;
        const std::size_t i = std::size_t(y) * finding.columns + std::size_t(x);
        if (x < 0 || y < 0 || std::size_t(x) >= finding.columns || i >= finding.classes.size())
            return refuse("no such pixel");
        const foreign::Values& right = report.reference->values.at(finding.name.buffer.text());
        rows.push_back({{"buffer", finding.name.text()},
                        {"mine", mineText(report, finding, i)},
                        {"reference", valueText(finding, right, i)},
                        {"class", name(finding.classes[i])},
                        {"bad", isBad(finding.classes[i])}});
    }
    return give(rows);
}

}  // namespace web
