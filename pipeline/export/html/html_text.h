#pragma once
#include <string>
#include <string_view>

namespace pipeline {

// What pages in HTML 5 are put together from: a study's report, a lesson's handout.

// Text as HTML shows it, within elements and in quoted attributes.
std::string escapedHtml(std::string_view text);

// An element with text, which is escaped. tag: its name, with attributes where it has any: "td class=n".
std::string element(std::string_view tag, std::string_view text);

// RFC 4648, with padding. Fewer than 2^30 bytes.
std::string base64(std::string_view bytes);

// Four bytes as five digits, of a last group of n bytes n + 1: 6 % shorter than base64. The digits are the 85 printable
// characters of ASCII but " $ & ' < > @ \ `, in ASCII's order, so that scripts, attributes and quotes take them as they are.
std::string base85(std::string_view bytes);

// A picture inside the page, for src. type: "png", "svg+xml".
std::string imageSource(std::string_view type, std::string_view bytes);

}  // namespace pipeline
