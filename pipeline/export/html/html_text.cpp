#include "pipeline/export/html/html_text.h"

#include <fmt/format.h>

namespace pipeline {

std::string escapedHtml(std::string_view text) {
    std::string html;
    for (const char c : text) {
        switch (c) {
            case '&': html += "&amp;"; break;
            case '<': html += "&lt;"; break;
            case '>': html += "&gt;"; break;
            case '"': html += "&quot;"; break;
            case '\'': html += "&#39;"; break;
            default: html += c;
        }
    }
    return html;
}

std::string element(std::string_view tag, std::string_view text) {
    return fmt::format("<{}>{}</{}>", tag, escapedHtml(text), tag.substr(0, tag.find(' ')));
}

}  // namespace pipeline
