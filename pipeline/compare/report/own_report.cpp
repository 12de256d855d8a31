#include "pipeline/compare/report/own_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/compare/report/compare_html_style.h"
#include "pipeline/core/text.h"
#include "pipeline/defects/own_words.h"
#include "pipeline/export/buffers/png_file.h"
#include "pipeline/export/html/html_text.h"
#include "pipeline/run/frame_data.h"

namespace pipeline::foreign {
namespace {

std::string pageText(const OwnContract& contract) {
    return fmt::format("lesson {}, page \"{}\"", contract.lesson, contract.heading);
}

// Which of several lights a call is of, as its arguments tell: by the light's position or intensity.
std::optional<std::size_t> lightOf(const OwnReport& report, const OwnElement& element) {
    const auto taken = report.contract().taken();
    const auto arguments = OwnArguments::read(taken, element.in);
    const std::vector<Light>& lights = report.right->scene().lights;
    const bool isLit = std::ranges::find(taken, "L", &OwnParameter::name) != taken.end();
    std::optional<std::size_t> found;
    for (std::size_t i = 0; arguments && i < taken.size(); ++i) {
        const bool isPlace = taken[i].name == "pL";
        if (!isPlace && !(isLit && taken[i].name == "I")) continue;
        for (std::size_t k = 0; k < lights.size() && lights.size() > 1; ++k) {
            if (arguments->v(i) != (isPlace ? lights[k].position : lights[k].intensity * lights[k].color)) continue;
            if (found) return {};
            found = k;
        }
    }
    return found;
}

// "pixel 12, 7, light 1"
std::string placeIn(const OwnReport& report, std::size_t i) {
    const OwnElement& element = report.elements[i];
    const std::string place = placeText(element, i, report.right->scene().settings.width);
    const auto light = lightOf(report, element);
    return light ? fmt::format("{}, light {}", place, *light) : place;
}

std::string shownAs(const Buffer2D<Color8>& picture, std::string_view caption) {
    return fmt::format(
        "<figure><img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\" style=\"height:auto\">{}</figure>\n",
        imageSource("png", pngOf(picture)), escapedHtml(caption), picture.size.x, picture.size.y,
        element("figcaption", caption));
}

const Buffer2D<Color8>& colorOf(const Frame& frame) { return dataOf<double>(frame)->shading->color; }

// White where two pictures are equal.
Buffer2D<Color8> differenceBetween(const Buffer2D<Color8>& a, const Buffer2D<Color8>& b) {
    Buffer2D<Color8> out(a.size, Color8(255));
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        int largest = 0;
        for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(int(a.pixels[i][c]) - int(b.pixels[i][c])));
        if (largest > 0) out.pixels[i] = Color8(196, 71, 27) + Color8(std::uint8_t((255 - largest) / 5));
    }
    return out;
}

}  // namespace

std::string headline(const OwnReport& report) {
    const OwnContract& contract = report.contract();
    const OwnVerdict& verdict = report.verdict;
    if (verdict.isRight()) return fmt::format("Right: all {} results of {} agree.", verdict.all, contract.name);
    if (report.hints >= 3 && verdict.names.size() == 1)
        return fmt::format("{}{}: {} of {} results of {} differ.", char(std::toupper(verdict.names[0]->name[0])),
                           verdict.names[0]->name.substr(1), verdict.wrong, verdict.all, contract.name);
    return fmt::format("Not yet: {} of {} results of {} differ.", verdict.wrong, verdict.all, contract.name);
}

std::vector<std::string> ownText(const OwnReport& report) {
    const OwnContract& contract = report.contract();
    std::vector<std::string> lines{headline(report)};
    if (report.verdict.first && report.hints >= 2) {
        const std::size_t first = *report.verdict.first;
        const OwnElement& element = report.elements[first];
        lines.push_back(fmt::format("The first is {}: {} returns {}, expected {}.", placeIn(report, first),
                                    contract.name, resultText(contract, report.mine[first]),
                                    resultText(contract, element.right)));
        for (const std::string& text : argumentTexts(contract, element)) lines.push_back("    " + text);
    }
    if (report.verdict.first && report.hints >= 3) {
        for (const OwnMistake* const name : report.verdict.names)
            lines.push_back(fmt::format("{}: {} ({}).",
                                        report.verdict.names.size() > 1 ? "One of these" : "The mistake", name->name,
                                        name->id));
        lines.push_back(fmt::format("Hint: {}", contract.hint));
        lines.push_back(fmt::format("Read {}.", pageText(contract)));
    }
    if (report.isCut) lines.push_back(fmt::format("Only the first {} calls were handed over.", report.elements.size()));
    if (report.notAsked > 0)
        lines.push_back(fmt::format("In {} further calls of the picture the right results stand in.", report.notAsked));
    return lines;
}

