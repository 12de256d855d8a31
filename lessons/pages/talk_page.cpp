#include "lessons/pages/talk_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/pages/page_parts.h"
#include "lessons/pages/talk_html.h"
#include "lessons/pages/talk_words.h"
#include "lessons/state/state_scene.h"
#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/html/html_text.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/run/runner.h"
#include "pipeline/steps/steps.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::Errors;
using pipeline::escapedHtml;
using pipeline::Result;

// The page in pixels, and its parts in those: its line of cues and captions, a view's name, what a cue has beside and
// above its views. As talk.css shares a screen of 16 to 9.
constexpr glm::ivec2 kScreen{1600, 900};
constexpr int kCaptionHeight = 100, kNameHeight = 34, kQuestionHeight = 75, kAnswerHeight = 115, kEquationHeight = 230;
constexpr double kAlgorithmWidth = 0.6, kAskWidth = 0.5, kAnswerWidth = 0.27;  // of the page
// 22 of 1080 lines for text of 12 pixels, as in the clean view.
constexpr double kGrowth = 22.0 / 1080 * kScreen.y / 12;

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

    // A cue as an element section. asked: the question on show, its own or the one that it answers. Nothing, after
    // errors() has why.
    std::string section(const Cue& cue, std::size_t number, const CueQuestion* asked) {
        auto scene = sceneOf(cue.state, m_folder);
        if (!scene) return fail(cue, scene.errors());
        const auto shared = std::make_shared<const pipeline::Scene>(std::move(scene).value());
        const auto tree = arrangementOf(cue.state.arrangement);
        if (!tree) return fail(cue, tree.errors());
        const auto moment = momentOf(cue, shared);
        if (!moment) return fail(cue, {Error{{}, "stopped", {}}});
        Beside beside = besideOf(cue, *moment, asked);
        const std::string views = viewsHtml(cue, *tree, shared, beside.room);
        if (!m_errors.empty()) return {};
        std::string html =
            fmt::format("<section class=\"cue\" id=\"cue-{}\" aria-labelledby=\"name-{}\">\n", number, number);
        html += fmt::format("<h2 id=\"name-{}\">{}</h2>\n", number, escapedHtml(cue.name)) + beside.above;
        html += fmt::format("<div class=\"body {}\"><div class=\"room\">{}</div>\n{}</div>\n", beside.kind, views,
                            beside.column);
        html += beside.below + "<p class=\"caption\"><b>" + escapedHtml(moment->label) + "</b> " +
                sentenceHtml(beside.caption) + "</p>\n";
        if (!cue.note.empty()) html += "<aside class=\"said\">" + escapedHtml(cue.note) + "</aside>\n";
        return html + "</section>\n";
    }
    const Errors& errors() const { return m_errors; }
    std::vector<std::string> leftOut;

