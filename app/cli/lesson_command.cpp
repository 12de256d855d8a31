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
#include "pipeline/run/runner.h"

namespace app {

namespace {

using pipeline::Json;

void printJson(const Json& json) { fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace)); }

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
            fmt::print("{:<16} {}. {}, {} pages. {}\n", lesson.name, lesson.title, lesson.lecture, lesson.pages.size(),
                       lesson.summary);
    }
    return library.errors.empty() ? kDone : kBadInput;
}

// A page with its numbers filled in.
pipeline::Result<Json> pageJson(const lessons::Page& page, const pipeline::Frame& frame) {
    pipeline::Errors errors;
    const auto take = [&](const lessons::Prose& prose) {
        auto text = filled(prose, frame);
        if (text) return std::move(text).value();
        errors.insert(errors.end(), text.errors().begin(), text.errors().end());
        return std::string();
    };
    Json json{{"heading", page.heading},  {"stage", pipeline::stageInfo(page.state.stage).name},
              {"buffers", Json::array()}, {"pixel", nullptr},
              {"text", take(page.text)},  {"question", nullptr}};
    for (const pipeline::BufferName& buffer : page.state.buffers) json["buffers"].push_back(buffer.text());
    if (const auto pixel = page.state.pixel) json["pixel"] = {pixel->x, pixel->y};
    if (const auto& question = page.question) {
        const auto answer = answerOf(page, frame);
        if (!answer) return answer.errors();
        json["question"] = {{"text", take(question->text)},
                            {"answer", *answer},
                            {"tolerance", question->tolerance},
                            {"hint", take(question->hint)}};
    }
    if (!errors.empty()) return errors;
    return json;
}

// The pages: headings, texts, questions.
int showLesson(const std::string& name, bool asJson) {
    const Interrupt interrupt;
    const auto lesson = lessons::findLesson(name);
    if (!lesson) {
        printErrors(lesson.errors());
        return kBadInput;
    }
    Json pages = Json::array();
    pipeline::FramePtr frame;
    for (const lessons::Page& page : lesson->pages) {
        pipeline::FrameRequest request = requestFor(page);
        request.stop = interrupt.token();
        frame = runFrame(std::make_shared<const pipeline::Scene>(page.state.scene), request, frame);
        if (!frame) return kInterrupted;
        auto json = pageJson(page, *frame);
        if (!json) {
            printErrors(json.errors());
            return kBadInput;
        }
        pages.push_back(std::move(json).value());
    }
    if (asJson) {
        printJson({{"name", lesson->name},
                   {"title", lesson->title},
                   {"lecture", lesson->lecture},
                   {"summary", lesson->summary},
                   {"pages", pages}});
        return kDone;
    }
    fmt::print("# {}\n\n{}\n", lesson->title, lesson->summary);
    for (const Json& page : pages) {
        fmt::print("\n## {}\n\n{}\n", page["heading"].get<std::string>(), page["text"].get<std::string>());
        if (!page["question"].is_null()) fmt::print("\n{}\n", page["question"]["text"].get<std::string>());
    }
    return kDone;
}

int exportLesson(const std::string& name, const std::string& folder) {
    if (folder.empty()) {
        tell("shadescope lesson export: -o needs the name of a folder\n");
        return kWrongUsage;
    }
    const Interrupt interrupt;
    const auto lesson = lessons::findLesson(name);
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
