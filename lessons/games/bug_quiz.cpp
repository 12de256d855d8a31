#include "lessons/games/bug_quiz.h"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/games/wrong_picture.h"
#include "lessons/pages/handout_figure.h"
#include "pipeline/core/version.h"
#include "pipeline/export/folder/staging.h"
#include "pipeline/export/html/html_text.h"

namespace lessons {
namespace {

using pipeline::BufferId;
using pipeline::element;
using pipeline::escapedHtml;

constexpr std::string_view kQuizStyle = R"(
section { margin-top: 2rem; padding-top: 1.25rem; border-top: 1px solid #D0D5DC; break-before: page; }
section:first-of-type { break-before: auto; }
ul.boxes { list-style: none; padding: 0; columns: 2; } ul.causes { list-style: none; padding: 0; }
.box { display: inline-block; width: .9rem; height: .9rem; margin-right: .4rem; border: 1.5px solid #171A1F; vertical-align: -.1rem; }
.ticked { background: #171A1F; }
pre { font: .8rem/1.4 "JetBrains Mono", ui-monospace, monospace; white-space: pre-wrap; }
footer { margin-top: 3rem; color: #4A525D; font-size: .875rem; }
@media print { main { max-width: none; padding: 0; } body { font-size: 11pt; } figure, table, li { break-inside: avoid; } }
)";

std::string quizPage(const std::string& title, const std::string& about, const std::string& body) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n{}\n<style>{}{}{}</style>\n</head>\n<body>\n<main>\n"
        "{}\n{}\n{}<footer>Shadescope {}</footer>\n</main>\n</body>\n</html>\n",
        element("title", title), paperStyle(), kQuizStyle, figureStyle(), element("h1", title), element("p", about),
        body, escapedHtml(pipeline::programVersion()));
}

std::string box(bool ticked, std::string_view label) {
    return fmt::format("<li><span class=\"box{}\"></span>{}</li>\n", ticked ? " ticked" : "", escapedHtml(label));
}

std::string figure(const pipeline::Frame& frame, const pipeline::BufferName& name, std::string_view note = {}) {
    const pipeline::Tile whole{{0, 0}, {frame.scene().settings.width, frame.scene().settings.height}};
    return figureHtml(frame, name, whole, {}, {}, note);
}

// A buffer of each stage, and the first that is wrong where it is none of these.
std::vector<pipeline::BufferName> printedBuffers(const WrongPicture& game) {
    std::vector<pipeline::BufferName> names{
        {BufferId::VerticesScreen}, {BufferId::PolygonsVerdict}, {BufferId::PolygonsNormal}, {BufferId::ZView}};
    if (!game.wrong()->scene().lights.empty())
        for (const BufferId id : {BufferId::NDotL, BufferId::Shadow, BufferId::Specular}) names.push_back({id, 0});
    const BufferId first = game.row().first;
    const bool isThere =
        first == BufferId::Color || std::ranges::any_of(names, [&](const auto& name) { return name.id == first; });
    if (!isThere) names.push_back({first, pipeline::bufferInfo(first).perLight ? 0 : -1});
    // By the order of the stages, so that the place tells nothing.
    std::ranges::sort(names, {}, [](const pipeline::BufferName& name) { return index(name.id); });
    return names;
}

struct Pair {
    std::string question, answer;
};
Pair sectionsOf(const WrongPicture& game, std::size_t number) {
    const std::string heading = element("h2", fmt::format("{} Something is wrong in {}", number + 1, game.row().scene));
    std::string figures = figure(*game.wrong(), {BufferId::Color});
    for (const pipeline::BufferName& name : printedBuffers(game))
        if (game.wrong()->buffer(name)) figures += figure(*game.wrong(), name);
    const auto boxes = [&](bool ticked) {
        std::string text = "<ul class=boxes>\n";
        for (int i = 0; i < kBoxes; ++i) text += box(ticked && i == boxOf(game.row()), boxLabel(i));
        text += "</ul>\n" + element("p", "What is the cause?") + "<ul class=causes>\n";
        for (const pipeline::Defect cause : game.riddle().causes)
            text += box(ticked && cause == game.riddle().defect, defectInfo(cause).name);
        return text + "</ul>\n";
    };
    const std::string question = element("p", "Which is the first that leaves something wrong?");
    return {"<section>" + heading + "<div class=pictures>" + figures + "</div>\n" + question + boxes(false) +
                "</section>\n",
            "<section>" + heading + "<div class=pictures>" + figure(*game.wrong(), {BufferId::Color}, "Wrong") +
                figure(*game.right(), {BufferId::Color}, "Right") + "</div>\n" + boxes(true) +
                element("pre", game.reveal()) + "</section>\n"};
}

}  // namespace

pipeline::Result<BugQuiz> makeBugQuiz(std::uint64_t seed, std::size_t count, const std::vector<int>& boxes,
                                      const std::stop_token& stop, const std::function<void(std::size_t)>& progress) {
    if (const std::size_t most = riddleCount(boxes); count > most)
        return pipeline::Error{{}, fmt::format("{} pictures", count), fmt::format("at most {} of these stages", most)};
    std::string questions, answers;
    for (std::size_t number = 0; number < count; ++number) {
        if (progress) progress(number);
        auto riddle = makeRiddle(seed, number, boxes);
        if (!riddle) return riddle.errors();
        const auto game = WrongPicture::begin(std::move(riddle).value(), stop);
        if (!game) return pipeline::Error{{}, "stopped"};
        const Pair pair = sectionsOf(*game, number);
        questions += pair.question, answers += pair.answer;
    }
    const std::string about = fmt::format("Seed {}. Each picture has one error.", seed);
    return BugQuiz{quizPage("The wrong picture", about, questions),
                   quizPage("The wrong picture: answers", about, answers)};
}

std::vector<std::string> bugQuizFiles() { return {"quiz-answers.html", "quiz.html"}; }

pipeline::Result<std::vector<std::string>> writeBugQuiz(const BugQuiz& quiz, const std::filesystem::path& folder) {
    const std::vector<std::string> names = bugQuizFiles();
    return pipeline::writeFiles({{names[0], quiz.answers}, {names[1], quiz.questions}}, folder);
}

}  // namespace lessons
