#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/held.h"
#include "lessons/questions/question.h"
#include "lessons/state/window_state.h"
#include "pipeline/core/result.h"
#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"
#include "pipeline/scene/scene.h"

// A lesson is a folder with a file lesson.md, and with scene files where it brings its own. The file is a header and
// pages; resources/manual/write-a-lesson.md has its syntax. No code: whoever can write Markdown can write one.
// Everything is checked when the file is read: an unknown name is an error with its line and the nearest name.

namespace lessons {

// What the window is set to when a page opens, or its second half.
struct PageState {
    pipeline::Scene scene;  // settings applied; has passed checkScene
    // `scene` and `set` in it lead to the same scene, from the lesson's folder.
    WindowState window;
};
// The buffers of its views, in their order; derived ones too.
std::vector<pipeline::BufferName> shownBuffers(const PageState& state);
std::optional<glm::ivec2> pickedPixel(const PageState& state);

// What a page is about before or after its question is settled.
struct Half {
    PageState state;
    Prose text;   // in the window
    Prose paper;  // in a handout: differs where paragraphs begin with "screen:" or "paper:"
    Held held{};
    std::vector<std::string> sets{};  // keys of the settings that this half sets itself
};

// Parts of the window that may tell an answer.
enum class Part : std::uint8_t { Inspector, Equation, Counts, Plan, Algorithm, Timeline, Scene, Settings };
inline constexpr std::array<std::string_view, 8> kPartNames{"inspector", "equation", "counts", "plan",
                                                            "algorithm", "timeline", "scene",  "settings"};

// Where a page comes from whose question returns at the start of another lesson.
struct Origin {
    std::string lesson;            // the name of its folder
    std::size_t page = 0;          // from 1
    std::filesystem::path folder;  // as Lesson::folder, of that lesson
};

struct Page {
    std::string heading;  // of a page that returns: "Again: …"
    Half first;
    std::optional<Question> question;
    // Shown and given out once the question is settled. It begins as the first half, with what it says itself changed.
    // Only a page with a question has one.
    std::optional<Half> then;
    // `hides`: what the author names beside the buffers that the answer is read from; see hiddenOn (hidden.h).
    std::vector<pipeline::BufferName> hiddenBuffers;
    std::vector<Part> hiddenParts;
    // `panels`: parts of the window that this page needs, in their usual place.
    std::vector<Part> panels;
    pipeline::SourceLocation where;  // of the heading
    std::optional<Origin> from;      // of a page that returns
};

struct Lesson {
    std::string name;              // of its folder
    std::filesystem::path folder;  // where its pictures are; empty where it was read from a text
    std::string title, lecture, summary;
    int minutes = 0;                   // how long it takes; 0 where it does not say
    std::vector<std::string> can;      // what a reader can do after it, each the end of "You can now"
    std::vector<std::string> notions;  // of resources/manual/lectures.md
    std::string next;                  // the name of the lesson after it; may be empty
    // "returns: back-faces/3, z-buffer/5": pages of other lessons whose questions come before the first page.
    struct Return {
        std::string lesson;
        std::size_t page = 0;  // from 1
        pipeline::SourceLocation where;
    };
    std::vector<Return> returns;
    std::vector<Page> pages;  // those that return, then the lesson's own: at least one
};

// How many of its pages return.
std::size_t returningPages(const Lesson& lesson);
// What a page is called, by its index: "3", the number among the lesson's own; of one that returns "back-faces/3".
std::string pageName(const Lesson& lesson, std::size_t index);
// Where its pictures and files are.
const std::filesystem::path& folderOf(const Lesson& lesson, const Page& page);

// Reads the lesson in a folder. Up to kMaxErrors errors, FILE:LINE:COLUMN each. An outline has the header, and of its own
// pages the headings alone: it reads no scene, and takes a hundredth of the time.
pipeline::Result<Lesson> readOutline(const std::filesystem::path& folder, const pipeline::Stop& stop = {});
pipeline::Result<Lesson> readLesson(const std::filesystem::path& folder, const pipeline::Stop& stop = {});

// The same from text: `file` is the name in messages, `sceneNamed` finds what the lesson calls its scene.
using SceneSource = std::function<pipeline::Result<pipeline::Scene>(std::string_view name)>;
// Another lesson, of which pages return; without it a lesson from which some return is an error.
struct LessonText {
    std::string text, file;
    std::filesystem::path folder;
    SceneSource sceneNamed;
};
using LessonSource = std::function<pipeline::Result<LessonText>(std::string_view name)>;
pipeline::Result<Lesson> parseLesson(std::string_view text, const std::string& file, const SceneSource& sceneNamed,
                                     const LessonSource& lessonNamed = {});
// Without pages that return: a page for a browser does not know what its reader has answered elsewhere.
pipeline::Result<Lesson> parseOwnPages(std::string_view text, const std::string& file, const SceneSource& sceneNamed);
pipeline::Result<Lesson> parseOutline(std::string_view text, const std::string& file);

// What a lesson in this folder means by the name of a scene: one that comes with the program, or a file in the folder.
pipeline::Result<pipeline::Scene> sceneOfLesson(std::string_view name, const std::filesystem::path& folder,
                                                const pipeline::Stop& stop = {});

// A frame of the first half's scene asked for with this has everything that the first half shows and says, and what it
// takes to judge an answer and speak about it. That of the second half likewise; the page must have one.
pipeline::FrameRequest requestFor(const Page& page);
pipeline::FrameRequest requestForThen(const Page& page);

// Frames of both halves; `then` is null where the page has no second half.
struct PageFrames {
    pipeline::FramePtr first, then;
};
// visit(page, number, frames) for every page; false where it was stopped before all were visited.
using PageVisit = std::function<void(const Page& page, std::size_t number, const PageFrames& frames)>;
bool runPages(const Lesson& lesson, const pipeline::Stop& stop, const PageVisit& visit);

}  // namespace lessons
