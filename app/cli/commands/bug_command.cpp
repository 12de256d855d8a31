#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <optional>
#include <sstream>

#include "app/cli/arguments/output_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/progress_printer.h"
#include "lessons/games/bug_quiz.h"
#include "lessons/games/wrong_picture.h"
#include "pipeline/buffers/buffer_table.h"
#include "pipeline/core/text.h"
#include "pipeline/export/buffers/png_file.h"
#include "pipeline/export/folder/staging.h"
#include "pipeline/run/frame_data.h"

namespace app {
namespace {

struct BugOptions {
    std::optional<std::uint64_t> seed;
    std::vector<std::string> pool;
    std::optional<std::size_t> count;
    std::string level = "B", folder;
    bool force = false;
};

constexpr const char* kHelp =
    "look BUFFER      what a buffer holds: look polygons.verdict\n"
    "look X,Y         everything about a pixel, with its equation\n"
    "buffers          the names of the buffers, by stage\n"
    "picture FILE     write the wrong picture, a PNG file\n"
    "mark STAGE       this one is wrong first: mark 0 (the file), mark cull, mark 5\n"
    "hint             the next of three; it costs 10 points\n"
    "quit             give up\n";

// A line of standard input, without its end; nothing at the end of the input.
std::optional<std::string> readLine() {
    std::string line;
    for (int c = std::getc(stdin); c != EOF; c = std::getc(stdin)) {
        if (c == '\n') return line;
        line += char(c);
    }
    return line.empty() ? std::nullopt : std::optional(line);
}
std::optional<std::string> ask(const char* prompt) {
    say("{}", prompt);
    std::fflush(stdout);
    return readLine();
}

// One of several pictures, played.
class Player {
public:
    Player(lessons::WrongPicture& game, std::size_t number, std::size_t count) : m_game(game) {
        say("\nPicture {} of {}: this is {}. Something is wrong. Which stage is the first that leaves something "
            "wrong?\n\n",
            number + 1, count, game.row().scene);
        for (int box = 0; box < lessons::kBoxes; ++box) say("  {} {}\n", box, lessons::boxLabel(box));
        say("\n{}", game.look(pipeline::BufferName{pipeline::BufferId::Color}));
        say("\n{} free. help lists what can be done.\n", pipeline::plural(game.riddle().par, "look"));
    }

    // Whether the picture was solved; nothing: given up.
    bool play() {
        using enum lessons::WrongPicture::Phase;
        while (m_game.phase() != Over) {
            if (m_game.phase() == Cause && !m_isListed) listCauses();
            const auto line = ask("> ");
            if (!line || !carryOut(*line)) return false;
        }
        say("{}\n{} points: {}, par {}; {}.\n", m_game.reveal(), m_game.points(),
            pipeline::plural(std::int64_t(m_game.looks().size()), "look"), m_game.riddle().par,
            pipeline::plural(m_game.hints(), "hint"));
        return true;
    }

private:
    // False: the end.
    bool carryOut(const std::string& line) {
        std::istringstream words(line);
        std::string verb, rest;
        words >> verb >> rest;
        if (verb.empty()) return true;
        if (verb == "quit" || verb == "q") return false;
        if (verb == "help" || verb == "?")
            say("{}", kHelp);
        else if (verb == "look" || verb == "l")
            look(rest);
        else if (verb == "buffers")
            listBuffers();
        else if (verb == "picture")
            writePicture(rest);
        else if (verb == "mark" || verb == "m")
            mark(rest);
        else if (verb == "hint") {
            const std::string hint = m_game.hint();
            say("{}", hint.empty() ? "There is no other hint.\n" : hint);
        } else if (m_game.phase() == lessons::WrongPicture::Phase::Cause && isCause(verb))
            name(std::size_t(verb[0] - '1'));
        else
            say("There is no {}. help lists what can be done.\n", pipeline::inQuotes(verb));
        return true;
    }

    void look(const std::string& what) {
        if (const auto pixel = parsePair(what, ',')) {
            const pipeline::Settings& settings = m_game.wrong()->scene().settings;
            if (pixel->x < 0 || pixel->y < 0 || pixel->x >= settings.width || pixel->y >= settings.height)
                say("The picture has {} × {} pixels, from 0,0.\n", settings.width, settings.height);
            else
                showLook(m_game.look(*pixel));
        } else if (const auto buffer = pipeline::findBuffer(what)) {
            showLook(m_game.look(*buffer));
        } else {
            say("There is no buffer {}; {}.\n", pipeline::inQuotes(what), pipeline::insteadOfBuffer(what));
        }
    }
    void showLook(const std::string& text) {
        say("{}{} of {} free.\n", text, pipeline::plural(std::int64_t(m_game.looks().size()), "look"),
            m_game.riddle().par);
    }

    void listBuffers() {
        for (const pipeline::StageId stage : pipeline::kStages) {
            std::string names;
            for (const pipeline::BufferName& name : pipeline::allBuffers(m_game.wrong()->scene().lights.size()))
                if (pipeline::bufferInfo(name.id).stage == stage && m_game.wrong()->buffer(name))
                    names += ' ' + name.text();
            say("{} {}:{}\n", 1 + index(stage), pipeline::stageInfo(stage).label, names);
        }
    }

    void writePicture(const std::string& file) {
        if (file.empty()) {
            say("picture needs the name of a file.\n");
            return;
        }
        const std::string png = pipeline::readStages(
            *m_game.wrong(), [](const auto& data) { return pipeline::pngOf(data.shading->color); });
        if (const auto written = pipeline::writeWhole(file, png); !written)
            printErrors(written.errors());
        else
            say("{}\n", file);
    }

