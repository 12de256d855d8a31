#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>

#include "app/cli/arguments/live_argument.h"
#include "app/cli/arguments/output_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/node_lines.h"
#include "app/cli/progress_printer.h"
#include "app/cli/watch.h"
#include "lessons/check.h"
#include "lessons/library.h"
#include "lessons/pages/handout.h"
#include "lessons/questions/judge.h"
#include "lessons/questions/results.h"
#include "pipeline/core/text.h"
#include "pipeline/export/json/json_value.h"

namespace app {

namespace {

using pipeline::Json;

void printJson(const Json& json) { say("{}\n", json.dump(2)); }

int listLessons(bool json) {
    const lessons::Library library = lessons::allOutlines();
    printErrors(library.errors);
    if (json) {
        Json list = Json::array();
        for (const lessons::Lesson& lesson : library.lessons)
            list.push_back({{"name", lesson.name},
                            {"title", lesson.title},
                            {"lecture", lesson.lecture},
                            {"summary", lesson.summary},
                            {"pages", lesson.pages.size() + lesson.returns.size()}});
        printJson(list);
    } else {
        for (const lessons::Lesson& lesson : library.lessons)
            say("{:<16} {}. {}, {} pages. {}\n", lesson.name, lesson.title, lesson.lecture, lesson.pages.size(),
                lesson.summary);
    }
    return library.errors.empty() ? kDone : kBadInput;
}

// Half a page with its numbers filled in.
Json halfJson(const lessons::Half& half, const lessons::Context& context, pipeline::Errors& errors) {
    Json json{{"stage", pipeline::stageInfo(half.state.window.stage).name},
              {"buffers", Json::array()},
              {"pixel", nullptr},
              {"text", filled(half.text, context, errors)}};
    for (const pipeline::BufferName& buffer : shownBuffers(half.state)) json["buffers"].push_back(buffer.text());
    if (const auto pixel = pickedPixel(half.state)) json["pixel"] = {pixel->x, pixel->y};
    return json;
}

Json questionJson(const lessons::Question& question, const lessons::Context& context, pipeline::Errors& errors) {
    const auto text = answerText(question, context);
    if (!text) errors.insert(errors.end(), text.errors().begin(), text.errors().end());
    Json answer = text ? Json(*text) : Json();
    const auto* number = std::get_if<lessons::NumberQuestion>(&question.kind);
    if (const auto value = number ? evaluate(number->answer, context) : lessons::Value(); text && number && value)
        answer = value->numbers.front();
    Json json{{"kind", kindName(question)}, {"text", filled(question.text, context, errors)},
              {"answer", answer},           {"points", question.points},
              {"hints", Json::array()},     {"works", filled(question.works, context, errors)}};
    if (question.isPrediction) json["prediction"] = true;
    for (const lessons::Prose& hint : question.hints) json["hints"].push_back(filled(hint, context, errors));
    for (const lessons::Prose* row : rowsOf(question)) json["options"].push_back(filled(*row, context, errors));
    return json;
}

Json pageJson(const lessons::Page& page, const lessons::PageFrames& frames, pipeline::Errors& errors) {
    const lessons::Context context{.frame = *frames.first};
    Json json = halfJson(page.first, context, errors);
    json["heading"] = page.heading;
    if (page.from) json["returns"] = {{"lesson", page.from->lesson}, {"page", page.from->page}};
    json["question"] = page.question ? questionJson(*page.question, context, errors) : Json();
    json["then"] = page.then ? halfJson(*page.then, {.frame = *frames.then}, errors) : Json();
    return json;
}

// As Markdown: headings, texts, questions; with the way of working and the second halves where answers are asked for.
void printPages(const lessons::Lesson& lesson, const Json& pages, bool answers) {
    say("# {}\n\n{}\n", lesson.title, lesson.summary);
    for (const Json& page : pages) {
        say("\n## {}\n\n{}\n", page["heading"].text(), page["text"].text());
        const Json& question = page["question"];
        if (!question.is(Json::kNull)) say("\n{}\n", question["text"].text());
        for (const Json& option : question["options"]) say("\n- {}\n", option.text());
        if (!answers) continue;
        if (!question.is(Json::kNull))
            say("\n**Answer**\n\n{}\n", question[question["kind"].text() == "write" ? "answer" : "works"].text());
        if (!page["then"].is(Json::kNull)) say("\n{}\n", page["then"]["text"].text());
    }
}

// The lesson that an argument names; nothing, told of and with the status, where there is none or reading was stopped.
std::optional<lessons::Lesson> foundLesson(const std::string& name, const Interrupt& interrupt, int& status) {
    auto lesson = lessons::findLesson(name, interrupt.token());
    if (interrupt.asked()) {
        status = tellCancelled();
        return {};
    }
    if (lesson) return std::move(lesson).value();
    printErrors(lesson.errors());
    status = kBadInput;
    return {};
}

int showLesson(const std::string& name, bool asJson, bool answers) {
    const Interrupt interrupt;
    int status = kDone;
    const auto lesson = foundLesson(name, interrupt, status);
    if (!lesson) return status;
    Json pages = Json::array();
    pipeline::Errors errors;
    const bool all = runPages(*lesson, interrupt.token(),
                              [&](const lessons::Page& page, std::size_t, const lessons::PageFrames& frames) {
                                  pages.push_back(pageJson(page, frames, errors));
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
        printPages(*lesson, pages, answers);
    else
        printJson({{"name", lesson->name},
                   {"title", lesson->title},
                   {"lecture", lesson->lecture},
                   {"summary", lesson->summary},
                   {"pages", pages}});
    return kDone;
}

int exportLesson(const std::string& name, const std::string& folder, bool force) {
    if (folder == kStandardOutput) {
        tell("shadescope lesson export: -o: {}\n", kNoStandardOutput);
        return kWrongUsage;
    }
    if (folder.empty()) {
        tell("shadescope lesson export: -o needs the name of a folder\n");
        return kWrongUsage;
    }
    const Interrupt interrupt;
    int status = kDone;
    const auto lesson = foundLesson(name, interrupt, status);
    if (!lesson) return status;
    const std::vector<std::string> files = lessons::handoutFiles(lesson->name);
    if (!mayWriteInto(folder, files, files.back(), force)) return kCouldNotWrite;
    auto handout = [&] {
        ProgressPrinter progress("handout");
        return makeHandout(*lesson, interrupt.token(),
                           [&](std::size_t page) { progress.show(page, lesson->pages.size(), "pages"); });
    }();
    if (interrupt.asked()) return tellCancelled();
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

int exportLive(const std::string& name, const std::string& file, bool watches) {
    const auto parts = livePartsOrTell(file, "lesson export");
    if (!parts) return parts.status;
    const Interrupt interrupt;
    int status = kDone;
    const auto lesson = foundLesson(name, interrupt, status);
    if (!lesson) return status;
    const auto write = [&](const lessons::Lesson& from) {
        return writeLivePage(makeLivePage(from, *parts.parts, interrupt.token()), file, interrupt);
    };
    if (!watches) return write(*lesson);
    const std::string folder = lesson->folder.string();
    const auto again = [&] {
        // A lesson that is being written has errors, which are told; the page before stays.
        if (const auto now = foundLesson(name, interrupt, status)) write(*now);
    };
    return watch([&] { return stateOfFiles({folder}, file); }, again, interrupt);
}

int checkOne(const std::string& name, bool strict) {
    const Interrupt interrupt;
    int status = kDone;
    const auto lesson = foundLesson(name, interrupt, status);
    if (!lesson) return status;
    const auto writing = std::ranges::count_if(lesson->pages, [](const lessons::Page& page) {
        return page.question && std::holds_alternative<lessons::WriteQuestion>(page.question->kind);
    });
    const lessons::LinesRunner run = writing > 0 ? nodeLines(interrupt.token()) : lessons::LinesRunner();
    const pipeline::Errors errors = [&] {
        ProgressPrinter progress("check");
        return checkLesson(
            *lesson, interrupt.token(), [&](std::size_t page) { progress.show(page, lesson->pages.size(), "pages"); },
            run);
    }();
    if (interrupt.asked()) {
        tell("Cancelled.\n");
        return kInterrupted;
    }
    if (!errors.empty()) {
        printErrors(errors);
        return kBadInput;
    }
    const auto questions =
        std::ranges::count_if(lesson->pages, [](const auto& page) { return page.question.has_value(); });
    say("{}: {} and {} are right.\n", lesson->title, pipeline::plural(std::int64_t(lesson->pages.size()), "page"),
        pipeline::plural(questions, "question"));
    if (run || writing == 0) return kDone;
    say("The lines of {} of kind write were not tried: that needs Node.js and the core of live pages.\n",
        pipeline::plural(writing, "question"));
    return strict ? kCouldNotWrite : kDone;
}

int showResults(bool json, bool forget) {
    const std::filesystem::path file = lessons::resultsFile();
    if (forget) {
        const pipeline::Errors errors = lessons::writeResults({}, file);
        printErrors(errors);
        if (!errors.empty()) return kCouldNotWrite;
        tell("Forgotten.\n");
        return kDone;
    }
    const auto results = lessons::readResults(file);
    if (!results) {
        printErrors(results.errors());
        return kBadInput;
    }
    if (json) {
        say("{}", toText(*results));
        return kDone;
    }
    if (results->empty()) say("No question has been answered yet.\n");
    for (const auto& [name, pages] : results->lessons()) {
        const auto lesson = lessons::findLesson(name);
        if (!lesson) {
            say("{}: {} answered; this lesson is not here any more.\n", name,
                pipeline::plural(std::int64_t(pages.size()), "page"));
            continue;
        }
        const lessons::Summary summary = summaryOf(*lesson, *results);
        say("{}: {} of {} points{}\n", lesson->title, pipeline::shortestText(summary.points),
            pipeline::shortestText(summary.full), summary.isDone ? ", every question is settled" : "");
        for (const lessons::Summary::OwnMistake& mistake : summary.mistakes)
            say("  {} ({}), page {}\n", mistake.name, pipeline::plural(std::int64_t(mistake.times), "time"),
                pageName(*lesson, mistake.page));
    }
    return kDone;
}

}  // namespace

void declareLesson(CLI::App& program, const CliHost&, int& status) {
    CLI::App* command =
        program.add_subcommand("lesson", "List the lessons, print one, check one, or write it as a handout");
    command->require_subcommand(1);
    struct Options {
        std::string name, folder;
        bool json = false, answers = false, forget = false, live = false, watch = false, force = false, strict = false;
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
    show->add_flag("--answers", options->answers, "Print the answers and the second halves of the pages as well");
    show->callback([options, &status] { status = showLesson(options->name, options->json, options->answers); });

    CLI::App* check =
        command->add_subcommand("check", "Try every question of a lesson and print what is wrong with it");
    addName(*check);
    check->add_flag("--strict", options->strict, "Exit with 4 if lines of questions of kind write could not be tried");
    check->callback([options, &status] { status = checkOne(options->name, options->strict); });

    CLI::App* results =
        command->add_subcommand("results", "Print your results of lessons, which are kept on this machine");
    auto* json = results->add_flag("--json", options->json, "Print JSON");
    results->add_flag("--forget", options->forget, "Forget all of them")->excludes(json);
    results->callback([options, &status] { status = showResults(options->json, options->forget); });

    CLI::App* write = command->add_subcommand(
        "export", "Write a lesson for paper, a handout and its answers, or as a page that any browser opens");
    addName(*write);
    write
        ->add_option("-o,--output", options->folder,
                     "The folder to write into, made when it is missing; with --live the file")
        ->required()
        ->type_name("DIR");
    auto* live = write->add_flag("--live", options->live, "Write one HTML file with the lesson and the pipeline in it");
    declareForce(*write, options->force)->excludes(live);
    write->add_flag("--watch", options->watch, "Write it again whenever the lesson's files change, until Ctrl+C")
        ->needs(live);
    write->callback([options, &status] {
        status = options->live ? exportLive(options->name, options->folder, options->watch)
                               : exportLesson(options->name, options->folder, options->force);
    });
}

}  // namespace app
