#include "lessons/grading/class_page.h"

#include <fmt/format.h>

#include "lessons/pages/handout_figure.h"
#include "pipeline/core/version.h"
#include "pipeline/export/html/html_text.h"

namespace lessons {

namespace {

constexpr std::string_view kClassStyle = R"(
section { margin-top: 2rem; padding-top: 1.25rem; border-top: 1px solid #D0D5DC; }
.number { text-align: right; } .remark, footer { color: #4A525D; font-size: .875rem; }
table { border-collapse: collapse; } th, td { padding: .25rem .75rem .25rem 0; text-align: left; vertical-align: top; }
th { border-bottom: 1px solid #171A1F; } td { border-bottom: 1px solid #D0D5DC; }
.bar { display: inline-block; width: 8rem; height: .6rem; background: #E3E8EE; } .bar span { display: block; height: 100%; background: #137244; }
footer { margin-top: 3rem; }
@media print { main { max-width: none; padding: 0; } body { font-size: 11pt; } tr, li { break-inside: avoid; } }
)";

}  // namespace

std::string percent(std::size_t part, std::size_t all) {
    return all == 0 ? "–" : fmt::format("{:.0f} %", 100.0 * double(part) / double(all));
}

std::string shareBar(std::size_t part, std::size_t all) {
    const double share = all == 0 ? 0 : 100.0 * double(part) / double(all);
    return fmt::format("<span class=bar><span style=\"width: {:.0f}%\"></span></span> {}", share, percent(part, all));
}

std::string classSection(std::string_view heading, const std::string& body) {
    return "<section>\n" + pipeline::element("h2", heading) + '\n' + body + "</section>\n";
}

std::string classTable(std::string_view head, const std::string& rows) {
    if (rows.empty()) return {};
    return fmt::format("<table><thead><tr>{}</tr></thead><tbody>\n{}</tbody></table>\n", head, rows);
}

std::string classPage(std::string_view title, std::string_view heading, const std::string& body) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{}</title>\n<style>{}{}</style>\n</head>\n"
        "<body>\n<main>\n<h1>{}</h1>\n{}<footer>Shadescope {}</footer>\n</main>\n</body>\n</html>\n",
        pipeline::escapedHtml(title), paperStyle(), kClassStyle, pipeline::escapedHtml(heading), body,
        pipeline::escapedHtml(pipeline::programVersion()));
}

}  // namespace lessons