    void mark(const std::string& what) {
        if (m_game.phase() != lessons::WrongPicture::Phase::Stage) {
            say("That is found. Which of the five is the cause?\n");
            return;
        }
        const auto box = lessons::findBox(what);
        if (!box) {
            say("There is no stage {}: 0 to 6, file, or a stage's name.\n", pipeline::inQuotes(what));
            return;
        }
        const lessons::WrongPicture::Answer answer = m_game.mark(*box);
        say("{}{}{} points\n", answer.isRight ? "" : fmt::format("Not {}. ", lessons::boxLabel(*box)), answer.why,
            m_game.points());
    }

    static bool isCause(const std::string& word) { return word.size() == 1 && word[0] >= '1' && word[0] <= '5'; }
    void listCauses() {
        m_isListed = true;
        say("What is the cause?\n");
        for (std::size_t i = 0; i < m_game.riddle().causes.size(); ++i)
            say("  {} {}\n", i + 1, pipeline::defectInfo(m_game.riddle().causes[i]).name);
    }
    void name(std::size_t cause) {
        const lessons::WrongPicture::Answer answer = m_game.name(cause);
        say("{}", answer.isRight ? "Yes.\n\n" : answer.why);
    }

    lessons::WrongPicture& m_game;
    bool m_isListed = false;
};

// Ctrl+C while frames are computed; at a prompt it ends the program.
std::unique_ptr<lessons::WrongPicture> beginGame(lessons::Riddle riddle, bool& asked) {
    const Interrupt interrupt;
    auto game = lessons::WrongPicture::begin(std::move(riddle), interrupt.token());
    asked = interrupt.asked();
    return game;
}

int playBugs(std::uint64_t seed, std::size_t count, const std::vector<int>& boxes) {
    int points = 0;
    std::size_t solved = 0;
    say("The wrong picture, seed {}, level B.\n", seed);
    for (std::size_t number = 0; number < count; ++number) {
        auto riddle = lessons::makeRiddle(seed, number, boxes);
        if (!riddle) {
            printErrors(riddle.errors());
            return kBadInput;
        }
        bool asked = false;
        const auto game = beginGame(std::move(riddle).value(), asked);
        if (!game) {
            tell("Cancelled.\n");
            return kInterrupted;
        }
        if (!Player(*game, number, count).play()) break;
        ++solved, points += game->points();
    }
    if (count > 1) say("\n{} of {} found, {} points\n", solved, count, points);
    return solved == count ? kDone : kAnswerIsNo;
}

int writeQuizOf(std::uint64_t seed, std::size_t count, const std::vector<int>& boxes, const BugOptions& options) {
    const std::vector<std::string> names = lessons::bugQuizFiles();
    if (!mayWriteInto(options.folder, names, names.back(), options.force)) return kCouldNotWrite;
    const Interrupt interrupt;
    const auto quiz = [&] {
        ProgressPrinter progress("quiz");
        return lessons::makeBugQuiz(seed, count, boxes, interrupt.token(),
                                    [&](std::size_t number) { progress.show(number, count, "pictures"); });
    }();
    if (interrupt.asked()) return tellCancelled();
    if (!quiz) {
        printErrors(quiz.errors());
        return kWrongUsage;
    }
    const auto written = lessons::writeBugQuiz(*quiz, options.folder);
    if (!written) {
        printErrors(written.errors());
        return kCouldNotWrite;
    }
    tell("{} in {}, seed {}\n", fmt::join(*written, " and "), options.folder, seed);
    return kDone;
}

int runBug(const BugOptions& options, bool writes) {
    std::vector<int> boxes;
    for (const std::string& name : options.pool) {
        const auto box = lessons::findBox(name);
        if (!box) {
            tell("shadescope bug: --pool {}: expected file or a stage's name\n", pipeline::inQuotes(name));
            return kWrongUsage;
        }
        boxes.push_back(*box);
    }
    if (lessons::riddleCount(boxes) == 0) {
        tell("shadescope bug: --pool: no error of the game is of these stages\n");
        return kWrongUsage;
    }
    if (writes && options.folder.empty()) {
        tell("shadescope bug: -o needs the name of a folder\n");
        return kWrongUsage;
    }
    // Four digits, to be told in a class.
    const auto now = std::uint64_t(std::chrono::system_clock::now().time_since_epoch().count());
    const std::uint64_t seed = options.seed.value_or(1000 + now / 1000 % 9000);
    if (writes) return writeQuizOf(seed, options.count.value_or(5), boxes, options);
    return playBugs(seed, options.count.value_or(1), boxes);
}

}  // namespace

void declareBug(CLI::App& program, const CliHost&, int& status) {
    const auto options = std::make_shared<BugOptions>();
    CLI::App* command = program.add_subcommand("bug", "Find the error in a wrong picture, or write a quiz of them");
    command->add_option("--seed", options->seed, "Which pictures: the same seed gives the same ones")->type_name("N");
    command->add_option("--count", options->count, "How many pictures: 1 to play, 5 in a quiz")
        ->type_name("N")
        ->check(CLI::Range(1, 100));
    command->add_option("--pool", options->pool, "Where the errors may be: file or stages, with commas between")
        ->type_name("STAGE")
        ->delimiter(',');
    command->add_option("--level", options->level, "B: without the right picture beside")
        ->check(CLI::IsMember({"B"}))
        ->capture_default_str();
    CLI::Option* folder =
        declareFolder(*command, options->folder, "Write quiz.html and quiz-answers.html into this folder");
    declareForce(*command, options->force)->needs(folder);
    command->callback([options, folder, &status] { status = runBug(*options, folder->count() > 0); });
}

}  // namespace app
