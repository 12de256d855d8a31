#include "lessons/live_page.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "lessons/expression/value.h"
#include "lessons/handout.h"
#include "lessons/lesson_text.h"
#include "lessons/library.h"
#include "lessons/live_text.h"
#include "lessons/misconceptions.h"
#include "lessons/page_parts.h"
#include "lessons/prose_html.h"
#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/file_hash.h"
#include "pipeline/export/html_text.h"
#include "pipeline/export/json_value.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/toml_writer.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/key_places.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::Errors;
using pipeline::Json;
using pipeline::Result;
namespace fs = std::filesystem;

constexpr std::string_view kCoreName = "shadescope_core.wasm.gz";

// JSON for a data block: no "<" in it begins or ends an element or a comment.
std::string blockText(const Json& json) {
    std::string text = json.dump(), out;
    for (const char c : text) {
        if (c == '<')
            out += "\\u003c";
        else
            out += c;
    }
    return out;
}

// The rows of the table that the lesson names; their sources stay in the program.
std::string misconceptionRows(std::string_view lesson) {
    std::string text = "| id | name | stage | defect | source |\n|---|---|---|---|---|\n";
    for (const Misconception& row : misconceptions().rows)
        if (lesson.find(row.id) != lesson.npos)
            text += fmt::format("| {} | {} | {} |  |  |\n", row.id, row.name, row.stage);
    return text;
}

std::string indexLink(const std::string& file) {
    return file.empty() ? file
                        : fmt::format("<nav aria-label=\"Site\"><a href=\"{}\">All pages</a></nav>",
                                      pipeline::escapedHtml(file));
}

// What stands between <main> and </main>: the lesson on paper, for a browser without scripts. Words stand for the pictures,
// which the page makes itself otherwise.
std::string paperOf(const std::string& handout) {
    constexpr std::string_view kMainStart = "<main>", kMainEnd = "</main>",
                               kPicture = "<img src=\"data:", kWords = " alt=\"";
    const std::size_t start = handout.find(kMainStart), end = handout.rfind(kMainEnd);
    if (start == handout.npos || end == handout.npos) return {};
    std::string_view rest =
        std::string_view(handout).substr(start + kMainStart.size(), end - start - kMainStart.size());
    std::string paper;
    for (std::size_t at; (at = rest.find(kPicture)) != rest.npos;) {
        paper += rest.substr(0, at);
        const std::string_view picture = rest.substr(at, rest.find('>', at) + 1 - at);
        if (const std::size_t words = picture.find(kWords); words != picture.npos) {
            const std::string_view alt = picture.substr(words + kWords.size());
            paper.append("<em>").append(alt.substr(0, alt.find('"'))).append("</em>");
        }
        rest.remove_prefix(at + picture.size());
    }
    return paper.append(rest);
}

// The core, or where it is.
std::string coreElement(const LiveParts& parts) {
    if (!parts.sharedCore.empty()) return "<script src=\"" + pipeline::escapedHtml(parts.sharedCore) + "\"></script>";
    return "<script type=\"application/octet-stream\" id=\"core\">" + pipeline::base64(parts.core) + "</script>";
}

// The lesson after this one, with its page where the site has one.
Json nextJson(const Lesson& lesson, const LiveParts& parts) {
    const auto text = lesson.next.empty() ? pipeline::Result<LessonText>(Error{}) : otherLesson(lesson.next);
    if (!text) return {};
    std::string title = lesson.next;
    int minutes = 0;
    for (const Line& line : linesOf(text->text, text->file)) {
        const auto entry = entryIn(line);
        if (!entry) break;  // the header is at an end
        if (entry->key == "title") title = entry->line().text;
        if (entry->key == "minutes") minutes = int(numberIn(entry->line().text).value_or(0));
    }
    return {{"title", title}, {"minutes", minutes}, {"file", parts.index.empty() ? "" : livePageFile(lesson.next)}};
}

