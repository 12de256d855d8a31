#include "pipeline/compare/report/compare_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/compare/report/compare_html_style.h"
#include "pipeline/compare/report/compare_text.h"
#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/buffers/png_file.h"
#include "pipeline/export/html/formula_html.h"
#include "pipeline/export/html/html_text.h"
#include "pipeline/inspect/pixel_report.h"

namespace pipeline::foreign {

namespace {

std::string code(std::string_view text) { return element("code", text); }

std::string_view styleOf(Standing standing) {
    switch (standing) {
        case Standing::Agrees: return "run";
        case Standing::WrongHere: return "fail";
        case Standing::GivenInput:
        case Standing::CannotTell: return "warn";
        case Standing::NoFile: break;
    }
    return "t3";
}

std::string figure(const Buffer2D<Color8>& picture, const std::string& caption, std::string_view style = "") {
    const std::string alt = escapedHtml(caption);
    return fmt::format(
        "<figure{}><img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\" "
        "style=\"height:auto\"><figcaption>{}</figcaption></figure>\n",
        style.empty() ? "" : fmt::format(" class={}", style), imageSource("png", pngOf(picture)), alt, picture.size.x,
        picture.size.y, alt);
}

class Page {
public:
    Page(const Report& report, const std::string& command) : m_report(report), m_command(command) {}

    std::string html() {
        const Finding* const first = m_report.firstDifference();
        const bool told = m_report.options.hints >= 2 || m_report.agrees();
        begin();
        if (m_report.options.hints >= 1 || m_report.agrees()) stages();
        if (told && !m_report.broken.empty()) {
            m_html += "<h2>What must hold and does not</h2>\n";
            for (const BrokenContract& one : m_report.broken) m_html += element("p", contractText(one)) + "\n";
        }
        if (first && told) {
            shows(*first, "Where it shows first");
            const Finding* const color = pictureOf(BufferId::Color);
            worstPixel(first->isPicture() && first->worst ? *first : color && color->worst ? *color : *first);
            writeHints();
            if (color && color != first) shows(*color, "What follows from it");
        } else if (first) {
            writeHints();
        } else if (const Finding* const color = pictureOf(BufferId::Color)) {
            shows(*color, "Side by side");
        }
        conventions();
        restsOn();
        return std::move(m_html) +
               "</main><script>addEventListener(\"beforeprint\",()=>document.querySelectorAll(\"details\")"
               ".forEach(d=>d.open=true))</script></body></html>\n";
    }

private:
    const Finding* pictureOf(BufferId id) const {
        for (const Finding& finding : m_report.findings)
            if (finding.name.buffer.id == id) return &finding;
        return nullptr;
    }
    const Values& rightOf(const Finding& finding) const {
        return m_report.reference->values.at(finding.name.buffer.text());
    }

    void begin() {
        const std::string title = headline(m_report), scene = m_report.scene->name;
        m_html =
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
            "<meta name=\"color-scheme\" content=\"light dark\">\n";
        m_html += element("title", fmt::format("{} compared with {}: {}", m_report.given, scene, title)) + "\n<style>" +
                  std::string(formulaStyle()) + std::string(kReportStyle) + "</style>\n</head>\n<body>\n<main>\n";
        const bool fine = m_report.agrees();
        m_html += fmt::format("<h1><span class=\"mark {}\">{}</span><span>{}</span></h1>\n", fine ? "run" : "fail",
                              fine ? "✓" : "✗", escapedHtml(title));
        m_html +=
            fmt::format("<p class=t2>{} compared with {}, {} × {}. {} read. Shadescope {}.</p>\n", code(m_report.given),
                        code(scene), m_report.scene->settings.width, m_report.scene->settings.height,
                        plural(std::int64_t(m_report.findings.size()), "file"), escapedHtml(programVersion()));
        if (const std::string why = evidence(m_report); !why.empty() && (fine || m_report.options.hints >= 2))
            m_html += element("p", why) + "\n";
    }

    void stages() {
        m_html +=
            "<h2>Stages</h2>\n<table class=stages><thead><tr><th></th><th>Stage</th><th>Finding</th><th>Buffers and "
            "largest difference</th><th class=n>Tolerance</th></tr></thead>\n";
        for (const StageVerdict& stage : m_report.stages) {
            std::string found, tolerances;
            for (const std::size_t i : stage.findings) {
                const Finding& finding = m_report.findings[i];
                found +=
                    (found.empty() ? "" : "<br>") + code(finding.name.text()) + " " + escapedHtml(findingText(finding));
                tolerances += (tolerances.empty() ? "" : "<br>") + escapedHtml(toleranceText(finding));
            }
            if (!stage.own.empty()) found += (found.empty() ? "" : "<br>") + escapedHtml(stage.own);
            const std::string_view style = styleOf(stage.standing);
            m_html += fmt::format(
                "<tr{}><td class=\"{} mark\">{}</td><td><span class=t3>{}</span>&ensp;{}</td>"
                "<td class={}>{}</td><td>{}</td><td class=n>{}</td></tr>\n",
                m_report.firstWrong == stage.stage ? " class=first" : "", style, mark(stage.standing, false),
                index(stage.stage) + 1, escapedHtml(stageInfo(stage.stage).label), style, words(stage.standing), found,
                tolerances);
        }
        m_html += "</table>\n";
    }

