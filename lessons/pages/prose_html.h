#pragma once
#include <string>
#include <string_view>

#include "lessons/pages/picture.h"

namespace lessons {

// What a lesson says, Markdown whose holes are filled, as HTML. As the window shows it: ***N*** is a vector in its code
// (pipeline/export/html/formula_html.h), I_max and (R·V)^n have scripts. HTML in the text is shown as it was typed. The lesson's
// pictures stand in the HTML; of others the words do, and `leftOut` says why, without a place. Links lose an address that
// leads out of the lesson's folder (linkTarget).
std::string proseHtml(std::string_view markdown, Pictures& pictures, pipeline::Errors& leftOut);

}  // namespace lessons
