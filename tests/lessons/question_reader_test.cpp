#include <set>

#include "lessons/grading/sheet.h"
#include "lessons/lesson.h"
#include "lessons/library.h"
#include "lessons/questions/attempt.h"
#include "lessons/questions/hidden.h"
#include "lessons/questions/misconceptions.h"
#include "tests/lessons/pyramid_scene.h"

namespace lessons {
namespace {

pipeline::Result<Lesson> questionLesson(std::string_view pages) {
    return parseLesson("title: T\nlecture: L\nsummary: S\nscene: pyramid\n" + std::string(pages), "lesson.md",
                       [](std::string_view) -> pipeline::Result<pipeline::Scene> { return pyramidScene(); });
}
Page questionPage(std::string_view page) {
    const auto lesson = questionLesson(page);
    EXPECT_TRUE(lesson) << format(lesson ? pipeline::Errors() : lesson.errors());
    return lesson ? lesson->pages.front() : Page();
}
std::string questionErrors(std::string_view page) {
    const auto lesson = questionLesson(page);
    return lesson ? "" : format(lesson.errors());
}

TEST(QuestionReader, ReadsANumberWithItsMistakesHintsAndSecondHalf) {
    const Page page = questionPage(
        "# One\n"
        "hides: vertices.screen, counts\n"
        "panels: settings\n"
        "\n"
        "Text.\n"
        "\n"
        "screen: Turn the view.\n"
        "\n"
        "paper: Turn the sheet.\n"
        "\n"
        "question: Which row?\n"
        "answer: floor(buffer(vertices.screen, 2, y))\n"
        "tolerance: 2 %\n"
        "unit: px\n"
        "mistake y-up: 480 - buffer(vertices.screen, 2, y)\n"
        "  You counted\n"
        "  from the bottom.\n"
        "hint: One.\n"
        "hint: Two.\n"
        "works: 1 + 1\n"
        "= {answer}\n"
        "points: 2\n"
        "\n"
        "## then\n"
        "stage: cull\n"
        "set: cull = none\n"
        "\n"
        "It is there.\n");
    ASSERT_TRUE(page.question);
    const Question& question = *page.question;
    const auto& number = std::get<NumberQuestion>(question.kind);
    EXPECT_EQ(number.tolerance, 0.02);
    EXPECT_TRUE(number.relative);
    EXPECT_EQ(number.unit, "px");
    ASSERT_EQ(number.mistakes.size(), 1u);
    EXPECT_EQ(number.mistakes[0].id, "y-up");
    EXPECT_EQ(withGaps(number.mistakes[0].said), "You counted\nfrom the bottom.");
    EXPECT_EQ(question.hints.size(), 2u);
    EXPECT_EQ(withGaps(question.works), "1 + 1\n= …");
    EXPECT_EQ(question.points, 2);
    EXPECT_EQ(withGaps(page.first.text), "Text.\n\nTurn the view.\n");
    EXPECT_EQ(withGaps(page.first.paper), "Text.\n\nTurn the sheet.");
    ASSERT_TRUE(page.then);
    EXPECT_EQ(withGaps(page.then->text), "It is there.");
    EXPECT_EQ(page.then->state.window.stage, pipeline::StageId::Cull);
    EXPECT_EQ(shownBuffers(page.then->state), shownBuffers(page.first.state)) << "it begins as the first half";
    EXPECT_EQ(page.first.state.scene.settings.cull, pipeline::CullMode::Back);
    EXPECT_EQ(page.then->state.scene.settings.cull, pipeline::CullMode::None);
    EXPECT_EQ(page.panels, std::vector<Part>{Part::Settings});
}

TEST(QuestionReader, ReadsChoicesSeveralClicksAndUntil) {
    const Page choice = questionPage(
        "# One\n"
        "Text.\n"
        "question: Is it kept?\n"
        "choice: Yes. | if verdict(1) = kept | Right, it is.\n"
        "choice cull-sign: No. | if verdict(1) = back-facing | It shows\n"
        "  its front.\n");
    const auto& options = std::get<ChoiceQuestion>(choice.question->kind).options;
    ASSERT_EQ(options.size(), 2u);
    EXPECT_EQ(withGaps(options[0].text), "Yes.");
    EXPECT_EQ(withGaps(options[1].said), "It shows\nits front.");
    EXPECT_EQ(options[1].mistake, "cull-sign");

    const Page several = questionPage(
        "# One\n"
        "Text.\n"
        "question: Which?\n"
        "several: Left | if verdict(0) = back-facing | polygon 0\n"
        "several hidden-for-back: Back | if verdict(3) = back-facing | polygon 3 | It is thin.\n"
        "mistake cull-sign: opposite\n"
        "  The others.\n");
    const auto& question = std::get<SeveralQuestion>(several.question->kind);
    EXPECT_EQ(question.options[1].thing, (Thing{ThingKind::Polygon, 3}));
    ASSERT_TRUE(question.opposite);
    EXPECT_EQ(question.opposite->id, "cull-sign");

    const Page click =
        questionPage("# One\nText.\nquestion: Where?\nclick: pixel\nnear: at_largest(n_dot_l.0) within 6 px\n");
    EXPECT_EQ(std::get<ClickQuestion>(click.question->kind).within, 6);
    const Page polygon = questionPage(
        "# One\nText.\nquestion: Which?\nclick: polygon\nanswer: verdict(pick.polygon) = kept\n"
        "mistake cull-sign: verdict(pick.polygon) = back-facing\n  No.\n");
    EXPECT_EQ(std::get<ClickQuestion>(polygon.question->kind).kind, ThingKind::Polygon);

    const Page until = questionPage(
        "# One\nText.\nquestion: Turn n.\nuntil: buffer(specular.0, 268, 281, b) >= 0.5\n"
        "free: material.0.n\nanswer: material.0.n = 2 + 2\n");
    EXPECT_EQ(std::get<UntilQuestion>(until.question->kind).free, std::vector<std::string>{"material.0.n"});
}

TEST(QuestionReader, ReadsItemsToBePutInOrder) {
    const Page page = questionPage(
        "# One\nText.\nquestion: Which first?\norder: Right | by buffer(vertices.view, 2, z)\n"
        "order: Apex | by buffer(vertices.view, 4, z)\norder: Shading | stage shading\nends: near | far\n"
        "mistake nearest-first: opposite\n  No.\nmistake file-order: A, C, B\n  No.\n");
    const auto& order = std::get<OrderQuestion>(page.question->kind);
    ASSERT_EQ(order.items.size(), 3u);
    EXPECT_EQ(withGaps(order.items[1].text), "Apex");
    EXPECT_EQ(order.items[2].stage, pipeline::StageId::Shading);
    EXPECT_EQ(order.first + ',' + order.last, "near,far");
    ASSERT_EQ(order.mistakes.size(), 2u);
    EXPECT_TRUE(order.mistakes[0].order.empty());
    EXPECT_EQ(order.mistakes[1].order, (std::vector<std::size_t>{0, 2, 1}));
    EXPECT_TRUE(hiddenOn(page, false).hides({pipeline::BufferId::VerticesView})) << "the answer is read from it";
}

TEST(QuestionReader, MakesOptionsOfTheStages) {
    const Page page = questionPage(
        "# One\nset: defect = normal-flip\n\nText.\nquestion: Which?\ndiffers: defect = none\n"
        "mistake symptom-for-cause: shading\n  It shows there.\n");
    const auto& choice = std::get<ChoiceQuestion>(page.question->kind);
    EXPECT_TRUE(choice.ofStages);
    ASSERT_EQ(choice.options.size(), pipeline::kStageCount);
    EXPECT_EQ(withGaps(choice.options[2].text), "Normals");
    EXPECT_EQ(choice.options[5].mistake, "symptom-for-cause");
    EXPECT_EQ(choice.options[4].mistake, "");
}

struct WrongQuestion {
    const char* page;
    const char* errors;
};

TEST(QuestionReader, AnswersWhatIsWrongWithLineAndColumn) {
    const WrongQuestion cases[]{
        {"# One\nText.\nquestion: Q?\nanswer: 1\nmistake y-upp: 2\n  No.\n",
         "lesson.md:9:1: no row in lessons/misconceptions.md for the mistake \"y-upp\"; the nearest is \"y-up\"\n"},
        {"# One\nText.\nquestion: Q?\nanswer: 1\nmistake y-up: 2\n",
         "lesson.md:9:1: found a mistake without its sentence, expected what is said, on the next line\n"},
        {"# One\nText.\nquestion: Q?\nanswer: verdict(0)\n",
         "lesson.md:8:9: found \"verdict(0)\", expected one number\n"},
        {"# One\nText.\nquestion: Q?\nchoice: A | if 1 = 1\n",
         "lesson.md:8:1: found 1 option, expected 2 to 9 lines with \"choice\"\n"},
        {"# One\nText.\nquestion: Q?\nchoice: A | if 1 = 1\nchoice: B | no\n",
         "lesson.md:9:1: found an option without its condition, expected TEXT | if CONDITION | what is said\n"},
        {"# One\nText.\nquestion: Q?\nanswer: 1\nfree: material.0.n\n",
         "lesson.md:9:1: found \"free\" in a question of kind number, expected it in one of kind until\n"},
        {"# One\nText.\nquestion: Q?\norder: A | by 1\n",
         "lesson.md:8:1: found 1 item, expected 2 to 9 lines with \"order\"\n"},
        {"# One\nText.\nquestion: Q?\norder: A | by 1\norder: B | 2\n",
         "lesson.md:9:12: found an item without its place, expected TEXT | by EXPRESSION, or TEXT | stage NAME\n"},
        {"# One\nText.\nquestion: Q?\norder: A | by 1\norder: B | stage shadin\n",
         "lesson.md:9:12: no stage \"shadin\"; the nearest is \"shading\"\n"},
        {"# One\nText.\nquestion: Q?\norder: A | by 1\norder: B | by 2\nmistake draw-order: A, A\n  No.\n",
         "lesson.md:10:21: found \"A, A\", expected \"opposite\", or each item's letter once: C, A, B\n"},
        {"# One\nText.\nquestion: Q?\nends: a | b\nanswer: 1\n",
         "lesson.md:8:1: found \"ends\" in a question of kind number, expected it in one of kind order\n"},
        {"# One\nText.\nquestion: Q?\ndiffers: cul=none\n",
         "lesson.md:8:10: no setting \"cul\"; the nearest is \"cull\"\n"},
        {"# One\nText.\nquestion: Q?\nclick: face\nanswer: pick.x > 1\n",
         "lesson.md:8:8: found \"face\", expected pixel, polygon, vertex, object or light\n"},
        {"# One\nText.\n## then\nMore.\n", "lesson.md:7:1: found \"## then\" without a question before it\n"},
        {"# One\nlet: polygons = 5\n\nText.\n",
         "lesson.md:6:6: found the name \"polygons\": Buffers' names begin with it.\n"},
        {"# One\nplace: z-bufer\n\nText.\n", "lesson.md:6:8: place: no stage \"z-bufer\""},
        {"# One\noverlays: edgs\n\nText.\n", "lesson.md:6:11: no overlay \"edgs\"; the nearest is \"edges\"\n"},
        {"# One\nselected: polygon 5\n\nText.\n",
         "lesson.md:6:11: found \"polygon 5\", expected something that the scene has\n"},
        {"# One\nspace: moon\n\nText.\n",
         "lesson.md:6:8: found the space \"moon\", expected world, eye, clip, screen, light 0, light 0 -x or point\n"},
        {"# One\nbuffers: color, depth\nzoom: 2; 3; 4\n\nText.\n",
         "lesson.md:7:7: found values for 3 views, expected one for all, or 2 with \";\" between them\n"},
        {"# One\nhides: dept\n\nText.\n", "lesson.md:6:8: no buffer \"dept\"; the nearest is \"depth\"\n"},
        {"# One\nText.\nquestion: Q?\nanswer: 1\n## then\nMore.\nquestion: R?\n",
         "lesson.md:11:1: found \"question: R?\" after \"## then\", expected the next page: the question stands before "
         "\"## "
         "then\"\n"},
    };
    for (const WrongQuestion& wrong : cases)  // of a long message the beginning
        EXPECT_EQ(questionErrors(wrong.page).substr(0, std::string(wrong.errors).size()), wrong.errors) << wrong.page;
}

TEST(QuestionReader, APageTakesTheKeysOfACue) {
    const Page page = questionPage(
        "# One\n"
        "set: shading = gouraud\n"
        "stage: z-buffer\n"
        "place: z-buffer/polygon=2/row=270\n"
        "step: pixel\n"
        "buffers: color, n_dot_l.0\n"
        "overlays: edges, verdict; \n"
        "against: setting shading=gouraud; \n"
        "compare: wipe\n"
        "wipe: 0.25\n"
        "zoom: 8 at 268.5, 281.5\n"
        "region: 1, 2, 30, 40\n"
        "space: eye\n"
        "camera: target = 335, 75, 0; right = 1, 0, 0; up = 0, 0, 1; forward = 0, 1, 0; distance = 900; fov = 20\n"
        "options: normals = 1, lobe = 1\n"
        "pins: 1: 268, 281; 2: 250, 270\n"
        "condition: n_dot_l.0 > 0.5\n"
        "mix: specular.0=muted\n"
        "selected: polygon 3\n"
        "linked: on\n"
        "channel: r\n"
        "\nText.\n"
        "question: Q?\nanswer: 1\n## then\nplace: z-buffer\nset: cull = none\n\nMore.\n");
    const WindowState& window = page.first.state.window;
    EXPECT_EQ(text(*window.place), "z-buffer/polygon=2/row=270");
    EXPECT_EQ(window.step, pipeline::StepLevel::Pixel);
    ASSERT_EQ(window.views.size(), 2u);
    EXPECT_EQ(window.views[0].overlays, (std::vector<std::string>{"edges", "verdict"}));
    EXPECT_EQ(window.views[1].overlays, BufferShown().overlays) << "an empty part says nothing";
    ASSERT_TRUE(window.views[0].compared);
    EXPECT_EQ(window.views[0].compared->with, "setting shading=gouraud");
    EXPECT_EQ(window.views[0].compared->wipe, 0.25);
    EXPECT_FALSE(window.views[1].compared);
    EXPECT_EQ(window.views[1].zoom->factor, 8);
    EXPECT_EQ(window.views[0].region, (std::array<int, 4>{1, 2, 30, 40}));
    EXPECT_EQ(window.spaces[0].space, "eye");
    EXPECT_EQ(window.spaces[0].camera->distance, 900);
    EXPECT_EQ(window.spaces[0].options.at("lobe"), 1);
    EXPECT_EQ(window.pins.at(2), (std::array<int, 2>{250, 270}));
    EXPECT_EQ(window.condition, "n_dot_l.0 > 0.5");
    EXPECT_EQ(window.mix, "specular.0=muted");
    EXPECT_EQ(window.selected, (Selection{Selection::Kind::Polygon, 3}));
    EXPECT_EQ(window.linked, true);
    EXPECT_EQ(window.channel, 0);
    EXPECT_EQ(window.scene, "pyramid");
    EXPECT_EQ(window.set, std::vector<std::string>{"shading = gouraud"});
    const WindowState& then = page.then->state.window;
    EXPECT_EQ(text(*then.place), "z-buffer");
    EXPECT_EQ(then.views, window.views) << "it begins as the first half";
    EXPECT_EQ(then.set.size(), 2u);
}

TEST(QuestionReader, APageOfBuffersAloneShowsNoOtherView) {
    EXPECT_EQ(questionPage("# One\nText.\n").first.state.window.arrangement, "buffer");
    EXPECT_EQ(questionPage("# One\nbuffers: color, depth\n\nText.\n").first.state.window.arrangement, "compare");
    EXPECT_EQ(questionPage("# One\nspace: eye\n\nText.\n").first.state.window.arrangement, "one");
}

// What the answer is read from is hidden without a word of the author, unless the question is about what is shown.
TEST(Hidden, IsWhatTheAnswerIsReadFromAndWhatThePageNames) {
    const Page page = questionPage(
        "# One\nhides: polygons.verdict, counts\n\nText.\nquestion: Q?\nanswer: buffer(vertices.screen, 2, y)\n## "
        "then\nMore.\n");
    const Hidden hidden = hiddenOn(page, false);
    EXPECT_TRUE(hidden.hides({pipeline::BufferId::VerticesScreen}));
    EXPECT_TRUE(hidden.hides({pipeline::BufferId::PolygonsVerdict}));
    EXPECT_TRUE(hidden.hides(Part::Counts));
    EXPECT_TRUE(hidden.hides(Part::Inspector));
    EXPECT_FALSE(hidden.hides({pipeline::BufferId::Color}));
    EXPECT_TRUE(hidden.thenHalf);
    EXPECT_EQ(hidden.count(), 4u);
    EXPECT_EQ(hiddenOn(page, true).count(), 0u);

    const Page shown = questionPage(
        "# One\nbuffers: n_dot_l.0\npanels: inspector\n\nText.\nquestion: Q?\nanswer: acos(buffer(n_dot_l.0, 268, "
        "281))\n");
    EXPECT_EQ(hiddenOn(shown, false).count(), 0u);
}

// Those that the program names by itself, from a number alone, need no question: known_mistakes.cpp.
TEST(Misconceptions, EachIsUsedByAQuestion) {
    std::set<std::string> used{"sign", "twice", "half", "radians", "degrees", "cos-for-angle", "power-of-ten"};
    for (const Lesson& lesson : allLessons().lessons)
        for (const Page& page : lesson.pages)
            if (page.question) used.merge(mistakeIds(*page.question));
    for (const std::string& name : sheetTemplateNames()) {
        const auto sheet = readSheetTemplate(sheetTemplateAt(name));
        ASSERT_TRUE(sheet) << name;
        for (const Misconception& row : misconceptions().rows)
            if (sheet->text.find("mistake " + row.id + ':') != std::string::npos) used.insert(row.id);
    }
    for (const Misconception& row : misconceptions().rows) EXPECT_TRUE(used.contains(row.id)) << row.id;
}

TEST(Misconceptions, AreOneTableWithoutFaults) {
    EXPECT_EQ(format(misconceptions().errors), "");
    EXPECT_GT(misconceptions().rows.size(), 100u);
    for (const char* general : {"sign", "twice", "half", "radians", "degrees", "cos-for-angle", "power-of-ten"})
        EXPECT_TRUE(findMisconception(general)) << general;
    EXPECT_EQ(findMisconception("no such"), nullptr);
    EXPECT_EQ(parseMisconceptions("| id | name |\n|---|---|\n| a | b | | | |\n| a | c | | | |\n| d |\n", "m.md")
                  .errors.size(),
              2u);
}

}  // namespace
}  // namespace lessons
