#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/frame_argument.h"
#include "app/cli/scene_argument.h"
#include "lessons/library.h"
#include "pipeline/export/json.h"
#include "pipeline/run/runner.h"

namespace app {

namespace {

int listLessons(bool json) {
    const lessons::Library library = lessons::allLessons();
    printErrors(library.errors);
    if (json) {
        pipeline::Json list = pipeline::Json::array();
        for (const lessons::Lesson& lesson : library.lessons)
            list.push_back({{"name", lesson.name},
                            {"title", lesson.title},
                            {"lecture", lesson.lecture},
                            {"summary", lesson.summary},
                            {"pages", lesson.pages.size()}});
        fmt::print("{}\n", list.dump(2, ' ', false, pipeline::Json::error_handler_t::replace));
    } else {
        for (const lessons::Lesson& lesson : library.lessons)
            fmt::print("{:<16} {}. {}, {} pages. {}\n", lesson.name, lesson.title, lesson.lecture, lesson.pages.size(),
                       lesson.summary);
    }
    return library.errors.empty() ? kDone : kBadInput;
}

// A text with its numbers filled in from the frame.
bool printProse(const lessons::Prose& prose, const pipeline::Frame& frame) {
    const auto text = filled(prose, frame);
    if (!text) {
        printErrors(text.errors());
        return false;
    }
    fmt::print("{}\n", *text);
    return true;
}

// The pages as Markdown: headings, texts, questions.
int showLesson(const std::string& name) {
    const auto lesson = lessons::findLesson(name);
    if (!lesson) {
        printErrors(lesson.errors());
        return kBadInput;
    }
    fmt::print("# {}\n\n{}\n", lesson->title, lesson->summary);
    pipeline::FramePtr frame;
    for (const lessons::Page& page : lesson->pages) {
        frame = runFrame(std::make_shared<const pipeline::Scene>(page.state.scene), requestFor(page), frame);
        fmt::print("\n## {}\n\n", page.heading);
        if (!printProse(page.text, *frame)) return kBadInput;
        if (!page.question) continue;
        fmt::print("\n");
        if (!printProse(page.question->text, *frame)) return kBadInput;
    }
    return kDone;
}

}  // namespace

void declareLesson(CLI::App& program, const CliHost&, int& status) {
    CLI::App* command = program.add_subcommand("lesson", "List the lessons, or print one");
    command->require_subcommand(1);

    const auto json = std::make_shared<bool>(false);
    CLI::App* list = command->add_subcommand("list", "Print the lessons that there are");
    list->add_flag("--json", *json, "Print JSON");
    list->callback([json, &status] { status = listLessons(*json); });

    const auto name = std::make_shared<std::string>();
    CLI::App* show = command->add_subcommand("show", "Print a lesson's pages as Markdown");
    show->add_option("LESSON", *name, "The name that list prints")->required();
    show->callback([name, &status] { status = showLesson(*name); });
}

}  // namespace app
