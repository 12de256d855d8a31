#include "lessons/pages/prose_html.h"

#include <md4c-html.h>

#include <algorithm>

#include "pipeline/export/html/formula_html.h"
#include "pipeline/export/html/html_text.h"
#include "pipeline/inspect/formula_parts.h"

namespace lessons {

namespace {

using pipeline::VectorCode;

void append(const MD_CHAR* text, MD_SIZE size, void* to) { static_cast<std::string*>(to)->append(text, size); }

// Letters of other alphabets count: ρ_0. So do ends of elements, for what they end may be a letter: <em>k</em>_b.
bool mayHaveScript(char before) {
    const auto byte = static_cast<unsigned char>(before);
    return before == ')' || byte >= 0x80 || (before >= 'a' && before <= 'z') || (before >= 'A' && before <= 'Z');
}

bool isWord(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

// I_max, (R·V)^n; not in code, and not in what stands between < and >.
std::string raiseScripts(std::string_view html) {
    std::string out;
    char before = ' ';
    int code = 0;  // how many elements of code are open
    for (std::size_t at = 0; at < html.size();) {
        if (html[at] == '<') {
            const std::string_view tag = html.substr(at, std::min(html.find('>', at), html.size() - 1) - at + 1);
            code += tag.starts_with("<code") ? 1 : tag == "</code>" ? -1 : 0;
            out += tag, at += tag.size();
            continue;
        }
        std::size_t end = at + 1;
        while (end < html.size() && isWord(html[end])) ++end;
        const bool isScript =
            code == 0 && (html[at] == '_' || html[at] == '^') && end > at + 1 && mayHaveScript(before);
        if (isScript) {
            const std::string_view name = html[at] == '_' ? "sub" : "sup";
            out.append("<").append(name).append(">").append(html.substr(at + 1, end - at - 1));
            out.append("</").append(name).append(">");
            before = html[end - 1], at = end;
            continue;
        }
        before = html[at];
        out += html[at++];
    }
    return out;
}

// ***N*** in the vectors' code.
std::string markVectors(std::string html) {
    for (const VectorCode code : {VectorCode::N, VectorCode::L, VectorCode::V, VectorCode::R, VectorCode::H}) {
        const pipeline::Formula vector = pipeline::vector(code);
        const std::string typed = "<em><strong>" + vector.text + "</strong></em>", marked = toHtml(vector);
        for (auto at = html.find(typed); at != html.npos; at = html.find(typed, at + marked.size()))
            html.replace(at, typed.size(), marked);
    }
    return html;
}

// An attribute's value as md4c writes it, with its four entities read.
std::string unescaped(std::string_view value) {
    constexpr std::pair<std::string_view, char> kEntities[]{
        {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}};
    std::string text;
    while (!value.empty()) {
        const auto found =
            std::ranges::find_if(kEntities, [&](const auto& entity) { return value.starts_with(entity.first); });
        const bool isEntity = found != std::end(kEntities);
        text += isEntity ? found->second : value.front();
        value.remove_prefix(isEntity ? found->first.size() : 1);
    }
    return text;
}

// A lesson is data: opening its page runs nothing and asks no network. Its own pictures stand in the page, others give way
// to their words; a link that leaves the lesson's folder keeps its words alone.
std::string withoutForeign(std::string_view html, Pictures& pictures, pipeline::Errors& leftOut) {
    constexpr std::string_view kLink = "<a href=\"", kPicture = "<img src=\"", kWords = " alt=\"";
    std::string out;
    while (!html.empty()) {
        const std::size_t tag = std::min(html.find(kLink), html.find(kPicture));
        out += html.substr(0, tag);
        if (tag == html.npos) break;
        html.remove_prefix(tag);
        const bool isLink = html.starts_with(kLink);
        const std::string_view rest = html.substr((isLink ? kLink : kPicture).size());
        const std::string address = unescaped(rest.substr(0, rest.find('"')));
        const std::string_view whole = html.substr(0, html.find('>') + 1);
        html.remove_prefix(whole.size());
        if (isLink) {
            out += linkTarget(address) == LinkTarget::None ? "<a>" : whole;
            continue;
        }
        const std::size_t alt = std::min(whole.find(kWords), whole.size() - kWords.size()) + kWords.size();
        const std::string_view words = whole.substr(alt, whole.find('"', alt) - alt);
        const auto picture = pictures.read(address);
        if (picture) {
            out.append("<img src=\"").append(pipeline::imageSource(picture->type, picture->bytes));
            out.append("\" alt=\"").append(words).append("\">");
        } else {
            out += words;
            leftOut.push_back(picture.errors().front());
        }
    }
    return out;
}

}  // namespace

std::string proseHtml(std::string_view markdown, Pictures& pictures, pipeline::Errors& leftOut) {
    std::string html;
    constexpr unsigned kFlags = MD_FLAG_TABLES | MD_FLAG_STRIKETHROUGH | MD_FLAG_NOHTML;
    if (md_html(markdown.data(), MD_SIZE(markdown.size()), append, &html, kFlags, 0) != 0) return {};  // no memory
    return withoutForeign(raiseScripts(markVectors(std::move(html))), pictures, leftOut);
}

}  // namespace lessons
