#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

using Json = nlohmann::json;
using test::has;
using test::run;

TEST(Lesson, ListsAndShows) {
    const Json list = Json::parse(run({"lesson", "list", "--json"}).out);
    ASSERT_FALSE(list.empty());
    EXPECT_EQ(list[0]["name"], "pyramid") << "the way in comes first";
    const auto shown = run({"lesson", "show", "pyramid"});
    EXPECT_EQ(shown.status, 0) << shown.err;
    EXPECT_TRUE(has(shown.out, "# " + list[0]["title"].get<std::string>()));
    EXPECT_FALSE(has(shown.out, "{buffer(")) << "a number was not filled in";
    const Json pages = Json::parse(run({"lesson", "show", "pyramid", "--json"}).out)["pages"];
    ASSERT_EQ(pages.size(), list[0]["pages"]);
    EXPECT_EQ(pages[1]["question"]["answer"], 310);  // as lesson_data_test.cpp derives it
    EXPECT_EQ(pages[6]["pixel"], Json({268, 281}));
    EXPECT_EQ(pages[4]["question"]["kind"], "choice");
    EXPECT_TRUE(has(shown.out, pages[1]["text"].get<std::string>()));
    EXPECT_TRUE(has(shown.out, "- *Front*, because it is nearer.")) << "the options of a choice";
    EXPECT_FALSE(has(shown.out, pages[1]["then"]["text"].get<std::string>())) << "what comes after the answer";
    const auto whole = run({"lesson", "show", "pyramid", "--answers"});
    EXPECT_TRUE(has(whole.out, pages[1]["then"]["text"].get<std::string>()));
    EXPECT_TRUE(has(whole.out, pages[1]["question"]["works"].get<std::string>()));
    const auto unknown = run({"lesson", "show", "pyramide"});
    EXPECT_EQ(unknown.status, 3);
    EXPECT_TRUE(has(unknown.err, "the nearest is \"pyramid\"")) << unknown.err;
}

TEST(Lesson, IsWrittenAsAHandoutWholeOrNotAtAll) {
    const test::TemporaryFolder folder;
    const auto done = run({"lesson", "export", "pyramid", "-o", folder / "out"});
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(done.out, "");
    EXPECT_TRUE(has(done.err, "pyramid.html and pyramid-answers.html in ")) << done.err;
    EXPECT_TRUE(has(test::readText(folder / "out" / "pyramid.html"), "(335, 75, 150)"));
    EXPECT_EQ(run({"lesson", "export", "pyramide", "-o", folder / "none"}).status, 3);
    EXPECT_EQ(run({"lesson", "export", "pyramid"}).status, 2);
    EXPECT_EQ(run({"lesson", "export", "pyramid", "-o", ""}).status, 2);
    test::writeText(folder / "file", "");
    EXPECT_EQ(run({"lesson", "export", "pyramid", "-o", folder / "file"}).status, 4);
    EXPECT_EQ(folder.names(),
              (std::vector<std::string>{"file", "out", "out/pyramid-answers.html", "out/pyramid.html"}));
}

TEST(Lesson, IsCheckedForItsAuthor) {
    const auto good = run({"lesson", "check", "pyramid"});
    EXPECT_EQ(good.status, 0) << good.err;
    EXPECT_EQ(good.out, "The pyramid from its file to its last pixel: 9 pages and 9 questions are right.\n");
    const test::TemporaryFolder folder;
    test::writeText(
        folder / "lesson.md",
        "title: Mine\nlecture: L\nsummary: S\ncan: do it\nscene: pyramid\n\n# First\n\nText.\n\nquestion: Q?\n"
        "answer: 1\nmistake y-up: 1\n  No.\nhint: H\nworks: W\n");
    const auto bad = run({"lesson", "check", folder / "lesson.md"});
    EXPECT_EQ(bad.status, 3);
    EXPECT_TRUE(has(bad.err, "lesson.md:13:1: the mistake y-up is 1, which is a right answer")) << bad.err;
}

TEST(Lesson, ResultsAreListedAndForgotten) {
    const test::TemporaryFolder folder;
    const auto results = [&](const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"lesson", "results"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return test::runIn({"XDG_DATA_HOME=" + folder.path().string()}, arguments);
    };
    EXPECT_EQ(results({}).out, "No question has been answered yet.\n");
    std::filesystem::create_directories(folder / "shadescope");
    test::writeText(folder / "shadescope" / "results.json",
                    R"({"version": 1, "lessons": {"pyramid": {"Where one vertex goes": {"outcome": "right", "hints": 0,
                        "tries": [{"given": "169", "right": false, "mistake": "y-up", "hints": 0, "seconds": 9},
                                  {"given": "310", "right": true, "mistake": "", "hints": 0, "seconds": 20}]}}}})");
    const auto listed = results({});
    EXPECT_EQ(listed.status, 0) << listed.err;
    EXPECT_TRUE(has(listed.out, "1.5 of 15 points")) << listed.out;  // 2 less a quarter; five pages of 2, three of 1
    EXPECT_TRUE(has(listed.out, "rows counted from the bottom")) << listed.out;
    EXPECT_EQ(Json::parse(results({"--json"}).out)["lessons"].size(), 1u);
    EXPECT_EQ(results({"--forget"}).status, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "shadescope" / "results.json"));
}

TEST(Lesson, AFolderInPlaceOfItsPagesIsNamed) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "mine" / "lesson.md");
    const auto done = run({"lesson", "show", folder / "mine"});
    EXPECT_EQ(done.status, 3);
    EXPECT_EQ(done.err, (folder / "mine" / "lesson.md").string() + ": this is a folder, expected a file\n");
}

// An author's own, which is in no library, by its folder and by its file.
TEST(Lesson, IsFoundByItsPath) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "mine");
    test::writeText(folder / "mine" / "lesson.md",
                    "title: Mine\nlecture: L\nsummary: S.\nscene: pyramid\n\n# First\n\n2 + 3 is {2 + 3}.\n");
    for (const std::string path : {"mine", "mine/", "mine/lesson.md"}) {
        const auto done = run({"lesson", "show", (folder / path).string(), "--json"});
        ASSERT_EQ(done.status, 0) << done.err;
        const Json shown = Json::parse(done.out);
        EXPECT_EQ(shown["name"], "mine");
        EXPECT_EQ(shown["pages"][0]["text"], "2 + 3 is 5.");
    }
    test::writeText(folder / "mine" / "lesson.md", "title: Mine\nscene: pyramid\n\n# First\n\n{nothing()}\n");
    const auto broken = run({"lesson", "export", folder / "mine", "-o", folder / "out"});
    EXPECT_EQ(broken.status, 3);
    EXPECT_TRUE(has(broken.err, "mine/lesson.md:6:2: ")) << broken.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
