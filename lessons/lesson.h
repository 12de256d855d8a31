#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/prose.h"
#include "pipeline/core/result.h"
#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"
#include "pipeline/scene/scene.h"

// A lesson is a folder with a file lesson.md, and with scene files where it brings its own. The
// file is a header and pages. No code: whoever can write Markdown can write one.
//
//   title: The pyramid from its file to its last pixel
//   lecture: Lecture 1
//   summary: One sentence for the list of lessons.
//   scene: pyramid               a scene that comes with the program, or a scene file in the folder
//   set: shading = flat          a setting for all pages; may be repeated
//   let: third = 1 / 3           a name for an expression, on all pages; may be repeated
//
//   # What the highlight adds    begins a page
//   stage: shading               the stage on show; shading unless given
//   buffers: color, specular.0   what the views show, in their order; color unless given
//   pixel: 268, 281              the picked pixel, x and y; none unless given
//   channel: b                   r, g or b: of which the equation speaks; b unless given
//   set: material.0.n = 4        as above, for this page; pages do not inherit from one another
//   let: c = buffer(n_dot_l.0, 268, 281)   likewise; may use the names before it
//   scene: box.scene             another scene for this page
//
//   The text, in Markdown, with {buffer(specular.0, 268, 281, b) : 3} for numbers (see prose.h).
//
//   question: By how much …?     ends the text; these keys come last, in this order or another
//   answer: buffer(specular.0, 268, 281, b)    an expression (see expression.h), one number
//   tolerance: 0.001             how far off a typed answer may be; 0 unless given
//   hint: …
//   right: …                     said after Check; holes are filled from what the window shows then,
//   wrong: …                     so that they can speak of the reader's own settings, and {answer} is the answer
//
// question, hint, right and wrong go on in the lines below up to the next key. Everything is
// checked when the file is read: an unknown name is an error with its line and the nearest name.

namespace lessons {

struct Question {
    Prose text;
    Expression answer;
    double tolerance = 0;
    Prose hint, right, wrong;  // may be empty
};

// What the window is set to when a page opens.
struct PageState {
    pipeline::Scene scene;  // settings applied; has passed checkScene
    pipeline::StageId stage = pipeline::StageId::Shading;
    std::vector<pipeline::BufferName> buffers;  // at least one
    std::optional<glm::ivec2> pixel;            // in the picture
    int channel = 2;                            // 0 r, 1 g, 2 b
};

struct Page {
    std::string heading;
    PageState state;
    Prose text;
    std::optional<Question> question;
    pipeline::SourceLocation where;  // of the heading
};

struct Lesson {
    std::string name;              // of its folder
    std::filesystem::path folder;  // where its pictures are; empty where it was read from a text
    std::string title, lecture, summary;
    std::vector<Page> pages;  // at least one
};

// Reads the lesson in a folder. Up to kMaxErrors errors, FILE:LINE:COLUMN each.
pipeline::Result<Lesson> readLesson(const std::filesystem::path& folder, const pipeline::Stop& stop = {});

// The same from text: `file` is the name in messages, `sceneNamed` finds what the lesson calls its scene.
using SceneSource = std::function<pipeline::Result<pipeline::Scene>(std::string_view name)>;
pipeline::Result<Lesson> parseLesson(std::string_view text, const std::string& file, const SceneSource& sceneNamed);

// A frame of the page's scene asked for with this has everything the page shows and speaks of.
pipeline::FrameRequest requestFor(const Page& page);

// visit(page, number, frame) for every page with that frame; false where it was stopped before all were visited.
using PageVisit = std::function<void(const Page& page, std::size_t number, const pipeline::Frame& frame)>;
bool runPages(const Lesson& lesson, const std::stop_token& stop, const PageVisit& visit);

// The answer to the page's question, from a frame of requestFor(page). The page must have a question.
pipeline::Result<double> answerOf(const Page& page, const pipeline::Frame& frame);
// Whether somebody typed the answer. What is not a number is not right.
bool isRight(double answer, std::string_view typed, double tolerance);

}  // namespace lessons
