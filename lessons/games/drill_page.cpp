// The drill on paper: two pages in HTML 5 without scripts that need nothing else.
#include <algorithm>

#include <fmt/format.h>

#include "lessons/games/drill.h"
#include "lessons/pages/handout_figure.h"
#include "pipeline/core/version.h"
#include "pipeline/export/folder/staging.h"
#include "pipeline/export/html/formula_html.h"
#include "pipeline/export/html/html_text.h"
#include "pipeline/inspect/formula_parts.h"
#include "pipeline/inspect/pixel_report.h"

namespace lessons {

namespace {

using pipeline::element;

constexpr std::string_view kDrillStyle = R"(
section { margin-top: 2rem; padding-top: 1.25rem; border-top: 1px solid #D0D5DC; break-inside: avoid; }
.blank { display: inline-block; min-width: 9rem; border-bottom: 1px solid #171A1F; }
.equation { margin: .75rem 0; padding: .5rem .75rem; border-left: 3px solid #1B57BD; break-inside: avoid; }
.equation p { margin: .15rem 0; } .equation .more { padding-left: 1.5rem; } .remark { color: #4A525D; font-size: .875rem; }
footer { margin-top: 3rem; color: #4A525D; font-size: .875rem; }
@media print { main { max-width: none; padding: 0; } body { font-size: 11pt; } figure { break-inside: avoid; } }
)";

std::string pageOf(const std::string& title, const std::string& about, const std::string& body) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" "
        "content=\"width=device-width\">\n{}\n<style>{}{}{}{}</style>\n</head>\n<body>\n<main>\n"
        "{}\n{}\n{}<footer>Shadescope {}</footer>\n</main>\n</body>\n</html>\n",
        element("title", title), paperStyle(), kDrillStyle, pipeline::formulaStyle(), figureStyle(),
        element("h1", title), element("p", about), body, pipeline::escapedHtml(pipeline::programVersion()));
}

std::string letterOf(std::size_t i) { return std::string(1, char('A' + i)); }

// The channel in which the colours of two pictures differ most there.
int channelOf(const DrillRound& round) {
    const auto x = std::size_t(round.pixel.x), y = std::size_t(round.pixel.y);
    std::array<double, 3> apart{};
    for (int c = 0; c < 3; ++c) {
        double low = 255, high = 0;
        for (const DrillRound::Picture& picture : round.pictures) {
            const double value = picture.frame->buffer({pipeline::BufferId::Color})->value(x, y, c);
            low = std::min(low, value), high = std::max(high, value);
        }
        apart[std::size_t(c)] = high - low;
    }
    return int(std::ranges::max_element(apart) - apart.begin());
}

std::string equationOf(const DrillRound& round, const pipeline::Frame& frame) {
    std::string html;
    for (const pipeline::EquationLine& line :
         equation(frame.scene(), inspectPixel(frame, round.pixel), channelOf(round))) {
        const bool goesOn = line.role == "numbers" || line.role == "result";
        html += goesOn ? "<p class=more>" : "<p>";
        html += toHtml(line.formula);
        if (!line.remark.empty()) html += ' ' + element("span class=remark", line.remark);
        html += "</p>\n";
    }
    return html;
}

}  // namespace

DrillPages drillPages(std::uint64_t seed, std::span<const DrillRound> rounds) {
    std::string questions, answers;
    const std::vector<pipeline::BufferName> color{{pipeline::BufferId::Color}};
    for (std::size_t number = 0; number < rounds.size(); ++number) {
        const DrillRound& round = rounds[number];
        const std::string heading = element("h2", fmt::format("{} {}", number + 1, round.title));
        std::vector<std::string> values;
        for (const DrillRound::Picture& picture : round.pictures) values.push_back(picture.value);
        std::ranges::sort(values);  // the places must not tell
        // The same part of all of them, that of all they draw.
        pipeline::Tile part = partToShow(*round.pictures.front().frame, color, round.pixel);
        for (const DrillRound::Picture& picture : round.pictures) {
            const pipeline::Tile own = partToShow(*picture.frame, color, round.pixel);
            part = {glm::min(part.min, own.min), glm::max(part.max, own.max)};
        }
        std::string shown, solved, blanks, named, equations;
        for (std::size_t i = 0; i < round.pictures.size(); ++i) {
            const auto& [value, frame] = round.pictures[i];
            shown += figureHtml(*frame, color.front(), part, {}, {}, letterOf(i));
            solved += figureHtml(*frame, color.front(), part, round.pixel, {}, letterOf(i) + ": " + value);
            blanks += element("b", letterOf(i)) + " <span class=blank>&nbsp;</span> ";
            named += element("b", letterOf(i)) + ' ' + pipeline::escapedHtml(value) + ' ';
            equations += "<div class=equation>" + element("p class=remark", letterOf(i) + ": " + value) + '\n' +
                         equationOf(round, *frame) + "</div>\n";
        }
        questions += "<section>\n" + heading + "<div class=pictures>\n" + shown + "</div>\n" +
                     element("p", fmt::format("{} ({})", round.kind->asked, fmt::join(values, ", "))) + "\n<p>" +
                     blanks + "</p>\n</section>\n";
        answers +=
            "<section>\n" + heading + "<div class=pictures>\n" + solved + "</div>\n<p>" + named + "</p>\n" +
            element("p", fmt::format("Pixel {}, {} (the ring) gives it away, in {}. {} differ visibly at {:.1f} % "
                                     "of what is drawn, or more.",
                                     round.pixel.x, round.pixel.y,
                                     std::array{"red", "green", "blue"}[std::size_t(channelOf(round))],
                                     round.pictures.size() == 2 ? "The pictures" : "Any two of the pictures",
                                     100 * round.share)) +
            '\n' + equations + "</section>\n";
    }
    const std::string about = fmt::format("Seed {}. In each round the pictures differ in one setting alone.", seed);
    return {pageOf("Spot the technique", about, questions), pageOf("Spot the technique: answers", about, answers)};
}

std::vector<std::string> drillFiles() { return {"drill-answers.html", "drill.html"}; }

pipeline::Result<std::vector<std::string>> writeDrill(const DrillPages& pages, const std::filesystem::path& folder) {
    const std::vector<std::string> names = drillFiles();
    return pipeline::writeFiles({{names[0], pages.answers}, {names[1], pages.questions}}, folder);
}

}  // namespace lessons
