#pragma once
#include <string>
#include <string_view>

namespace lessons {

// What a lesson says, Markdown whose holes are filled, as HTML. As the window shows it: ***N*** is a vector in its code
// (pipeline/export/formula_html.h), I_max and (R·V)^n have scripts. HTML in the text is shown as it was typed.
std::string proseHtml(std::string_view markdown);

}  // namespace lessons