    void shows(const Finding& finding, std::string_view heading) {
        m_html += fmt::format("<h2>{}: {}</h2>\n", heading, code(finding.name.text()));
        m_html += element("p class=t2", findingText(finding) + ".") + "\n";
        if (!finding.isPicture()) return elements(finding);
        const PicturePair pair = picturesOf(m_report, finding);
        m_html += "<div class=four>" + figure(pair.mine, "mine") + figure(pair.reference, "reference") +
                  figure(differencePicture(m_report, finding),
                         fmt::format("difference, 0 to {}{}{}", shortNumber(finding.largest),
                                     finding.unit.empty() ? "" : " ", finding.unit)) +
                  figure(classPicture(finding, pair.reference), "by classes", "classes") + "</div>\n<div class=legend>";
        for (const Class of :
             {Class::Equal, Class::Tolerated, Class::Allowed, Class::Wrong, Class::Missing, Class::Extra}) {
            const Color8 color = classColor(of);
            m_html += fmt::format("<span{}><i style=\"background:#{:02X}{:02X}{:02X}\"></i>{} <b class=n>{}</b></span>",
                                  finding.count(of) == 0 ? " class=off" : "", color[0], color[1], color[2], name(of),
                                  finding.count(of));
        }
        m_html += "</div>\n";
        if (finding.name.buffer.id != BufferId::Color) return;
        m_html += fmt::format(
            "<div class=wipebox><div class=wipe id=wipe><img src=\"{}\" alt=\"reference\"><img class=top "
            "src=\"{}\" alt=\"mine\"></div><label class=slide>mine <input type=range value=50 "
            "oninput=\"document.getElementById('wipe').style.setProperty('--w',value+'%')\"> reference</label></div>\n",
            imageSource("png", pngOf(pair.reference)), imageSource("png", pngOf(pair.mine)));
    }

    // Of vertices or polygons the first of those that differ.
    void elements(const Finding& finding) {
        constexpr std::size_t kMostRows = 12;
        m_html += "<table class=small><tr><th></th><th class=n>mine</th><th class=n>reference</th></tr>\n";
        std::size_t rows = 0;
        const auto row = [&](std::size_t i) {
            m_html +=
                fmt::format("<tr><td>{}</td><td class=n><span class=differs>{}</span></td><td class=n>{}</td></tr>\n",
                            placeText(finding, i), escapedHtml(mineText(m_report, finding, i)),
                            escapedHtml(valueText(finding, rightOf(finding), i)));
            ++rows;
        };
        if (finding.worst) row(*finding.worst);
        for (std::size_t i = 0; i < finding.classes.size() && rows < kMostRows; ++i)
            if (finding.classes[i] >= Class::Wrong && finding.classes[i] != Class::Left && i != finding.worst) row(i);
        m_html += "</table>\n";
    }

    void worstPixel(const Finding& finding) {
        if (!finding.worst || !finding.isPicture()) return;
        const std::size_t at = *finding.worst;
        const glm::ivec2 pixel(int(at % finding.columns), int(at / finding.columns));
        m_html += fmt::format("<h2>The worst pixel of {}: {}, {}</h2>\n", code(finding.name.text()), pixel.x, pixel.y);
        const PixelReport report = inspectShading(*m_report.reference->frame, pixel);
        if (!report.covered) {
            m_html += "<p>The reference draws nothing here.</p>\n";
        } else {
            // The channel that differs most.
            int channel = 0;
            const Values& mine = m_report.fileOf(finding).mine;
            if (finding.name.buffer.id == BufferId::Color)
                for (int c = 1; c < 3; ++c)
                    if (std::abs(mine.at(at)[c] - rightOf(finding).at(at)[c]) >
                        std::abs(mine.at(at)[channel] - rightOf(finding).at(at)[channel]))
                        channel = c;
            const auto& object = m_report.scene->objects[std::size_t(report.object)];
            m_html += fmt::format("<p class=t2>Polygon {} of <i>{}</i>. The equation of the reference for {}:</p>\n",
                                  report.polygon, escapedHtml(object.name),
                                  channel == 0   ? "red"
                                  : channel == 1 ? "green"
                                                 : "blue");
            m_html += "<div class=formula>";
            for (const EquationLine& line : equation(m_report.reference->frame->scene(), report, channel))
                if (line.role != "row") m_html += toHtml(line.formula) + "<br>\n";
            m_html += "</div>\n";
        }
        m_html += "<table class=small><tr><th></th><th class=n>mine</th><th class=n>reference</th></tr>\n";
        std::string firstDiffers;
        for (const Finding& other : m_report.findings) {
            if (!other.isPicture()) continue;
            const Class of = other.classes[at];
            const bool differs = of == Class::Wrong || of == Class::Missing || of == Class::Extra;
            if (differs && firstDiffers.empty()) firstDiffers = other.name.text();
            m_html +=
                fmt::format("<tr><td>{}</td><td class=n>{}{}{}</td><td class=n>{}</td></tr>\n", code(other.name.text()),
                            differs ? "<span class=differs>" : "", escapedHtml(mineText(m_report, other, at)),
                            differs ? "</span>" : "", escapedHtml(valueText(other, rightOf(other), at)));
        }
        m_html += "</table>\n";
        if (!firstDiffers.empty())
            m_html += fmt::format("<div class=note>First difference here: {}.</div>\n", code(firstDiffers));
    }

