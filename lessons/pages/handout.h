#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "lessons/lesson.h"

namespace lessons {

// A lesson on paper: two pages in HTML 5 without scripts that need nothing else, for a browser or its printer.
struct Handout {
    std::string pages;  // for the class: each page's pictures, text, equation and question, with room for an answer
    // For who teaches: each question with its answer. Its last line has the size and the hash of `pages`.
    std::string answers;
    // The pictures that no lesson may bring along (lessons/pages/picture.h), each with the place of its page. Their words stand
    // in the text.
    pipeline::Errors leftOut = {};
};

// number: of the page whose frame is there, from 0.
using HandoutProgress = std::function<void(std::size_t number)>;

// Runs the frame of every page. Errors: what cannot be filled in, FILE:LINE:COLUMN; "stopped".
pipeline::Result<Handout> makeHandout(const Lesson& lesson, const pipeline::Stop& stop = {},
                                      const HandoutProgress& progress = {});

// NAME.html and NAME-answers.html.
std::vector<std::string> handoutFiles(const std::string& name);
// Both in a folder, which is made when it is missing: both or none; the answers go first and come last. Gives
// their names.
pipeline::Result<std::vector<std::string>> writeHandout(const Handout& handout, const std::string& name,
                                                        const std::filesystem::path& folder);

}  // namespace lessons