// The page of a lesson's text. folderName: of its folder; empty where it has none.
Result<LivePage> makePage(const LessonText& from, const std::string& folderName, const LiveParts& parts,
                          const pipeline::Stop& stop) {
    Json files = Json::object();
    // Its questions alone: a page knows nothing of what its reader has answered in other lessons.
    auto read = parseOwnPages(from.text, from.file, [&](std::string_view name) {
        Result<pipeline::Scene> scene = from.sceneNamed(name);
        if (!scene) return scene;
        const auto toml = pipeline::toTomlScene(*scene);
        if (!toml) return Result<pipeline::Scene>(toml.errors());
        files[std::string(name) + ".toml"] = *toml;
        return scene;
    });
    if (!read) return read.errors();
    Lesson lesson = std::move(read).value();
    lesson.name = folderName;
    lesson.folder = from.folder;
    files["misconceptions.md"] = misconceptionRows(from.text);

    auto handout = makeHandout(lesson, stop);
    if (!handout) return handout.errors();
    LivePage page{{}, handout->leftOut};

    Json texts = Json::array();
    Pictures pictures(from.folder);
    for (Page& one : lesson.pages) {
        pictures.readFrom(folderOf(lesson, one));
        for (Prose* prose : liveTexts(one)) {
            Errors leftOut;  // the handout has told of them
            const std::string html = proseHtml(withHoleWords(*prose), pictures, leftOut);
            if (!dress(*prose, html))
                return Error{one.where, "a text has a hole inside of a link or a picture", "holes in the text alone"};
            texts.push_back(html);
        }
    }
    const Json data{{"title", lesson.title},
                    {"lecture", lesson.lecture},
                    {"summary", lesson.summary},
                    {"name", lesson.name},
                    {"can", lesson.can},
                    {"next", nextJson(lesson, parts)},
                    {"version", pipeline::programVersion()},
                    {"lesson", from.text},
                    {"texts", texts},
                    {"files", files}};
    page.html = withHolesFilled(parts.page, {{"TITLE", pipeline::escapedHtml(lesson.title)},
                                             {"VERSION", pipeline::escapedHtml(pipeline::programVersion())},
                                             {"COREHASH", pipeline::sha256Of(parts.core)},
                                             {"SCRIPTHASH", policyHash(parts.script)},
                                             {"STYLEHASH", policyHash(parts.style)},
                                             {"STYLE", parts.style},
                                             {"SCRIPT", parts.script},
                                             {"PAPER", paperOf(handout->pages)},
                                             {"DATA", blockText(data)},
                                             {"SELF", parts.sharedCore.empty() ? "" : " 'self' file:"},
                                             {"CORE", coreElement(parts)},
                                             {"INDEX", indexLink(parts.index)}});
    return page;
}

// Plain text as a line of a lesson: no sign of it is Markdown's or begins a hole.
std::string asProse(std::string_view text) {
    constexpr std::string_view kSigns = "\\`*_[]<>()#+-!|~&^\"'$.:";
    std::string out;
    for (const char c : text) {
        if (c == '\n' || c == '\r' || c == '\t')
            out += ' ';
        else if (c == '{')
            out += "\\{";
        else if (kSigns.find(c) != kSigns.npos)
            out.append({'\\', c});
        else
            out += c;
    }
    return out;
}
std::string oneLine(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        if (c == '\n' || c == '\r' || c == '\t') c = ' ';
    return out;
}

// The drawn pixel that is nearest to the middle of all that are drawn.
std::optional<glm::ivec2> middlePixel(const pipeline::Scene& scene, const pipeline::Stop& stop) {
    pipeline::FrameRequest request;
    request.wanted = pipeline::setOf({pipeline::BufferId::PolygonId});
    request.stop = stop;
    const auto frame = runFrame(std::make_shared<const pipeline::Scene>(scene), request, nullptr);
    const auto ids = frame ? frame->buffer({pipeline::BufferId::PolygonId}) : std::nullopt;
    if (!ids) return {};
    glm::dvec2 sum(0);
    double count = 0;
    const auto eachDrawn = [&](auto visit) {
        for (std::size_t y = 0; y < ids->rows(); ++y)
            for (std::size_t x = 0; x < ids->columns(); ++x)
                if (ids->value(x, y) >= 0) visit(glm::dvec2(double(x), double(y)));
    };
    eachDrawn([&](glm::dvec2 at) { sum += at, count += 1; });
    std::optional<glm::dvec2> best;
    eachDrawn([&](glm::dvec2 at) {
        const auto off = [&](glm::dvec2 from) { return glm::dot(from - sum / count, from - sum / count); };
        if (!best || off(at) < off(*best)) best = at;
    });
    return best ? std::optional(glm::ivec2(*best)) : std::nullopt;
}