    void writeHints() {
        const std::vector<std::string> all = hints(m_report);
        if (all.empty()) return;
        m_html += "<h2>Hints</h2>\n";
        constexpr std::array<std::string_view, 3> kNames{"the stage", "the buffer and the place",
                                                         "the name of the error, and the line"};
        for (std::size_t i = 0; i < std::min<std::size_t>(2, all.size()); ++i)
            m_html += fmt::format("<details><summary>Hint {} <span>{}</span></summary><div>{}</div></details>\n", i + 1,
                                  kNames[i], escapedHtml(all[i]));
        if (m_report.options.hints < 3 || !m_report.suspects) return;
        m_html += fmt::format("<details><summary>Hint 3 <span>{}</span></summary><div>", kNames[2]);
        const Suspects& suspects = *m_report.suspects;
        m_html += element("p", namesText(m_report));
        for (const Candidate& one : suspects.candidates) {
            m_html += fmt::format(
                "<p><b>{}</b> {} {:.1f} % of the difference{}.</p><p><span class=differs>{}</span> in place of "
                "{}</p>",
                escapedHtml(one.error.name), suspects.areTogether ? "and the other explain" : "explains",
                100 * one.explained, one.otherRows ? ", if the rows run the other way" : "",
                escapedHtml(one.error.wrong), escapedHtml(one.error.right));
            if (!one.error.lesson.empty())
                m_html += fmt::format("<p class=t2>Lesson {}, page “{}”.</p>", escapedHtml(one.error.lesson),
                                      escapedHtml(one.error.heading));
        }
        if (suspects.next && suspects.candidates.size() == 1)
            m_html +=
                fmt::format("<p class=t2>The next of {} known errors, {}, explains {:.0f} %.</p>", suspects.tried,
                            escapedHtml(suspects.next->error.name), 100 * std::max(0.0, suspects.next->explained));
        if (suspects.experiment) {
            std::string text = fmt::format("To tell them apart, print {} of {}: ", suspects.experiment->place,
                                           suspects.experiment->buffer);
            for (std::size_t i = 0; i < suspects.experiment->values.size(); ++i)
                text += fmt::format("{}{} means {}", i ? ", " : "", suspects.experiment->values[i],
                                    suspects.candidates[i].error.name);
            m_html += element("p class=note", text + ".");
        }
        m_html += "</div></details>\n";
    }

    void conventions() {
        if (m_report.conventions.said.empty()) return;
        m_html +=
            "<h2>Conventions</h2><p class=t2>Read as such, not counted as errors. To fix them, write the third column "
            "into <code>mine.toml</code>.</p>\n<table class=small><tr><th>File</th><th>Read as</th>"
            "<th>mine.toml</th><th class=n>Closer than the next reading</th></tr>\n";
        for (const Convention& one : m_report.conventions.said)
            m_html += fmt::format(
                "<tr><td>{}</td><td>{}</td><td>{}</td><td class=n>{}</td></tr>\n", code(one.buffer),
                escapedHtml(one.words),
                isAdvised(m_report, one) ? code(fmt::format("{} = \"{}\"", one.key, one.value)) : std::string(),
                escapedHtml(certaintyText(one)));
        m_html += "</table>\n";
    }

    void restsOn() {
        std::size_t allowed = 0;
        for (const Finding& finding : m_report.findings) allowed = std::max(allowed, finding.count(Class::Allowed));
        m_html +=
            "<h2>What this page rests on</h2>\n<p class=t2>Pixels at a border between polygons, and near the edge of a "
            "shadow, may differ between right renderers. ";
        m_html += fmt::format("At most {} px of a buffer are allowed for that reason.", allowed);
        const std::vector<std::string> missing = m_report.notHandedIn();
        if (!missing.empty())
            m_html += fmt::format(" Not handed in: {}.", escapedHtml(fmt::format("{}", fmt::join(missing, ", "))));
        m_html += "</p>\n";
        for (const std::string& other : m_report.in->others) m_html += element("p class=t2", other + ".") + "\n";
        for (const Error& error : m_report.in->errors) m_html += element("p class=warn", format(error)) + "\n";
        m_html += element("pre", m_command) + "\n";
    }

    const Report& m_report;
    const std::string& m_command;
    std::string m_html;
};

}  // namespace

std::string reportHtml(const Report& report, const std::string& command) { return Page(report, command).html(); }

}  // namespace pipeline::foreign