private:
    // A cue's place in its frame.
    struct Shown {
        pipeline::FramePtr frame;                           // at the place
        std::string label;                                  // "Shading", "Z-buffer: polygon 2, row 270"
        std::optional<pipeline::AlgorithmState> algorithm;  // where the cue shows it and the stage has one
    };
    // What a cue has around its views, and the room that it leaves them.
    struct Beside {
        std::string_view kind = "plain";
        std::string above, column, below, caption;
        glm::ivec2 room = kScreen - glm::ivec2(0, kCaptionHeight);
    };

    // As the clean view shares its screen: a question with its choices, else the algorithm, else the equation.
    Beside besideOf(const Cue& cue, const Shown& shown, const CueQuestion* asked) {
        Beside beside;
        beside.caption = cue.caption.empty() ? cue.name : cue.caption;
        const auto giveWidth = [&](double share) { beside.room.x -= int(share * kScreen.x); };
        const bool asks = cue.ask.has_value();
        if (asked) {
            beside.kind = asks ? "asks" : "answers";
            beside.column = choicesHtml(*asked, !asks);
            giveWidth(asks ? kAskWidth : kAnswerWidth);
            beside.room.y -= asks ? kQuestionHeight : kAnswerHeight;
            if (!asks) beside.above = "<p class=\"asked\">" + sentenceHtml(asked->text) + "</p>\n";
            beside.above += "<p class=\"title\">" + sentenceHtml(asks ? asked->text : beside.caption) + "</p>\n";
            beside.caption = !asks ? std::string() : cue.caption.empty() ? kVoteByHand : cue.caption;
            if (cue.state.algorithm) leftOut.push_back(cue.name + ": the algorithm; the choices are in its place");
        } else if (cue.state.algorithm) {
            beside.kind = "steps";
            beside.column = shown.algorithm ? algorithmHtml(*shown.algorithm)
                                            : "<p class=\"why\">This stage has no algorithm.</p>\n";
            giveWidth(kAlgorithmWidth);
        }
        // A question has no numbers beside it.
        if (!asks && beside.kind != "steps") beside.below = equationOf(cue.state, *shown.frame);
        if (!beside.below.empty()) beside.room.y -= kEquationHeight;
        return beside;
    }

    std::string fail(const Cue& cue, const Errors& errors) {
        for (Error error : errors) {
            error.found = "cue " + pipeline::inQuotes(cue.name) + ": " + error.found;
            m_errors.push_back(std::move(error));
        }
        return {};
    }

    std::string viewsHtml(const Cue& cue, const ViewTree& tree, const std::shared_ptr<const pipeline::Scene>& scene,
                          glm::ivec2 room) {
        const std::vector<ViewLeaf> leaves = leavesOf(tree);
        const std::vector<glm::ivec2> sizes = viewSizes(tree, room);
        std::vector<std::string> drawn;
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            const glm::ivec2 size(sizes[i].x, std::max(1, sizes[i].y - kNameHeight));
            const auto picture = m_draw(cue.state, scene, leaves[i], {size, kGrowth}, m_stop);
            if (m_stop.stop_requested()) return fail(cue, {Error{{}, "stopped", {}}});
            // Inside a frame a buffer may be yet to come, and a machine may have no OpenGL: the rest is shown.
            std::string why = picture ? picture->leftOut : pipeline::format(picture.errors());
            while (why.ends_with('\n')) why.pop_back();
            std::vector<std::string> names = picture ? picture->names : std::vector<std::string>();
            if (names.empty()) names = {nameOf(cue.state, leaves[i])};
            if (!why.empty()) leftOut.push_back(cue.name + ": " + names.front() + ": " + why);
            std::string html = "<figcaption>";
            for (const std::string& name : names) html += "<span>" + sentenceHtml(name) + "</span>";
            html += "</figcaption>";
            if (picture)
                html += fmt::format("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\">{}",
                                    pipeline::imageSource("png", picture->png), size.x, size.y,
                                    escapedHtml(fmt::format("{}. {}", fmt::join(names, ", "), cue.caption)),
                                    legendHtml(picture->legend));
            if (!why.empty()) html += pipeline::element("p class=\"without\"", why);
            drawn.push_back(std::move(html));
        }
        std::size_t next = 0;
        std::string html;
        addViews(tree, drawn, next, html);
        return html;
    }

    // Nothing when stopped.
    std::optional<Shown> momentOf(const Cue& cue, const std::shared_ptr<const pipeline::Scene>& scene) {
        const pipeline::FrameRequest request{
            .wanted = pipeline::setOf({pipeline::BufferId::Color, pipeline::BufferId::PolygonId}), .stop = m_stop};
        Shown shown{runFrame(scene, request, nullptr), std::string(pipeline::stageInfo(cue.state.stage).label), {}};
        if (!shown.frame) return {};
        if (!cue.state.place && !cue.state.algorithm) return shown;
        const pipeline::Steps steps(shown.frame);
        pipeline::Moment moment{cue.state.stage, 0};
        if (cue.state.place) {
            moment = steps.momentOf(*cue.state.place);
            shown.label = pipeline::stageInfo(moment.stage).label;
            // The words may begin with the stage: "Z-buffer, done".
            const std::string words = steps.words(moment, cue.state.step);
            if (words.starts_with(shown.label))
                shown.label = words;
            else if (!words.empty())
                shown.label += ": " + words;
            shown.frame = steps.frameAt(moment, 0, m_stop);
            if (!shown.frame) return {};
        }
        if (cue.state.algorithm) shown.algorithm = steps.algorithmAt(moment);
        return shown;
    }

    // Of the picked pixel, as the clean view has it; empty where nothing is drawn, or before it is shaded.
    static std::string equationOf(const WindowState& state, const pipeline::Frame& frame) {
        if (!state.pixel || !frame.buffer({pipeline::BufferId::Color})) return {};
        const auto report = inspectPixel(frame, {(*state.pixel)[0], (*state.pixel)[1]});
        if (!report.covered) return {};
        return equationHtml(shortEquation(equation(frame.scene(), report, state.channel)));
    }

    const std::filesystem::path& m_folder;
    const DrawView& m_draw;
    pipeline::Stop m_stop;
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
    for (std::size_t i = 0; i < list.cues.size(); ++i) {
        const auto asks = asking(list, i);
        cues += writer.section(list.cues[i], i + 1, asks ? &*list.cues[*asks].ask : nullptr);
        if (stop.stop_requested()) return Error{{}, "stopped", {}};
        if (progress) progress(i + 1);
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
