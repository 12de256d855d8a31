#include "lessons/talk_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/page_parts.h"
#include "lessons/state/state_scene.h"
#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/formula_mathml.h"
#include "pipeline/export/html_text.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/run/runner.h"
#include "pipeline/steps/steps.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::Errors;
using pipeline::escapedHtml;
using pipeline::Result;

constexpr glm::ivec2 kRoom{1600, 900};  // of all views of a cue, pixels

void addSizes(const ViewTree& tree, glm::ivec2 room, std::vector<glm::ivec2>& sizes) {
    if (tree.kind == ViewTree::Kind::Leaf) return sizes.push_back(room);
    const int axis = tree.kind == ViewTree::Kind::Row ? 0 : 1;
    std::int64_t all = 0, before = 0;
    for (const ViewTree& part : tree.parts) all += part.weight;
    for (const ViewTree& part : tree.parts) {
        // From border to border, so that the parts fill the room.
        const std::int64_t end = before + part.weight;
        glm::ivec2 own = room;
        own[axis] = std::max(1, int(room[axis] * end / all - room[axis] * before / all));
        before = end;
        addSizes(part, own, sizes);
    }
}

std::string frameText(std::string_view tag, std::string_view kind, int weight) {
    return fmt::format("<{} class=\"{}\" data-weight=\"{}\">", tag, kind, weight);
}

// Views in rows and columns; `drawn` has a figure for each leaf as it is read.
void addViews(const ViewTree& tree, const std::vector<std::string>& drawn, std::size_t& next, std::string& html) {
    if (tree.kind == ViewTree::Kind::Leaf) {
        html += frameText("figure", "view", tree.weight) + drawn[next++] + "</figure>\n";
        return;
    }
    html += frameText("div", tree.kind == ViewTree::Kind::Row ? "across" : "down", tree.weight);
    for (const ViewTree& part : tree.parts) addViews(part, drawn, next, html);
    html += "</div>\n";
}

std::string nameOf(const WindowState& state, ViewLeaf view) {
    const auto number = std::size_t(view.number);
    if (view.kind == ViewLeaf::Kind::Space)
        return number < state.spaces.size() ? "3D view: " + state.spaces[number].space : std::string("3D view");
    return number < state.views.size() ? state.views[number].buffer : std::string();
}

class TalkWriter {
public:
    TalkWriter(const std::filesystem::path& folder, const DrawView& draw, const pipeline::Stop& stop)
        : m_folder(folder), m_draw(draw), m_stop(stop) {}

    // A cue as an element section. Nothing, after errors() has why.
    std::string section(const Cue& cue, std::size_t number) {
        auto scene = sceneOf(cue.state, m_folder);
        if (!scene) return fail(cue, scene.errors());
        const auto shared = std::make_shared<const pipeline::Scene>(std::move(scene).value());
        const auto tree = arrangementOf(cue.state.arrangement);
        if (!tree) return fail(cue, tree.errors());
        const std::string views = viewsHtml(cue, *tree, shared);
        if (!m_errors.empty()) return {};
        const std::string caption = cue.ask ? askText(*cue.ask) : cue.caption.empty() ? cue.name : cue.caption;
        const auto frame = frameOf(cue, shared);
        if (!frame) return fail(cue, {Error{{}, "stopped", {}}});
        std::string html =
            fmt::format("<section class=\"cue\" id=\"cue-{}\" aria-labelledby=\"name-{}\">\n", number, number);
        html += fmt::format("<h2 id=\"name-{}\">{}</h2>\n<div class=\"room\">{}{}</div>\n", number,
                            escapedHtml(cue.name), views,
                            cue.ask ? std::string() : equationHtml(cue.state, *frame));  // no numbers before the answer
        html += "<p class=\"caption\"><b>" + escapedHtml(m_stage) + "</b> " + escapedHtml(caption) + "</p>\n";
        if (!cue.note.empty()) html += "<aside class=\"said\">" + escapedHtml(cue.note) + "</aside>\n";
        return html + "</section>\n";
    }
    const Errors& errors() const { return m_errors; }
    std::vector<std::string> leftOut;

private:
    // "Which one? A: Red · B: Blue"
    static std::string askText(const CueQuestion& question) {
        std::string text = question.text;
        char letter = 'A';
        for (const std::string& choice : question.choices)
            text += fmt::format("{}{}: {}", letter == 'A' ? " " : " · ", letter, choice), ++letter;
        return text;
    }
    std::string fail(const Cue& cue, const Errors& errors) {
        for (Error error : errors) {
            error.found = "cue " + pipeline::inQuotes(cue.name) + ": " + error.found;
            m_errors.push_back(std::move(error));
        }
        return {};
    }

