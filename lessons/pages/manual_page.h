#pragma once
#include <functional>
#include <string>
#include <string_view>

namespace lessons {

// A page of the manual as the inside of <main>: GitHub's Markdown, whose headings have GitHub's ids. address: what a link or
// a picture leads to; empty: its words stand without a link. The manual is the program's own text: HTML in it is kept.
using LinkAddress = std::function<std::string(std::string_view address)>;
std::string manualHtml(std::string_view markdown, const LinkAddress& address);

// "the-clean-view" of "The clean view": what a link names a heading by.
std::string headingId(std::string_view words);

}  // namespace lessons
