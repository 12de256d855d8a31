// Questions that return at the start of another lesson: pages of it that it does not copy, and that move none of its own.
#include <gtest/gtest.h>

#include "lessons/grading/grade.h"
#include "lessons/library.h"
#include "lessons/pages/handout.h"
#include "lessons/questions/judge.h"
#include "pipeline/scene/settings_table.h"
#include "tests/lessons/html_of.h"
#include "tests/lessons/pyramid_scene.h"
#include "tests/support/files.h"

namespace lessons {
namespace {

using pipeline::Error;
using pipeline::Result;

constexpr const char* kOther =
    "title: {The} *other*\nlecture: L\nsummary: S\nscene: theirs\nlet: two = 2\n"
    "# One\nNothing asked.\n"
    "# Two\nscene: broken\n\nNot read, as nobody asks for it.\n"
    "# Three\nset: material.0.n = 4\n\n{two} and n is {setting(material.0.n)}.\n\n"
    "question: What is n?\nanswer: two + 2\nright: Yes.\n";

// Scenes of the lesson are called "pyramid", those of the other one "theirs".
Result<Lesson> withReturns(const std::string& returns) {
    const auto scene = [](std::string_view known) -> SceneSource {
        return [known](std::string_view name) -> Result<pipeline::Scene> {
            if (name == known) return pyramidScene();
            return Error{{}, "no scene " + std::string(name), {}};
        };
    };
    return parseLesson("title: T\nlecture: L\nsummary: S\nscene: pyramid\nset: material.0.n = 20\nreturns: " + returns +
                           "\n# Own\nn is {setting(material.0.n)}.\n",
                       "lesson.md", scene("pyramid"), [&](std::string_view name) -> Result<LessonText> {
                           if (name != "other") return Error{{}, "no lesson " + std::string(name), {}};
                           return LessonText{kOther, "other.md", "/folder/of/other", scene("theirs")};
                       });
}

std::string said(const Page& page) {
    return filled(page.first.text, *frameOf(page.first.state.scene, requestFor(page))).value();
}

TEST(ReturningQuestions, ComeFirstWithTheScenesAndSettingsOfTheirOwnLesson) {
    const auto lesson = withReturns("other/3");
    ASSERT_TRUE(lesson) << format(lesson.errors());
    ASSERT_EQ(lesson->pages.size(), 2u);
    const Page& again = lesson->pages[0];
    EXPECT_EQ(again.heading, "Again: Three");
    EXPECT_EQ(said(again), "*From \"{The} *other*\", page 3.*\n\n2 and n is 4.") << "its title is no hole";
    EXPECT_EQ(said(lesson->pages[1]), "n is 20.");
    EXPECT_EQ(folderOf(*lesson, again), "/folder/of/other");
    Attempt attempt(*again.question);
    const auto frame = frameOf(again.first.state.scene, requestFor(again));
    const auto verdict = attempt.check(Typed{"4"}, {.frame = *frame});
    ASSERT_TRUE(verdict);
    EXPECT_EQ(verdict->mark, Mark::Right);
}

TEST(ReturningQuestions, DoNotMoveTheNumbersOfPages) {
    const auto lesson = withReturns("other/3");
    ASSERT_TRUE(lesson);
    EXPECT_EQ(returningPages(*lesson), 1u);
    EXPECT_EQ(pageName(*lesson, 0), "other/3");
    EXPECT_EQ(pageName(*lesson, 1), "1");
    const auto handout = makeHandout(*lesson);
    ASSERT_TRUE(handout) << format(handout.errors());
    EXPECT_NE(handout->pages.find("<h2>Again: Three</h2>"), std::string::npos);
    EXPECT_NE(handout->pages.find("<h2>1 Own</h2>"), std::string::npos);
}

TEST(ReturningQuestions, AreRefusedWithTheirPlace) {
    const auto errorsOf = [](const std::string& returns) {
        const auto lesson = withReturns(returns);
        return lesson ? "" : format(lesson.errors());
    };
    EXPECT_EQ(errorsOf("other/9"), "lesson.md:6:10: found page 9, expected a page from 1 to 3\n");
    EXPECT_EQ(errorsOf("other/1"), "lesson.md:6:10: this page asks nothing, expected a page with a question\n");
    EXPECT_EQ(errorsOf("nobody/1"), "lesson.md:6:10: no lesson nobody\n");
    EXPECT_EQ(errorsOf("other/3, other/3"), "lesson.md:6:19: this page returns a second time\n");
    for (const char* wrong : {"other", "other/", "other/0", "other/1.5", "other/nan", "other/1e30", "other/-1"})
        EXPECT_EQ(errorsOf(wrong),
                  "lesson.md:6:10: found \"" + std::string(wrong) + "\", expected LESSON/PAGE, as back-faces/3\n");
    // A sheet has no other lessons: the line is not passed over in silence.
    const auto sheet = parseLesson("title: T\nlecture: L\nsummary: S\nscene: pyramid\nreturns: a/1\n# One\nText.\n",
                                   "lesson.md", [](std::string_view) { return Result(pyramidScene()); });
    ASSERT_FALSE(sheet);
    EXPECT_EQ(format(sheet.errors()), "lesson.md:5:10: no page of another lesson returns here\n");
}

// A page with "again" in both halves: read in its own lesson, and where it returns.
TEST(ReturningQuestions, ReturnWithTheNumbersOfTheirLinesAgain) {
    const std::string text =
        "title: T\nlecture: L\nsummary: S\nscene: pyramid\nset: material.0.n = 2\n# One\nset: camera.rho = 900\n"
        "let: two = 2\nlet: three = two + 1\npixel: 10, 10\nagain: set: camera.rho = 950\nagain: set: material.0.n = "
        "5\n"
        "again: let: two = 20\nagain: pixel: 30, 30\n\nText.\nquestion: Q?\nanswer: three\n"
        "## then\nset: width = 320\nagain: set: width = 480\n\nMore.\n";
    const SceneSource scene = [](std::string_view) -> Result<pipeline::Scene> { return pyramidScene(); };
    const auto own = parseLesson(text, "lesson.md", scene);
    ASSERT_TRUE(own) << format(own.errors());
    const auto other = parseLesson("title: T\nlecture: L\nsummary: S\nscene: pyramid\nreturns: other/1\n# Own\nText.\n",
                                   "other.md", scene, [&](std::string_view) -> Result<LessonText> {
                                       return LessonText{text, "lesson.md", {}, scene};
                                   });
    ASSERT_TRUE(other) << format(other.errors());
    const auto numbers = [](const Page& page) {
        const pipeline::Scene& first = page.first.state.scene;
        const auto frame = frameOf(first, requestFor(page));
        const auto answer = evaluate(std::get<NumberQuestion>(page.question->kind).answer, {.frame = *frame});
        return std::vector<double>{pipeline::findSetting(first, "camera.rho")->get(first),
                                   pipeline::findSetting(first, "material.0.n")->get(first), answer->numbers[0],
                                   double(pickedPixel(page.first.state)->x),
                                   pipeline::findSetting(first, "width")->get(page.then->state.scene)};
    };
    EXPECT_EQ(numbers(own->pages[0]), (std::vector<double>{900, 2, 3, 10, 320}));
    EXPECT_EQ(numbers(other->pages[0]), (std::vector<double>{950, 5, 21, 30, 480}));
    for (const char* wrong : {"again: pixel", "again: buffers: color", "again: 3"}) {
        const auto bad = parseLesson(
            "title: T\nlecture: L\nsummary: S\nscene: pyramid\n# One\n" + std::string(wrong) + "\n\nText.\n",
            "lesson.md", scene);
        ASSERT_FALSE(bad) << wrong;
        EXPECT_NE(format(bad.errors()).find("\"against\" with its value"), std::string::npos) << format(bad.errors());
    }
}

// Who has kept a number in mind does not have the answer. A choice has other numbers in its scene.
TEST(ReturningQuestions, HaveOtherNumbersThanTheFirstTime) {
    const std::vector<Lesson> lessons = allLessons().lessons;
    const auto answerOf = [](const Page& page) {
        const auto& number = std::get<NumberQuestion>(page.question->kind);
        const auto frame = frameOf(page.first.state.scene, requestFor(page));
        const double answer = evaluate(number.answer, {.frame = *frame})->numbers[0];
        return std::pair(answer, toleranceOf(number, answer));
    };
    std::size_t numbers = 0;
    for (const Lesson& lesson : lessons)
        for (std::size_t i = 0; i < lesson.returns.size(); ++i) {
            const Lesson::Return& from = lesson.returns[i];
            SCOPED_TRACE(from.lesson + '/' + std::to_string(from.page));
            const Lesson& source = *std::ranges::find(lessons, from.lesson, &Lesson::name);
            const Page &again = lesson.pages[i], &first = source.pages[returningPages(source) + from.page - 1];
            if (std::holds_alternative<NumberQuestion>(first.question->kind)) {
                ++numbers;
                const auto [was, tolerance] = answerOf(first);
                EXPECT_GT(std::abs(answerOf(again).first - was), 2 * tolerance) << was;
            } else if (const auto* until = std::get_if<UntilQuestion>(&first.question->kind)) {
                ++numbers;
                const auto valuesOf = [](const UntilQuestion& asked, const Page& page) {
                    const auto frame = frameOf(page.first.state.scene, requestFor(page));
                    std::vector<double> values;
                    for (const UntilQuestion::Setting& one : asked.answer)
                        values.push_back(evaluate(*one.number, {.frame = *frame})->numbers[0]);
                    return values;
                };
                EXPECT_NE(valuesOf(*until, first), valuesOf(std::get<UntilQuestion>(again.question->kind), again));
            } else {
                EXPECT_NE(again.first.state.scene, first.first.state.scene);
            }
        }
    EXPECT_GE(numbers, 16u);
}

TEST(ReturningQuestions, TwoOfEachLessonReturnInTheNextButOne) {
    const std::vector<Lesson> lessons = allLessons().lessons;
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        SCOPED_TRACE(lessons[i].name);
        ASSERT_EQ(lessons[i].returns.size(), i < 2 ? 0u : 2u);
        for (const Lesson::Return& one : lessons[i].returns) EXPECT_EQ(one.lesson, lessons[i - 2].name);
        ASSERT_EQ(returningPages(lessons[i]), lessons[i].returns.size());
        for (std::size_t k = 0; k < lessons[i].returns.size(); ++k) {
            const Page& again = lessons[i].pages[k];
            const Page& first = lessons[i - 2].pages[returningPages(lessons[i - 2]) + lessons[i].returns[k].page - 1];
            EXPECT_EQ(again.heading, "Again: " + first.heading);
            EXPECT_EQ(withGaps(again.question->text), withGaps(first.question->text));
        }
    }
}

TEST(ReturningQuestions, AreMarkedWithThePageThatTheyComeFrom) {
    const auto camera = findLesson("camera");
    ASSERT_TRUE(camera);
    Results results;
    results.put(*camera, camera->pages[0], {Progress::Outcome::Right, 0, {{"310", true, "", 0, 3}}});
    results.put(*camera, camera->pages[2], {Progress::Outcome::Right, 0, {{"1", true, "", 0, 3}}});
    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder / "anna.json";
    test::writeText(file, toText(results));
    const auto graded = grade(std::span(&file, 1), nullptr);
    ASSERT_TRUE(graded);
    ASSERT_EQ(graded->answers.size(), 2u);
    EXPECT_EQ(graded->answers[0].page, camera->returns[0].lesson + '/' + std::to_string(camera->returns[0].page));
    EXPECT_EQ(graded->answers[1].page, "1") << "the lesson's own pages are called as before";
}

}  // namespace
}  // namespace lessons
