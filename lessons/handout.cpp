#include "lessons/handout.h"

#include <fmt/format.h>

#include "lessons/handout_figure.h"
#include "lessons/judge.h"
#include "lessons/prose_html.h"
#include "pipeline/core/version.h"
#include "pipeline/export/file_hash.h"
#include "pipeline/export/formula_html.h"
#include "pipeline/export/html_text.h"
#include "pipeline/export/staging.h"
#include "pipeline/inspect/formula_parts.h"
#include "pipeline/inspect/pixel_report.h"

namespace lessons {

namespace {

using pipeline::element;
using pipeline::escapedHtml;

constexpr std::string_view kStyle = R"(
body { margin: 0; background: #FFFFFF; color: #171A1F; font: 16px/1.5 Inter, system-ui, sans-serif; }
main { max-width: 50rem; margin: 0 auto; padding: 2rem 1.25rem 4rem; }
h1 { font-size: 1.75rem; line-height: 1.2; margin: 0 0 .25rem; }
h2 { font-size: 1.25rem; margin: 0 0 .5rem; }
p, ul, ol { margin: .5rem 0; } ul, ol { padding-left: 1.4rem; }
img { max-width: 100%; }
code { font: .85em "JetBrains Mono", ui-monospace, monospace; }
blockquote { margin: .5rem 0; padding-left: 1rem; border-left: 3px solid #D0D5DC; }
.lecture, footer { color: #4A525D; font-size: .875rem; }
section { margin-top: 2rem; padding-top: 1.25rem; border-top: 1px solid #D0D5DC; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; margin: .75rem 0; }
.equation { margin: .75rem 0; padding: .5rem .75rem; border-left: 3px solid #1B57BD; }
.equation p { margin: .15rem 0; } .equation .more { padding-left: 1.5rem; } .remark { color: #4A525D; font-size: .875rem; }
.question { margin: .75rem 0 0; padding: .5rem .75rem .75rem; border: 1.5px solid #171A1F; break-inside: avoid; }
.blank { display: inline-block; min-width: 12rem; border-bottom: 1px solid #171A1F; }
.answer { font-weight: 600; }
.hint { display: flex; gap: 1rem; margin: .5rem 0; } .hint b { min-width: 1.5rem; text-align: right; } .hint p { margin: 0; }
footer { margin-top: 3rem; }
@media print { main { max-width: none; padding: 0; } body { font-size: 11pt; }
  h2 { break-after: avoid; } figure, table, .equation { break-inside: avoid; } }
)";

// A whole page around `body`.
std::string document(const Lesson& lesson, std::string_view what, const std::string& body) {
    const std::string title = fmt::format("{}{}", lesson.title, what);
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n{}\n<style>{}{}{}</style>\n</head>\n<body>\n<main>\n"
        "{}\n{}\n{}<footer>Shadescope {}</footer>\n</main>\n</body>\n</html>\n",
        element("title", title), kStyle, pipeline::formulaStyle(), figureStyle(), element("h1", title),
        lesson.lecture.empty() ? std::string() : element("p class=lecture", lesson.lecture), body,
        escapedHtml(pipeline::programVersion()));
}

std::string blank(std::string_view before) { return fmt::format("{} <span class=blank>&nbsp;</span>", before); }

std::string headingOf(const Page& page, std::size_t number) {
    return element("h2", fmt::format("{} {}", number + 1, page.heading));
}

// The equation that the window shows beside the page: of the picked pixel, in the page's channel.
std::string equationHtml(const Page& page, const pipeline::Frame& frame, const std::stop_token& stop) {
    if (page.first.state.window.stage != pipeline::StageId::Shading || !pickedPixel(page.first.state)) return {};
    static constexpr const char* kChannels[]{"red", "green", "blue"};
    const glm::ivec2 pixel = *pickedPixel(page.first.state);
    std::string html;
    for (const pipeline::EquationLine& line :
         equation(frame.scene(), inspectPixel(frame, pixel, stop), page.first.state.window.channel)) {
        const bool goesOn = line.role == "numbers" || line.role == "result";
        html += goesOn ? "<p class=more>" : "<p>";
        html += toHtml(line.formula);
        if (!line.remark.empty()) html += ' ' + element("span class=remark", line.remark);
        html += "</p>\n";
    }
    if (html.empty()) return {};
    return fmt::format("<div class=equation><p class=remark>Pixel {}, {} (the ring), {}:</p>\n{}</div>\n", pixel.x,
                       pixel.y, kChannels[page.first.state.window.channel], html);
}

// Takes up the pages, and what could not be filled in.
class Writer {
public:
    explicit Writer(const Lesson& lesson) : m_lesson(lesson), m_pictures(lesson.folder) {}

    void add(const Page& page, std::size_t number, const pipeline::Frame& frame, const std::stop_token& stop) {
        m_pages += "<section>\n" + headingOf(page, number) + "\n<div class=pictures>\n";
        const PageState& state = page.first.state;
        const std::vector<pipeline::BufferName> buffers = shownBuffers(state);
        const std::optional<glm::ivec2> pixel = pickedPixel(state);
        const pipeline::Tile part = partToShow(frame, buffers, pixel);
        for (const pipeline::BufferName& buffer : buffers) m_pages += figureHtml(frame, buffer, part, pixel);
        m_page = &page;
        m_pages += "</div>\n" + html(page.first.paper, frame) + equationHtml(page, frame, stop);
        if (page.question) ask(page, number, frame);
        m_pages += "</section>\n";
    }

    pipeline::Result<Handout> finish() const {
        if (!m_errors.empty()) return m_errors;
        const std::string head =
            element("p", m_lesson.summary) + "\n<p>" + blank("Name") + ' ' + blank("Date") + "</p>\n";
        const std::string hints =
            m_hints.empty() ? std::string() : "<section>\n<h2>Hints</h2>\n" + m_hints + "</section>\n";
        const std::string pages = document(m_lesson, "", head + m_pages + hints);
        const std::string answers =
            document(m_lesson, ": answers", m_answers.empty() ? "<p>This lesson asks nothing.</p>\n" : m_answers);
        return Handout{pages,
                       answers + fmt::format("<!-- Answers to a handout of {} bytes, SHA-256 {} -->\n", pages.size(),
                                             pipeline::sha256Of(pages)),
                       leftOut()};
    }

private:
    pipeline::Errors leftOut() const {
        pipeline::Errors all = m_leftOut;
        if (m_leftOutCount > all.size())
            all.push_back({{}, fmt::format("{} more pictures are left out", m_leftOutCount - all.size()), {}});
        return all;
    }
    std::string html(const Prose& prose, const pipeline::Frame& frame) {
        pipeline::Errors leftOut;
        std::string html = proseHtml(filled(prose, {.frame = frame}, m_errors), m_pictures, leftOut);
        for (pipeline::Error& one : leftOut) {
            if (m_leftOutCount++ >= pipeline::kMaxErrors) continue;
            one.where = m_page->where;
            one.found = "a picture is left out: " + one.found;
            m_leftOut.push_back(std::move(one));
        }
        return html;
    }

    void ask(const Page& page, std::size_t number, const pipeline::Frame& frame) {
        const Question& question = *page.question;
        const std::string asked = html(question.text, frame);
        m_pages += "<div class=question>" + asked + "<p>" + blank("Answer") + "</p></div>\n";
        std::string hints;
        for (const Prose& hint : question.hints) hints += html(hint, frame);
        if (!hints.empty()) m_hints += fmt::format("<div class=hint><b>{}</b><div>{}</div></div>\n", number + 1, hints);
        const auto answer = answerText(question, {.frame = frame});
        if (!answer) {
            m_errors.insert(m_errors.end(), answer.errors().begin(), answer.errors().end());
            return;
        }
        m_answers += "<section>\n" + headingOf(page, number) + '\n' + asked + element("p class=answer", *answer) +
                     "\n</section>\n";
    }

    const Lesson& m_lesson;
    const Page* m_page = nullptr;  // the one that is being written
    Pictures m_pictures;
    std::string m_pages, m_hints, m_answers;
    pipeline::Errors m_errors, m_leftOut;
    std::size_t m_leftOutCount = 0;
};

}  // namespace

pipeline::Result<Handout> makeHandout(const Lesson& lesson, const std::stop_token& stop,
                                      const HandoutProgress& progress) {
    Writer writer(lesson);
    const bool all = runPages(lesson, stop, [&](const Page& page, std::size_t number, const PageFrames& frames) {
        if (progress) progress(number);
        writer.add(page, number, *frames.first, stop);
    });
    if (!all) return pipeline::Error{{}, "stopped", {}};
    return writer.finish();
}

std::vector<std::string> handoutFiles(const std::string& name) { return {name + ".html", name + "-answers.html"}; }

pipeline::Result<std::vector<std::string>> writeHandout(const Handout& handout, const std::string& name,
                                                        const std::filesystem::path& folder) {
    const auto files = handoutFiles(name);
    return pipeline::writeFiles({{files[0], handout.pages}, {files[1], handout.answers}}, folder);
}

}  // namespace lessons