std::string ownHtml(const OwnReport& report) {
    const OwnContract& contract = report.contract();
    const bool isRight = report.verdict.isRight();
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width\">\n<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
        "img-src "
        "data:; style-src 'unsafe-inline'\">\n{}\n<style>{}</style>\n</head>\n<body>\n<main>\n",
        element("title", fmt::format("{}: {}", contract.name, report.scene)), kReportStyle);
    html += fmt::format("<h1><span class=\"mark {}\">{}</span>{}</h1>\n", isRight ? "run" : "fail", isRight ? "●" : "△",
                        escapedHtml(headline(report)));
    html += element("p class=t2", fmt::format("{} in {}: {}. {}.", signatureOf(contract), report.scene, contract.result,
                                              fmt::format("{:.2f} s in the program", report.seconds))) +
            "\n";
    const std::vector<std::string> lines = ownText(report);
    for (std::size_t i = 1; i < lines.size(); ++i)
        html += element(lines[i].starts_with("    ") ? "pre" : "p", lines[i]) + "\n";
    if (report.yours && report.right) {
        const Buffer2D<Color8>&mine = colorOf(*report.yours), &right = colorOf(*report.right);
        html += "<h2>The picture</h2>\n<div class=four>\n";
        html += shownAs(mine, "Yours"), html += shownAs(right, "Right");
        html += mine.pixels == right.pixels
                    ? element("p", "The pictures are equal. The numbers above decide.") + "</div>\n"
                    : shownAs(differenceBetween(mine, right), "Where they differ: the darker, the more") + "</div>\n";
    }
    if (!isRight && report.hints >= 2) {
        html +=
            "<h2>The first results that differ</h2>\n<table class=small><tr><th>Where</th><th>Arguments</th><th>Yours"
            "</th><th>Expected</th></tr>\n";
        constexpr std::size_t kRows = 10;
        std::size_t shown = 0;
        for (std::size_t i = *report.verdict.first; i < report.elements.size() && shown < kRows; ++i) {
            const OwnElement& one = report.elements[i];
            if (differenceOf(contract, report.mine[i], one.right) <= contract.tolerance) continue;
            html += fmt::format("<tr>{}{}{}{}</tr>\n", element("td", placeIn(report, i)),
                                element("td", fmt::format("{}", fmt::join(argumentTexts(contract, one), "; "))),
                                element("td class=differs", resultText(contract, report.mine[i])),
                                element("td", resultText(contract, one.right)));
            ++shown;
        }
        html += "</table>\n";
    }
    if (!report.messages.empty())
        html += fmt::format("<h2>Messages of the program</h2>\n{}\n", element("pre", report.messages));
    return html + element("pre", report.command) + "\n</main>\n</body>\n</html>\n";
}

Json ownJson(const OwnReport& report, int status) {
    const OwnContract& contract = report.contract();
    Json names = Json::array();
    for (const OwnMistake* const name : report.verdict.names)
        names.push_back(Json{{"id", name->id}, {"name", name->name}});
    Json out{{"function", contract.name},
             {"scene", report.scene},
             {"status", status},
             {"agrees", report.verdict.isRight()},
             {"calls", report.verdict.all},
             {"differ", report.verdict.wrong},
             {"mistakes", names},
             {"lesson", contract.lesson},
             {"heading", contract.heading}};
    if (report.verdict.first) {
        const std::size_t first = *report.verdict.first;
        out["first"] = Json{{"place", placeIn(report, first)},
                            {"arguments", report.elements[first].in},
                            {"expected", resultText(contract, report.elements[first].right)},
                            {"returned", resultText(contract, report.mine[first])}};
    }
    return out;
}

}  // namespace pipeline::foreign
