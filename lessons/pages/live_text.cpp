#include "lessons/pages/live_text.h"

#include <algorithm>

#include "pipeline/export/html/html_text.h"

namespace lessons {

namespace {

// Around what is markup already. No text of a lesson has these (pipeline::escapedControls), and what a reader types
// is not taken for markup either: plainText() drops them.
constexpr char kBegin = '\x01', kEnd = '\x02';
// A word, as most numbers are: so Markdown takes the emphasis around a hole as it takes that around a number.
constexpr std::string_view kHoleWord = "0hole0";

std::string dressedPiece(std::string_view html) {
    std::string piece(1, kBegin);
    // The engine may take a text apart at its line ends.
    for (const char c : html)
        if (c == '\n')
            piece.append({kEnd, '\n', kBegin});
        else
            piece += c;
    return piece + kEnd;
}

// Text that is no markup, with `code` and paragraphs.
std::string plainText(std::string_view text, bool& inCode) {
    std::string html;
    for (const char c : text) {
        switch (c) {
            case '`': html += (inCode = !inCode) ? "<code>" : "</code>"; break;
            case kBegin:
            case kEnd: break;
            default: html += pipeline::escapedHtml({&c, 1});
        }
    }
    return html;
}

// A paragraph alone is as good without its tags: the engine puts texts into sentences.
std::string_view withoutParagraph(std::string_view html) {
    constexpr std::string_view kStart = "<p>", kStop = "</p>";
    while (html.ends_with('\n')) html.remove_suffix(1);
    const bool isOne =
        html.starts_with(kStart) && html.ends_with(kStop) && html.find(kStop) + kStop.size() == html.size();
    return isOne ? html.substr(kStart.size(), html.size() - kStart.size() - kStop.size()) : html;
}

}  // namespace

std::vector<Prose*> liveTexts(Page& page) {
    std::vector<Prose*> texts{&page.first.text};
    if (page.then) texts.push_back(&page.then->text);
    if (page.question)  // const for its other readers; the lesson is not
        for (const Prose* text : textsOf(*page.question)) texts.push_back(const_cast<Prose*>(text));
    return texts;
}

std::vector<Prose*> liveTexts(Lesson& lesson) {
    std::vector<Prose*> texts;
    for (Page& page : lesson.pages)
        for (Prose* text : liveTexts(page)) texts.push_back(text);
    return texts;
}

std::string withHoleWords(const Prose& prose) {
    std::string text = prose.pieces.empty() ? std::string() : prose.pieces.front();
    for (std::size_t i = 1; i < prose.pieces.size(); ++i) text.append(kHoleWord).append(prose.pieces[i]);
    return text;
}

bool dress(Prose& prose, std::string_view html) {
    if (prose.empty()) return true;  // the engine asks whether there is a text
    html = withoutParagraph(html);
    std::vector<std::string> pieces;
    for (std::size_t at; (at = html.find(kHoleWord)) != html.npos; html.remove_prefix(at + kHoleWord.size()))
        pieces.push_back(dressedPiece(html.substr(0, at)));
    pieces.push_back(dressedPiece(html));
    if (pieces.size() != prose.holes.size() + 1) return false;
    prose.pieces = std::move(pieces);
    return true;
}

std::string liveHtml(std::string_view said) {
    constexpr std::string_view kGap = "\n\n";
    std::string html, paragraph;
    bool inCode = false;
    const auto endParagraph = [&] {
        if (inCode) paragraph += "</code>", inCode = false;
        const bool isBlock = paragraph.starts_with("<p>") || paragraph.starts_with("<ul") ||
                             paragraph.starts_with("<ol") || paragraph.starts_with("<table") ||
                             paragraph.starts_with("<blockquote") || paragraph.starts_with("<pre") ||
                             paragraph.starts_with("<h");
        if (!paragraph.empty()) html += isBlock ? paragraph : "<p>" + paragraph + "</p>";
        paragraph.clear();
    };
    while (!said.empty()) {
        const std::size_t begin = std::min(said.find(kBegin), said.size());
        std::string_view plain = said.substr(0, begin);
        for (std::size_t gap; (gap = plain.find(kGap)) != plain.npos; plain.remove_prefix(gap + kGap.size())) {
            paragraph += plainText(plain.substr(0, gap), inCode);
            endParagraph();
        }
        paragraph += plainText(plain, inCode);
        said.remove_prefix(begin);
        if (said.empty()) break;
        const std::size_t end = std::min(said.find(kEnd), said.size());
        paragraph += said.substr(1, end - 1);
        said.remove_prefix(std::min(end + 1, said.size()));
    }
    endParagraph();
    return html;
}

}  // namespace lessons
