#include "lessons/questions/results.h"

#include "lessons/library.h"
#include "tests/lessons/pyramid_scene.h"
#include "tests/support/files.h"

namespace lessons {
namespace {

Progress someProgress() {
    return {Progress::Outcome::Right, 1, {{"1\u202f9\n", false, "y-up", 0, 3.25}, {"310", true, "", 1, 12}}};
}

TEST(Results, AreReadBackAsTheyWereWritten) {
    const Lesson lesson = *findLesson("pyramid");
    Results results;
    EXPECT_TRUE(results.empty());
    EXPECT_EQ(results.find(lesson, lesson.pages[1]), nullptr);
    results.put(lesson, lesson.pages[1], {Progress::Outcome::Shown, 2, {}});
    results.put(lesson, lesson.pages[0], {});
    const auto read = parseResults(toText(results), "results.json");
    ASSERT_TRUE(read) << format(read.errors());
    EXPECT_EQ(*read, results);

    const test::TemporaryFolder folder;
    const auto file = folder / "deep" / "results.json";
    EXPECT_TRUE(readResults(file)->empty()) << "nothing was answered yet";
    EXPECT_EQ(format(writeResults(results, file)), "");
    EXPECT_EQ(*readResults(file), results);
    results.forget("pyramid");
    EXPECT_EQ(format(writeResults(results, file)), "");
    EXPECT_FALSE(std::filesystem::exists(file)) << "forgotten is gone";
}

// Of a lesson whose questions are all settled, right or shown; asked once more it keeps its place.
TEST(Results, KnowInWhichOrderLessonsWereDone) {
    const Lesson pyramid = *findLesson("pyramid"), shadows = *findLesson("shadows");
    Results results;
    const auto settle = [&](const Lesson& lesson, Progress::Outcome outcome) {
        for (const Page& page : lesson.pages)
            if (!page.from) results.put(lesson, page, {outcome, 0, {}});
    };
    settle(shadows, Progress::Outcome::Open);
    EXPECT_TRUE(results.done().empty());
    settle(shadows, Progress::Outcome::Right);
    settle(pyramid, Progress::Outcome::Shown);
    settle(shadows, Progress::Outcome::Right);
    EXPECT_EQ(results.done(), (std::vector<std::string>{"shadows", "pyramid"}));
    const auto read = parseResults(toText(results), "results.json");
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, results);
    results.forget("shadows");
    EXPECT_EQ(results.done(), std::vector<std::string>{"pyramid"});
    results.forget();
    EXPECT_TRUE(results.empty() && results.done().empty());
    EXPECT_FALSE(parseResults(R"({"version": 1, "lessons": {}, "done": [5]})", "r"));
}

TEST(Results, OfAFileThatSomebodyHasChangedAreAnErrorOrHarmless) {
    for (const char* text :
         {"", "[]", "{}", R"({"version": 2, "lessons": {}})", R"({"version": 1, "lessons": {"a": {"b": 5}}})",
          R"({"version": 1, "lessons": {"a": {"b": {"outcome": "best", "hints": 0, "tries": []}}}})",
          R"({"version": 1, "lessons": {"a": {"b": {"outcome": "open", "hints": "x", "tries": []}}}})"})
        EXPECT_FALSE(parseResults(text, "results.json")) << text;
    const auto odd = parseResults(
        R"({"version": 1, "lessons": {"pyramid": {"Where one vertex goes": {"outcome": "open", "hints": 99, "tries": []}}}})",
        "r");
    ASSERT_TRUE(odd);
    const Lesson lesson = *findLesson("pyramid");
    const Page& page = lesson.pages[1];
    EXPECT_EQ(Attempt(*page.question, *odd->find(lesson, page)).hintsSeen(), page.question->hints.size());
}

TEST(Summary, SaysWhatWasReachedAndWhichMistakesWereMade) {
    const Lesson lesson = *findLesson("pyramid");
    Results results;
    results.put(lesson, lesson.pages[1], someProgress());  // of 2 points, after a wrong try and a hint
    results.put(lesson, lesson.pages[2], {Progress::Outcome::Shown, 0, {{"A", false, "y-up", 0, 0}}});
    const Summary summary = summaryOf(lesson, results);
    ASSERT_EQ(summary.pages.size(), lesson.pages.size());
    EXPECT_EQ(summary.pages[1].state, Attempt::State::Right);
    EXPECT_TRUE(summary.pages[1].hadMistake);
    EXPECT_EQ(summary.pages[1].points, 1);
    EXPECT_EQ(summary.points, 1);
    EXPECT_FALSE(summary.isDone);
    ASSERT_EQ(summary.mistakes.size(), 1u);
    EXPECT_EQ(summary.mistakes[0].name, "rows counted from the bottom");
    EXPECT_EQ(summary.mistakes[0].page, 1u);
    EXPECT_EQ(summary.mistakes[0].times, 2u);
}

}  // namespace
}  // namespace lessons
