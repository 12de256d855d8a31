#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/core/result.h"

namespace lessons {

// Wrong pictures on paper: two pages in HTML 5 without scripts that need nothing else, for a browser or its printer.
struct BugQuiz {
    std::string questions;  // pictures and buffers, boxes to tick
    std::string answers;    // for who teaches
};

// As makeRiddle() gives them, from number 0. progress: of the picture that is made, from 0. Errors: those of makeRiddle();
// "stopped"; a count above the number of defects there are.
pipeline::Result<BugQuiz> makeBugQuiz(std::uint64_t seed, std::size_t count, const std::vector<int>& boxes,
                                      const std::stop_token& stop = {},
                                      const std::function<void(std::size_t)>& progress = {});

std::vector<std::string> bugQuizFiles();  // their names
// quiz.html and quiz-answers.html, into a folder, which is made when it is missing: both or none. Gives their names.
pipeline::Result<std::vector<std::string>> writeBugQuiz(const BugQuiz& quiz, const std::filesystem::path& folder);

}  // namespace lessons
