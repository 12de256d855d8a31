#pragma once
#include "lessons/pages/prose_html.h"

namespace lessons {

// Of a text without a folder: it has no pictures.
inline std::string htmlOf(std::string_view markdown) {
    Pictures none({});
    pipeline::Errors leftOut;
    return proseHtml(markdown, none, leftOut);
}

}  // namespace lessons
