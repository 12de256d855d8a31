#include "lessons/pages/live_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "lessons/library.h"
#include "lessons/pages/handout.h"
#include "lessons/pages/live_data.h"
#include "lessons/pages/page_parts.h"
#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/folder/file_hash.h"
#include "pipeline/export/folder/gzip.h"
#include "pipeline/export/html/html_text.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::Errors;
using pipeline::Json;
using pipeline::Result;

constexpr std::string_view kStrict = "'use strict';\n";  // what a page's script begins with

// The core with the judge of functions.
constexpr auto kWritingCore = "shadescope_core_write.wasm.gz";

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
    return "<script type=\"application/octet-stream\" id=\"core\">" + pipeline::base85(parts.core) + "</script>";
}

// Of a lesson with questions of kind write: with its own core, unless pages share one.
Result<LiveParts> writingParts(const LiveParts& parts) {
    auto with = withWriter(parts);
    if (!with || !parts.sharedCore.empty()) return with;
    auto core = readPageFile(kWritingCore);
    if (!core) return core.errors();
    LiveParts own = std::move(with).value();
    own.core = std::move(core).value();
    return own;
}

// The page of a lesson's text.
Result<LivePage> makePage(const LessonText& from, const std::string& folderName, const LiveParts& parts,
                          const pipeline::Stop& stop) {
    auto read = readLive(from, folderName);
    if (!read) return read.errors();
    LiveLesson live = std::move(read).value();
    auto handout = makeHandout(live.lesson, stop);
    if (!handout) return handout.errors();
    const bool writes = std::ranges::any_of(live.lesson.pages, [](const Page& page) {
        return page.question && std::holds_alternative<WriteQuestion>(page.question->kind);
    });
    const auto own = writes ? writingParts(parts) : Result<LiveParts>(LiveParts());
    if (!own) return own.errors();
    Errors leftOut;  // the handout has told of them
    const auto data = liveData(live, from, parts.index.empty() ? "" : livePageFile(live.lesson.next), leftOut);
    if (!data) return data.errors();
    return LivePage{
        filledPage(
            writes ? *own : parts, live.lesson.title, *data,
            {{"PAPER", paperOf(handout->pages)},
             {"NOSCRIPT", "Open it in a browser with scripts for the live lesson. Below is the lesson on paper."},
             {"PLACES", ""},
             {"INDEX", indexLink(parts.index)}}),
        handout->leftOut};
}

}  // namespace

Result<LiveParts> withWriter(LiveParts parts) {
    const auto script = readPageFile("write.js"), style = readPageFile("write.css");
    const auto writer = writerParts();
    if (!script) return script.errors();
    if (!style) return style.errors();
    if (!writer) return writer.errors();
    parts.script.insert(kStrict.size(), *script), parts.style += *style;
    const std::string packed = pipeline::gzipped(Json{{"reader", writer->reader}, {"lines", writer->lines}}.dump());
    parts.writer = fmt::format(
        "<!-- The script below has acorn in it.\n{} -->\n"
        "<script type=\"application/octet-stream\" id=\"writer\">{}</script>\n",
        writer->notice, pipeline::base85(packed));
    return parts;
}

std::string filledPage(const LiveParts& parts, std::string_view title, const Json& data, PageValues values) {
    values.insert({{"TITLE", pipeline::escapedHtml(title)},
                   {"VERSION", pipeline::escapedHtml(pipeline::programVersion())},
                   {"COREHASH", pipeline::sha256Of(parts.core)},
                   {"SCRIPTHASH", policyHash(parts.script)},
                   {"STYLEHASH", policyHash(parts.style)},
                   {"STYLE", parts.style},
                   {"SCRIPT", parts.script},
                   {"DATA", blockText(data)},
                   {"SELF", parts.sharedCore.empty() ? "" : " 'self' file:"},
                   {"CORE", coreElement(parts)},
                   {"WRITER", parts.writer}});
    return withHolesFilled(parts.page, values);
}

Result<LiveParts> liveParts(LiveKind kind) {
    LiveParts parts;
    // The script's files in their order, one after the other.
    static constexpr std::array<std::string_view, 12> kScripts{"core.js",  "view.js",     "pictures.js", "stages.js",
                                                               "pixel.js", "settings.js", "worker.js",   "lesson.js",
                                                               "space.js", "stage.js",    "end.js",      "page.js"};
    static constexpr std::array<std::string_view, 7> kOfWhole{"files.js", "link.js",  "side.js", "mine.js",
                                                              "game.js",  "study.js", "all.js"};
    std::vector<std::pair<std::string_view, std::string*>> files{{"page.html", &parts.page},
                                                                 {"tokens.css", &parts.style},
                                                                 {"page.css", &parts.style},
                                                                 {"stage.css", &parts.style}};
    parts.script = kStrict;
    for (const std::string_view name : kScripts) files.emplace_back(name, &parts.script);
    if (kind != LiveKind::Whole) {
        files.emplace_back("start.js", &parts.script);
    } else {
        files.emplace_back("all.css", &parts.style);
        for (const char* name : {"start.html", "mine.html", "game.html"}) files.emplace_back(name, &parts.places);
        for (const std::string_view name : kOfWhole) files.emplace_back(name, &parts.script);
    }
    for (const auto& [name, text] : files) {
        const auto read = readPageFile(name);
        if (!read) return read.errors();
        *text += *read;
    }
    static constexpr std::array kCores{"shadescope_core.wasm.gz", kWritingCore, "shadescope_core_all.wasm.gz"};
    auto core = readPageFile(kCores[std::size_t(kind)]);
    if (!core)
        return Error{
            {},
            "the core of live pages is not built: ./run builds it for this command; by hand install the packages "
            "under [live] of resources/packages.txt, then cmake --preset web && ninja -C build/web",
            {}};
    parts.core = std::move(core).value();
    if (kind == LiveKind::Whole) return withWriter(std::move(parts));
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
    return makePage(sceneAsLesson(scene, title, look, shown, stop), {}, parts, stop);
}

}  // namespace lessons