// lesson.md of a scene.
std::string sceneLesson(const pipeline::Scene& scene, std::string_view title, std::string_view look,
                        const std::optional<WindowState>& shown, const pipeline::Stop& stop) {
    std::vector<std::string> buffers{"color"};
    std::optional<glm::ivec2> pixel;
    std::string more;
    if (shown) {
        buffers.clear();
        for (const BufferShown& view : shown->views) buffers.push_back(view.buffer);
        if (shown->pixel) pixel = {(*shown->pixel)[0], (*shown->pixel)[1]};
        if (shown->place) more += fmt::format("place: {}\n", pipeline::text(*shown->place));
        more += fmt::format("channel: {}\n", "rgb"[shown->channel]);
    } else {
        pixel = middlePixel(scene, stop);
        if (!scene.lights.empty()) buffers.emplace_back("n_dot_l.0");
    }
    if (pixel) more += fmt::format("pixel: {}, {}\n", pixel->x, pixel->y);
    const std::string given = oneLine(title.empty() ? scene.name : title);
    const std::string name = given.find_first_not_of(' ') == given.npos ? "Scene" : given;
    return fmt::format("title: {}\nlecture: Scene\nsummary: {}\nscene: scene\n\n# {}\nbuffers: {}\n{}\n{}\n", name,
                       oneLine(look).find_first_not_of(' ') == std::string::npos ? name : oneLine(look), name,
                       fmt::join(buffers, ", "), more,
                       asProse(look.empty() ? "Click a pixel to see why it has its colour." : look));
}

}  // namespace

Result<LiveParts> liveParts() {
    LiveParts parts;
    // The script's files in their order, one after the other.
    static constexpr std::array<std::string_view, 12> kScripts{"core.js",  "view.js",     "pictures.js", "stages.js",
                                                               "pixel.js", "settings.js", "worker.js",   "lesson.js",
                                                               "space.js", "stage.js",    "end.js",      "page.js"};
    std::vector<std::pair<std::string_view, std::string*>> files{{"page.html", &parts.page},
                                                                 {"tokens.css", &parts.style},
                                                                 {"page.css", &parts.style},
                                                                 {"stage.css", &parts.style}};
    parts.script = "'use strict';\n";
    for (const std::string_view name : kScripts) files.emplace_back(name, &parts.script);
    for (const auto& [name, text] : files) {
        const auto read = readPageFile(name);
        if (!read) return read.errors();
        *text += *read;
    }
    auto core = readPageFile(kCoreName);
    if (!core)
        return Error{
            {},
            "the core of live pages is not built: ./run builds it for this command; by hand install the packages "
            "under [live] of resources/packages.txt, then cmake --preset web && ninja -C build/web",
            {}};
    parts.core = std::move(core).value();
    return parts;
}

Result<LivePage> makeLivePage(const Lesson& lesson, const LiveParts& parts, const pipeline::Stop& stop) {
    const auto text = lessonText(lesson.folder, stop);
    if (!text) return text.errors();
    return makePage(*text, lesson.name, parts, stop);
}

Result<LivePage> makeLivePage(const pipeline::Scene& scene, std::string_view title, std::string_view look,
                              const std::optional<WindowState>& shown, const LiveParts& parts,
                              const pipeline::Stop& stop) {
    const std::string text = pipeline::escapedControls(sceneLesson(scene, title, look, shown, stop));
    return makePage({text, "scene", {}, [&](std::string_view) { return scene; }}, {}, parts, stop);
}

}  // namespace lessons
