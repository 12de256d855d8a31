#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"

// How the texts of a lesson get into a live page. The page has no Markdown: whoever writes the page turns each text into
// HTML with its holes open, and the page's core puts that HTML in the Markdown's place. So the engine fills, judges and
// speaks as in the program, and what it says is HTML afterwards.

namespace lessons {

// Every text that the window shows of a lesson, in one order: of the same lesson the same everywhere.
std::vector<Prose*> liveTexts(Lesson& lesson);
std::vector<Prose*> liveTexts(Page& page);  // those of one page

// The Markdown of a text with a word in each hole.
std::string withHoleWords(const Prose& prose);

// Puts the HTML of withHoleWords(prose) in the place of the prose's Markdown. False, and nothing is done, where it has
// not the same holes.
bool dress(Prose& prose, std::string_view html);

// What the engine says of dressed texts, as HTML: what the texts hold stays markup, all else is escaped, the numbers in
// the holes too. Sentences of the engine's own become paragraphs, and what they put between ` code.
std::string liveHtml(std::string_view said);

}  // namespace lessons