    std::string viewsHtml(const Cue& cue, const ViewTree& tree, const std::shared_ptr<const pipeline::Scene>& scene) {
        const std::vector<ViewLeaf> leaves = leavesOf(tree);
        const std::vector<glm::ivec2> sizes = viewSizes(tree, kRoom);
        std::vector<std::string> drawn;
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            const std::string name = nameOf(cue.state, leaves[i]);
            const auto picture = m_draw(cue.state, scene, leaves[i], sizes[i], m_stop);
            if (m_stop.stop_requested()) return fail(cue, {Error{{}, "stopped", {}}});
            // Inside a frame a buffer may be yet to come, and a machine may have no OpenGL: the rest is shown.
            const std::string why = picture ? picture->leftOut : pipeline::format(picture.errors());
            if (!why.empty()) leftOut.push_back(cue.name + ": " + why);
            std::string html = picture ? fmt::format("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\">",
                                                     pipeline::imageSource("png", picture->png), sizes[i].x, sizes[i].y,
                                                     escapedHtml(name + ". " + cue.caption))
                                       : std::string();
            html += "<figcaption>" + escapedHtml(name) +
                    (why.empty() ? std::string() : ". " + pipeline::element("em", why)) + "</figcaption>";
            drawn.push_back(std::move(html));
        }
        std::size_t next = 0;
        std::string html;
        addViews(tree, drawn, next, html);
        return html;
    }

    // At the cue's place; null when stopped.
    pipeline::FramePtr frameOf(const Cue& cue, const std::shared_ptr<const pipeline::Scene>& scene) {
        const pipeline::FrameRequest request{
            .wanted = pipeline::setOf({pipeline::BufferId::Color, pipeline::BufferId::PolygonId}), .stop = m_stop};
        const pipeline::FramePtr whole = runFrame(scene, request, nullptr);
        m_stage = pipeline::stageInfo(cue.state.stage).label;
        if (!whole || !cue.state.place) return whole;
        const pipeline::Steps steps(whole);
        const pipeline::Moment moment = steps.momentOf(*cue.state.place);
        m_stage = pipeline::stageInfo(moment.stage).label;
        if (const std::string words = steps.words(moment, cue.state.step); !words.empty()) m_stage += ": " + words;
        return steps.frameAt(moment, 0, m_stop);
    }

    // Of the picked pixel, as the clean view has it: symbols, numbers, result.
    static std::string equationHtml(const WindowState& state, const pipeline::Frame& frame) {
        if (!state.pixel) return {};
        const auto report = inspectPixel(frame, {(*state.pixel)[0], (*state.pixel)[1]});
        std::string html;
        for (const pipeline::EquationLine& line : equation(frame.scene(), report, state.channel)) {
            if (line.role == "row") continue;
            html += fmt::format("<div role=\"math\" aria-label=\"{}\">", escapedHtml(toText(line.formula)));
            for (const std::string& part : pipeline::mathmlParts(line.formula)) html += "<math>" + part + "</math> ";
            html += "</div>\n";
        }
        return html.empty() ? html : "<div class=\"equation\">" + html + "</div>\n";
    }

    const std::filesystem::path& m_folder;
    const DrawView& m_draw;
    pipeline::Stop m_stop;
    std::string m_stage;  // of the cue on the way
    Errors m_errors;
};

}  // namespace

std::vector<glm::ivec2> viewSizes(const ViewTree& tree, glm::ivec2 room) {
    std::vector<glm::ivec2> sizes;
    addSizes(tree, room, sizes);
    return sizes;
}

Result<TalkParts> talkParts() {
    TalkParts parts;
    parts.script = "'use strict';\n";
    for (const auto& [name, text] :
         std::initializer_list<std::pair<std::string_view, std::string*>>{{"talk.html", &parts.page},
                                                                          {"tokens.css", &parts.style},
                                                                          {"talk.css", &parts.style},
                                                                          {"talk.js", &parts.script}}) {
        const auto read = readPageFile(name);
        if (!read) return read.errors();
        *text += *read;
    }
    return parts;
}

Result<TalkPage> makeTalkPage(const CueList& list, const std::filesystem::path& folder, const TalkParts& parts,
                              const DrawView& draw, const pipeline::Stop& stop, const TalkProgress& progress) {
    if (list.cues.empty()) return Error{{}, "the list has no cues", {}};
    TalkWriter writer(folder, draw, stop);
    std::string cues;
    std::size_t number = 0;
    for (const Cue& cue : list.cues) {
        cues += writer.section(cue, ++number);
        if (stop.stop_requested()) return Error{{}, "stopped", {}};
        if (progress) progress(number);
    }
    if (!writer.errors().empty()) return writer.errors();
    const std::string title = escapedHtml(list.title.empty() ? "Talk" : list.title);
    return TalkPage{withHolesFilled(parts.page, {{"TITLE", title},
                                                 {"VERSION", escapedHtml(pipeline::programVersion())},
                                                 {"MINUTES", fmt::format("{}", list.minutes)},
                                                 {"SCRIPTHASH", policyHash(parts.script)},
                                                 {"STYLEHASH", policyHash(parts.style)},
                                                 {"STYLE", parts.style},
                                                 {"SCRIPT", parts.script},
                                                 {"CUES", cues}}),
                    std::move(writer.leftOut)};
}

}  // namespace lessons
