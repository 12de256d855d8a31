#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/progress_printer.h"
#include "app/cli/scene_argument.h"
#include "lessons/handout.h"
#include "lessons/library.h"
#include "pipeline/export/json.h"

namespace app {

namespace {

using pipeline::Json;

void printJson(const Json& json) { say("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace)); }

int listLessons(bool json) {
    const lessons::Library library = lessons::allLessons();
    printErrors(library.errors);
    if (json) {
        Json list = Json::array();
        for (const lessons::Lesson& lesson : library.lessons)
            list.push_back({{"name", lesson.name},
                            {"title", lesson.title},
                            {"lecture", lesson.lecture},
                            {"summary", lesson.summary},
                            {"pages", lesson.pages.size()}});
        printJson(list);
    } else {
        for (const lessons::Lesson& lesson : library.lessons)
            say("{:<16} {}. {}, {} pages. {}\n", lesson.name, lesson.title, lesson.lecture, lesson.pages.size(),
                lesson.summary);
    }
    return library.errors.empty() ? kDone : kBadInput;
}

// A page with its numbers filled in.
Json pageJson(const lessons::Page& page, const pipeline::Frame& frame, pipeline::Errors& errors) {
    Json json{{"heading", page.heading},
              {"stage", pipeline::stageInfo(page.state.stage).name},
              {"buffers", Json::array()},
              {"pixel", nullptr},
              {"text", filled(page.text, frame, errors)},
              {"question", nullptr}};
    for (const pipeline::BufferName& buffer : page.state.buffers) json["buffers"].push_back(buffer.text());
    if (const auto pixel = page.state.pixel) json["pixel"] = {pixel->x, pixel->y};
    if (const auto& question = page.question) {
        const auto answer = answerOf(page, frame);
        if (!answer) errors.insert(errors.end(), answer.errors().begin(), answer.errors().end());
        json["question"] = {{"text", filled(question->text, frame, errors)},
                            {"answer", answer ? Json(*answer) : Json()},
                            {"tolerance", question->tolerance},
                            {"hint", filled(question->hint, frame, errors)}};
    }
    return json;
}

// As Markdown: headings, texts, questions.
void printPages(const lessons::Lesson& lesson, const Json& pages) {
    say("# {}\n\n{}\n", lesson.title, lesson.summary);
    for (const Json& page : pages) {
        say("\n## {}\n\n{}\n", page["heading"].get<std::string>(), page["text"].get<std::string>());
        if (!page["question"].is_null()) say("\n{}\n", page["question"]["text"].get<std::string>());
    }
}

int showLesson(const std::string& name, bool asJson) {
    const Interrupt interrupt;
    const auto lesson = lessons::findLesson(name, interrupt.token());
    if (interrupt.asked()) {
        tell("Cancelled.\n");
        return kInterrupted;
    }
    if (!lesson) {
        printErrors(lesson.errors());
        return kBadInput;
    }
    Json pages = Json::array();
    pipeline::Errors errors;
    const bool all =
        runPages(*lesson, interrupt.token(), [&](const lessons::Page& page, std::size_t, const pipeline::Frame& frame) {
            pages.push_back(pageJson(page, frame, errors));
        });
    if (!all) {
        tell("Cancelled.\n");
        return kInterrupted;
    }
    if (!errors.empty()) {
        printErrors(errors);
        return kBadInput;
    }
    if (!asJson)
        printPages(*lesson, pages);
    else
        printJson({{"name", lesson->name},
                   {"title", lesson->title},
                   {"lecture", lesson->lecture},
                   {"summary", lesson->summary},
                   {"pages", pages}});
    return kDone;
}

int exportLesson(const std::string& name, const std::string& folder) {
    if (folder.empty()) {
        tell("shadescope lesson export: -o needs the name of a folder\n");
        return kWrongUsage;
    }
    const Interrupt interrupt;
    const auto lesson = lessons::findLesson(name, interrupt.token());
    if (interrupt.asked()) {
        tell("Cancelled.\n");
        return kInterrupted;
    }
    if (!lesson) {
        printErrors(lesson.errors());
        return kBadInput;
    }
    auto handout = [&] {
        ProgressPrinter progress("handout");
        return makeHandout(*lesson, interrupt.token(),
                           [&](std::size_t page) { progress.show(page, lesson->pages.size(), "pages"); });
    }();
    if (interrupt.asked()) {
        tell("Cancelled. Nothing was written.\n");
        return kInterrupted;
    }
    if (!handout) {
        printErrors(handout.errors());
        return kBadInput;
    }
    const auto written = writeHandout(*handout, lesson->name, folder);
    if (!written) {
        printErrors(written.errors());
        return kCouldNotWrite;
    }
    printErrors(handout->leftOut);
    tell("{} in {}\n", fmt::join(*written, " and "), folder);
    return kDone;
}

}  // namespace

void declareLesson(CLI::App& program, const CliHost&, int& status) {
    CLI::App* command = program.add_subcommand("lesson", "List the lessons, print one, or write it as a handout");
    command->require_subcommand(1);
    struct Options {
        std::string name, folder;
        bool json = false;
    };
    const auto options = std::make_shared<Options>();
    const auto addName = [&](CLI::App& to) {
        to.add_option("LESSON", options->name, "The name that list prints, or the folder of a lesson")->required();
    };

    CLI::App* list = command->add_subcommand("list", "Print the lessons that there are");
    list->add_flag("--json", options->json, "Print JSON");
    list->callback([options, &status] { status = listLessons(options->json); });

    CLI::App* show = command->add_subcommand("show", "Print a lesson's pages as Markdown");
    addName(*show);
    show->add_flag("--json", options->json, "Print JSON, with the answers");
    show->callback([options, &status] { status = showLesson(options->name, options->json); });

    CLI::App* write = command->add_subcommand("export", "Write a lesson for paper: a handout, and its answers");
    addName(*write);
    write->add_option("-o,--output", options->folder, "The folder to write into; made when it is missing")
        ->required()
        ->type_name("DIR");
    write->callback([options, &status] { status = exportLesson(options->name, options->folder); });
}

}  // namespace app
