#include "lessons/pages/live_data.h"

#include <fmt/format.h>

#include "lessons/expression/value.h"
#include "lessons/lesson_text.h"
#include "lessons/library.h"
#include "lessons/pages/live_text.h"
#include "lessons/pages/prose_html.h"
#include "lessons/questions/misconceptions.h"
#include "pipeline/core/printable.h"
#include "pipeline/core/version.h"
#include "pipeline/formats/toml/toml_writer.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/key_places.h"

namespace lessons {

using pipeline::Error;
using pipeline::Errors;
using pipeline::Json;
using pipeline::Result;

namespace {

// The rows of the table that the lesson names; their sources stay in the program.
std::string misconceptionRows(std::string_view lesson) {
    std::string text = "| id | name | stage | defect | source |\n|---|---|---|---|---|\n";
    for (const Misconception& row : misconceptions().rows)
        if (lesson.find(row.id) != lesson.npos)
            text += fmt::format("| {} | {} | {} |  |  |\n", row.id, row.name, row.stage);
    return text;
}

// The lesson after this one. file: where it is, empty where a page does not lead there.
Json nextJson(const Lesson& lesson, const std::string& file) {
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
    return {{"title", title}, {"minutes", minutes}, {"file", file}};
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

Result<LiveLesson> readLive(const LessonText& from, const std::string& folderName) {
    LiveLesson live;
    // Its questions alone: a page knows nothing of what its reader has answered in other lessons.
    auto read = parseOwnPages(from.text, from.file, [&](std::string_view name) {
        Result<pipeline::Scene> scene = from.sceneNamed(name);
        if (!scene) return scene;
        const auto toml = pipeline::toTomlScene(*scene);
        if (!toml) return Result<pipeline::Scene>(toml.errors());
        live.files[std::string(name) + ".toml"] = *toml;
        return scene;
    });
    if (!read) return read.errors();
    live.lesson = std::move(read).value();
    live.lesson.name = folderName;
    live.lesson.folder = from.folder;
    live.files["misconceptions.md"] = misconceptionRows(from.text);
    return live;
}

Result<Json> liveData(LiveLesson& live, const LessonText& from, const std::string& nextFile, Errors& leftOut) {
    Lesson& lesson = live.lesson;
    Json texts = Json::array();
    Pictures pictures(from.folder);
    for (Page& one : lesson.pages) {
        pictures.readFrom(folderOf(lesson, one));
        for (Prose* prose : liveTexts(one)) {
            const std::string html = proseHtml(withHoleWords(*prose), pictures, leftOut);
            if (!dress(*prose, html))
                return Error{one.where, "a text has a hole inside of a link or a picture", "holes in the text alone"};
            texts.push_back(html);
        }
    }
    return Json{{"title", lesson.title},
                {"lecture", lesson.lecture},
                {"summary", lesson.summary},
                {"name", lesson.name},
                {"can", lesson.can},
                {"next", nextJson(lesson, nextFile)},
                {"version", pipeline::programVersion()},
                {"lesson", from.text},
                {"texts", texts},
                {"files", live.files}};
}

LessonText sceneAsLesson(const pipeline::Scene& scene, std::string_view title, std::string_view look,
                         const std::optional<WindowState>& shown, const pipeline::Stop& stop) {
    return {pipeline::escapedControls(sceneLesson(scene, title, look, shown, stop)),
            "scene",
            {},
            [scene](std::string_view) { return scene; }};
}

}  // namespace lessons
