#include "lessons/pages/manual_page.h"

#include <md4c-html.h>

namespace lessons {

namespace {

void appendTo(const MD_CHAR* text, MD_SIZE size, void* to) { static_cast<std::string*>(to)->append(text, size); }

// The words of an element's inside.
std::string wordsOf(std::string_view html) {
    std::string words;
    bool inTag = false;
    for (const char c : html) {
        if (c == '<') inTag = true;
        if (!inTag) words += c;
        if (c == '>') inTag = false;
    }
    return words;
}

// The value of the attribute that ends `tag`'s beginning: `start` is behind its quote.
std::string_view valueAt(std::string_view html, std::size_t start) {
    return html.substr(start, html.find('"', start) - start);
}

}  // namespace

// github.com/gjtorikian/html-pipeline, TableOfContentsFilter: small letters, digits, "_" and "-" stay, a space is "-".
std::string headingId(std::string_view words) {
    std::string id;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const char c = words[i];
        if (c == '&') {  // an entity stands for a sign
            i = std::min(words.find(';', i), words.size() - 1);
            continue;
        }
        if (c >= 'A' && c <= 'Z')
            id += char(c - 'A' + 'a');
        else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-')
            id += c;
        else if (c == ' ')
            id += '-';
    }
    return id;
}

std::string manualHtml(std::string_view markdown, const LinkAddress& address) {
    std::string html;
    md_html(markdown.data(), MD_SIZE(markdown.size()), appendTo, &html, MD_DIALECT_GITHUB, 0);
    std::string out;
    bool isLink = true;  // the link that is open has an address
    for (std::size_t at = 0; at < html.size();) {
        const std::string_view rest = std::string_view(html).substr(at);
        const bool isHeading =
            rest.size() > 3 && rest[0] == '<' && rest[1] == 'h' && rest[2] >= '1' && rest[2] <= '6' && rest[3] == '>';
        constexpr std::string_view kLink = "<a href=\"", kPicture = "<img src=\"", kEnd = "</a>";
        if (isHeading) {
            const std::size_t end = rest.find("</h");
            out.append(rest.substr(0, 3))
                .append(" id=\"")
                .append(headingId(wordsOf(rest.substr(4, end - 4))))
                .append("\">");
            at += 4;
        } else if (rest.starts_with(kLink) || rest.starts_with(kPicture)) {
            const std::string_view start = rest.starts_with(kLink) ? kLink : kPicture,
                                   was = valueAt(rest, start.size());
            const std::string to = address(was);
            isLink = !to.empty();
            const std::size_t end = start.size() + was.size();
            if (isLink) {
                out.append(start).append(to);
                at += end;
            } else {
                at += rest.find('>', end) + 1;
            }
        } else if (rest.starts_with(kEnd) && !isLink) {
            isLink = true, at += kEnd.size();
        } else {
            out += html[at++];
        }
    }
    return out;
}

}  // namespace lessons
