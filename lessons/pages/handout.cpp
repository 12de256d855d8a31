#include "lessons/pages/handout.h"

#include <fmt/format.h>

#include "lessons/lesson_text.h"
#include "lessons/pages/handout_figure.h"
#include "lessons/pages/prose_html.h"
#include "lessons/questions/answer_text.h"
#include "lessons/questions/hidden.h"
#include "lessons/questions/judge.h"
#include "lessons/questions/misconceptions.h"
#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/folder/file_hash.h"
#include "pipeline/export/folder/staging.h"
#include "pipeline/export/html/formula_html.h"
#include "pipeline/export/html/html_text.h"
#include "pipeline/inspect/formula_parts.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/run/runner.h"

namespace lessons {

namespace {

using pipeline::element;
using pipeline::escapedHtml;

constexpr std::string_view kStyle = R"(
p, ul, ol { margin: .5rem 0; } ul, ol { padding-left: 1.4rem; }
img { max-width: 100%; }
code { font: .85em "JetBrains Mono", ui-monospace, monospace; }
blockquote { margin: .5rem 0; padding-left: 1rem; border-left: 3px solid #D0D5DC; }
.lecture, footer { color: #4A525D; font-size: .875rem; }
section { margin-top: 2rem; padding-top: 1.25rem; border-top: 1px solid #D0D5DC; }
.equation { margin: .75rem 0; padding: .5rem .75rem; border-left: 3px solid #1B57BD; }
.equation p { margin: .15rem 0; } .equation .more { padding-left: 1.5rem; } .remark { color: #4A525D; font-size: .875rem; }
.question { margin: .75rem 0 0; padding: .5rem .75rem .75rem; border: 1.5px solid #171A1F; break-inside: avoid; }
.blank { display: inline-block; min-width: 12rem; border-bottom: 1px solid #171A1F; }
.lines { margin-top: .5rem; padding: .25rem .75rem; border: 1px solid #828A95; font-family: "JetBrains Mono", monospace; } .lines p { margin: 0; } .lines .line { height: 2rem; border-bottom: 1px dotted #828A95; }
.place { display: inline-block; width: 2rem; margin-right: .75rem; border-bottom: 1px solid #171A1F; }
.gap { display: inline-block; min-width: 3.5rem; border-bottom: 1px solid #171A1F; text-align: left; } .gap b { font-size: .7em; vertical-align: super; }
.answer { font-weight: 600; }
.options { list-style: none; padding: 0; } .options p, .works p, td p { display: inline; margin: 0; }
.box { display: inline-block; width: .9rem; height: .9rem; border: 1.5px solid #171A1F; vertical-align: -.1rem; }
.hint { display: flex; gap: 1rem; margin: .5rem 0; } .hint b { min-width: 1.5rem; text-align: right; } .hint p { margin: 0; }
footer { margin-top: 3rem; }
@media print { .first { break-after: page; } main { max-width: none; padding: 0; } body { font-size: 11pt; }
  h2 { break-after: avoid; } .question { break-before: avoid; } figure, table, .equation, .hint, .options li { break-inside: avoid; }
  footer { margin-top: 1rem; break-before: avoid; } }
)";

// A whole page around `body`.
std::string document(const Lesson& lesson, std::string_view what, const std::string& body) {
    const std::string title = fmt::format("{}{}", lesson.title, what);
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" "
        "content=\"width=device-width\">\n{}\n<style>{}{}{}{}</style>\n</head>\n<body>\n<main>\n"
        "{}\n{}\n{}<footer>Shadescope {}</footer>\n</main>\n</body>\n</html>\n",
        element("title", title), paperStyle(), kStyle, pipeline::formulaStyle(), figureStyle(), element("h1", title),
        lesson.lecture.empty() ? std::string() : element("p class=lecture", lesson.lecture), body,
        escapedHtml(pipeline::programVersion()));
}

std::string blank(std::string_view before) { return fmt::format("{} <span class=blank>&nbsp;</span>", before); }

std::string headingOf(const Lesson& lesson, std::size_t index) {
    const Page& page = lesson.pages[index];
    return element("h2", page.from ? page.heading : pageName(lesson, index) + ' ' + page.heading);
}

// The equation that the window shows beside the half of a page: of the picked pixel, in the page's channel.
std::string equationHtml(const PageState& state, const pipeline::Frame& frame, const pipeline::Stop& stop) {
    if (state.window.stage != pipeline::StageId::Shading || !pickedPixel(state)) return {};
    static constexpr const char* kChannels[]{"red", "green", "blue"};
    const glm::ivec2 pixel = *pickedPixel(state);
    std::string html;
    for (const pipeline::EquationLine& line :
         equation(frame.scene(), inspectPixel(frame, pixel, stop), state.window.channel)) {
        const bool goesOn = line.role == "numbers" || line.role == "result";
        html += goesOn ? "<p class=more>" : "<p>";
        html += toHtml(line.formula);
        if (!line.remark.empty()) html += ' ' + element("span class=remark", line.remark);
        html += "</p>\n";
    }
    if (html.empty()) return {};
    return fmt::format("<div class=equation><p class=remark>Pixel {}, {} (the ring), {}:</p>\n{}</div>\n", pixel.x,
                       pixel.y, kChannels[state.window.channel], html);
}

std::string worthText(const Question& question) {
    return fmt::format("{}{} {}{}", question.isPrediction ? "Prediction: " : "",
                       pipeline::shortestText(question.points), question.points == 1 ? "point" : "points",
                       question.isPrediction ? ", a wrong answer costs nothing" : "");
}

// Whether a mark in the picture answers the page, and another page shows the same view: printed after that one, it would
// be read off there.
bool isFirstOnPaper(const Lesson& lesson, const Page& page) {
    const auto* click = page.question ? std::get_if<ClickQuestion>(&page.question->kind) : nullptr;
    const PageState& own = page.first.state;
    return click && click->kind == ThingKind::Pixel && std::ranges::any_of(lesson.pages, [&](const Page& other) {
               const PageState& state = other.first.state;
               return &other != &page && state.window.scene == own.window.scene &&
                      state.scene.camera == own.scene.camera;
           });
}

// Takes up the pages, and what could not be filled in.
class Writer {
public:
    Writer(const Lesson& lesson, const pipeline::Stop& stop)
        : m_lesson(lesson), m_stop(stop), m_pictures(lesson.folder), m_answerPictures(lesson.folder) {}

    void add(const Page& page, std::size_t number, const PageFrames& frames) {
        m_page = &page;
        for (Pictures* pictures : {&m_pictures, &m_answerPictures}) pictures->readFrom(folderOf(m_lesson, page));
        const Hidden hidden = hiddenOn(page, false);
        std::string section = "<section>\n" + headingOf(m_lesson, number) + '\n';
        section += half(page.first, frames.first, hidden, m_pictures);
        if (page.question) section += ask(*page.question, number, {.frame = *frames.first, .stop = m_stop});
        (isFirstOnPaper(m_lesson, page) ? m_first : m_pages) += section + "</section>\n";
        if (!page.question) return;
        m_answers += "<section>\n" + headingOf(m_lesson, number) + '\n';
        answer(*page.question, {.frame = *frames.first, .stop = m_stop});
        if (page.then) m_answers += half(*page.then, frames.then, {}, m_answerPictures);
        m_answers += "</section>\n";
    }

    pipeline::Result<Handout> finish() const {
        if (!m_errors.empty()) return m_errors;
        const std::string head =
            element("p", m_lesson.summary) + "\n<p>" + blank("Name") + ' ' + blank("Date") + "</p>\n";
        const std::string hints =
            m_hints.empty() ? std::string() : "<section>\n<h2>Hints</h2>\n" + m_hints + "</section>\n";
        const std::string first =
            m_first.empty() ? std::string()
                            : "<div class=first>\n<p>Mark these first. Later pages show what is asked here.</p>\n" +
                                  m_first + "</div>\n";
        const std::string pages = document(m_lesson, "", head + first + m_pages + hints);
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
    std::string html(const Prose& prose, const Context& context) { return html(prose, context, m_answerPictures); }
    std::string html(const Prose& prose, const Context& context, Pictures& pictures) {
        pipeline::Errors leftOut;
        std::string html = proseHtml(filled(prose, context, m_errors), pictures, leftOut);
        for (pipeline::Error& one : leftOut) {
            if (m_leftOutCount++ >= pipeline::kMaxErrors) continue;
            one.where = m_page->where;
            one.found = "a picture is left out: " + one.found;
            m_leftOut.push_back(std::move(one));
        }
        return html;
    }

    // What a hand would move, in three places.
    std::string stripHtml(const Half& half, const pipeline::FramePtr& frame, const Hidden& hidden) const {
        std::string figures;
        std::vector<std::string> numbers;
        for (const std::string& values : half.held.strip) {
            const auto scene = pipeline::withSettings(half.state.scene, values);
            if (!scene) continue;  // lesson check says why
            pipeline::FrameRequest request;
            request.wanted = frame->wanted(), request.stop = m_stop;
            const auto moved = runFrame(std::make_shared<const pipeline::Scene>(*scene), request, frame);
            if (moved) figures += figuresHtml({*scene, half.state.window}, moved, hidden, m_stop);
            numbers.push_back(values.substr(values.find('=') + 1));
        }
        return figures + element("p class=remark", fmt::format("From left to right: {}", fmt::join(numbers, ", "))) +
               '\n';
    }
    // Figures, text, and the equation unless it is hidden with the numbers of the pixel.
    std::string half(const Half& half, const pipeline::FramePtr& frame, const Hidden& hidden, Pictures& pictures) {
        const std::string figures =
            half.held.strip.empty() ? figuresHtml(half.state, frame, hidden, m_stop) : stripHtml(half, frame, hidden);
        std::string text = figures.empty() ? std::string() : "<div class=pictures>\n" + figures + "</div>\n";
        text += html(half.paper, {.frame = *frame, .stop = m_stop}, pictures);
        pipeline::Errors none;
        text += proseHtml(filesText(half.held, half.state.scene), pictures, none);
        if (!hidden.hides(Part::Inspector) && !hidden.hides(Part::Equation))
            text += equationHtml(half.state, *frame, m_stop);
        return text;
    }

    std::string asked(const Question& question, const Context& context) {
        return html(question.paper.empty() ? question.text : question.paper, context);
    }
    std::string options(const Question& question, const Context& context, const char* mark) {
        std::string list;
        char letter = 'A';
        const bool isOrder = std::holds_alternative<OrderQuestion>(question.kind);
        const std::string box = isOrder ? "" : fmt::format("<span class=box>{}</span> ", mark);
        for (const Prose* row : rowsOf(question))
            list += fmt::format("<li>{}<b>{}</b> {}</li>\n", box, letter++, html(*row, context));
        return list.empty() ? list : "<ul class=options>\n" + list + "</ul>\n";
    }

    // A line of small blanks for letters, both ends named.
    static std::string places(const OrderQuestion& order) {
        std::string line = escapedHtml(order.first.empty() ? "first" : order.first);
        for (std::size_t i = 1; i <= order.items.size(); ++i)
            line += fmt::format(" {} <span class=place>&nbsp;</span>", i);
        return "<p class=places>" + line + ' ' + escapedHtml(order.last.empty() ? "last" : order.last) + "</p>";
    }

    // The contract in words, and empty lines between the head of the function and its end.
    static std::string linesBox(const WriteQuestion& write) {
        std::string given;
        for (const pipeline::OwnParameter& one : write.contract.taken())
            given += fmt::format("{}<code>{}</code>{}: {}", given.empty() ? "" : "; ", escapedHtml(one.name),
                                 isList(one.kind) ? ", a list" : "", escapedHtml(one.meaning));
        std::string lines = element("p", fmt::format("function {} {{", signatureOf(write.contract)));
        for (std::size_t i = 0; i < write.lines; ++i) lines += "<p class=line>&nbsp;</p>";
        return fmt::format("<p>{}. Return: {}.</p>\n<div class=lines>{}<p>}}</p></div>\n", given,
                           escapedHtml(write.contract.result), lines);
    }

    std::string ask(const Question& question, std::size_t number, const Context& context) {
        std::string box = "<div class=question>" + asked(question, context) + options(question, context, "&nbsp;");
        const auto* click = std::get_if<ClickQuestion>(&question.kind);
        const auto* typed = std::get_if<NumberQuestion>(&question.kind);
        if (click && click->kind == ThingKind::Pixel)
            box += "<p>Mark the place with a cross in the picture.</p>";
        else if (const auto* order = std::get_if<OrderQuestion>(&question.kind))
            box += places(*order);
        else if (const auto* write = std::get_if<WriteQuestion>(&question.kind))
            box += linesBox(*write);
        else if (optionsOf(question).empty())
            box += "<p>" + blank("Answer") + (typed ? ' ' + escapedHtml(typed->unit) : std::string()) + "</p>";
        box += element("p class=remark", worthText(question)) + "</div>\n";
        std::string hints;
        for (const Prose& hint : question.hints) hints += html(hint, context);
        if (!hints.empty())
            m_hints += fmt::format("<div class=hint><b>{}</b><div>{}</div></div>\n", pageName(m_lesson, number), hints);
        return box;
    }

    void answer(const Question& question, const Context& context) {
        m_answers += asked(question, context) + options(question, context, "&nbsp;");
        const auto text = answerText(question, context);
        if (!text) {
            m_errors.insert(m_errors.end(), text.errors().begin(), text.errors().end());
            return;
        }
        // The answer of a choice may have Markdown in it.
        pipeline::Errors none;
        std::string answer = proseHtml(*text, m_answerPictures, none);
        answer = answer.starts_with("<p>") ? "<p class=answer>" + answer.substr(3) : answer;
        m_answers += answer + element("p class=remark", worthText(question)) + '\n';
        std::string works;
        const std::string steps = filled(question.works, context, m_errors);
        for (const Line& line : linesOf(steps, {}))
            if (!isBlank(line)) works += "<li>" + proseHtml(line.text, m_answerPictures, none) + "</li>\n";
        if (!works.empty()) m_answers += "<ol class=works>\n" + works + "</ol>\n";
        const std::string wrong = wrongAnswers(question, context);
        if (!wrong.empty())
            m_answers +=
                "<table><caption>Wrong answers</caption><thead><tr><th>answer</th><th>mistake</th><th>what is "
                "said</th></tr></thead><tbody>\n" +
                wrong + "</tbody></table>\n";
    }
    std::string wrongAnswers(const Question& question, const Context& context) {
        std::string rows;
        const auto row = [&](const std::string& given, const std::string& id, const Prose& said) {
            const Misconception* known = findMisconception(id);
            rows += "<tr>" + element("td", given) + element("td", known ? known->name : id) + "<td>" +
                    html(said, context) + "</td></tr>\n";
        };
        const auto mistakes = mistakesOf(question);
        for (std::size_t i = 0; i < mistakes.size(); ++i) {
            const auto given = mistakeText(question, i, context);
            row(given ? *given : "", mistakes[i].id, mistakes[i].said);
        }
        char letter = 'A';
        for (const Option& option : optionsOf(question)) {
            const std::string given(1, letter++);
            const auto holds = evaluate(option.holds, context);
            if (holds && holds->numbers[0] != 1 && (!option.mistake.empty() || !option.said.empty()))
                row(given, option.mistake, option.said);
        }
        if (const auto* order = std::get_if<OrderQuestion>(&question.kind))
            for (const OrderQuestion::Wrong& wrong : order->mistakes) {
                std::vector<std::string> letters;
                for (const std::size_t i : wrong.order) letters.emplace_back(1, char('A' + i));
                const bool isOpposite = letters.empty();
                row(isOpposite ? "the opposite" : fmt::format("{}", fmt::join(letters, ", ")), wrong.mistake.id,
                    wrong.mistake.said);
            }
        if (const auto* several = std::get_if<SeveralQuestion>(&question.kind); several && several->opposite)
            row("the others", several->opposite->id, several->opposite->said);
        return rows;
    }

    const Lesson& m_lesson;
    const pipeline::Stop& m_stop;
    const Page* m_page = nullptr;                      // the one that is being written
    Pictures m_pictures, m_answerPictures;             // one budget for each file
    std::string m_first, m_pages, m_hints, m_answers;  // m_first: pages before all others
    pipeline::Errors m_errors, m_leftOut;
    std::size_t m_leftOutCount = 0;
};

}  // namespace

pipeline::Result<Handout> makeHandout(const Lesson& lesson, const pipeline::Stop& stop,
                                      const HandoutProgress& progress) {
    Writer writer(lesson, stop);
    const bool all = runPages(lesson, stop, [&](const Page& page, std::size_t number, const PageFrames& frames) {
        if (progress) progress(number);
        writer.add(page, number, frames);
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
