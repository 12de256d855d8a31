// Sheets for a class, and its hand-ins graded.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using test::run;

std::string answersTo(const nlohmann::json& sheet, const std::string& first) {
    return nlohmann::json{
        {"version", 1}, {"sheet", sheet["sheet"]}, {"draw", sheet["draw"]}, {"answers", {{"1", first}}}}
        .dump();
}

// Of the template that comes with the program: the answer of the key is graded right, that of a mistake by its name.
TEST(Class, HomeworkIsMadeHandedInAndGraded) {
    const test::TemporaryFolder folder;
    const std::string light = std::string(SHADESCOPE_SCENES) + "/../sheets/light";
    const auto made = run({"sheet", light, "--variants", "2", "--seed", "7", "--blank", "1", "-o", folder / "sheets"});
    ASSERT_EQ(made.status, 0) << made.err;
    for (const char* file : {"sheet-01.html", "sheet-02.html", "keys/sheet-01-key.html", "keys/sheets.csv",
                             "sheet-01-answers.json", "sheet-02-answers.json"})
        EXPECT_TRUE(fs::exists(folder / "sheets" / file)) << file;
    const auto keys = nlohmann::json::parse(test::readText(folder / "sheets/keys/sheets.json"));
    const std::string sheet = test::readText(folder / "sheets/sheet-01.html");
    EXPECT_NE(sheet.find("class=gap"), std::string::npos);

    // Handed in as it was given out, a sheet is no answer to any question, and counts.
    const auto empty = run({"grade", folder / "sheets/sheet-01-answers.json", "--sheets",
                            folder / "sheets/keys/sheets.json", "-o", folder / "empty"});
    EXPECT_EQ(empty.status, 0) << empty.err;
    EXPECT_NE(test::readText(folder / "empty/class.csv").find("not answered"), std::string::npos);

    const std::string first = keys["sheets"][0]["answers"][0];
    test::writeText(folder / "anna.json", answersTo(keys["sheets"][0], first.substr(0, first.find(' '))));
    test::writeText(folder / "ben.json", answersTo(keys["sheets"][1], "0"));
    const std::vector<std::string> command{"grade",
                                           (folder / "anna.json").string(),
                                           (folder / "ben.json").string(),
                                           "--sheets",
                                           (folder / "sheets/keys/sheets.json").string(),
                                           "-o",
                                           (folder / "class").string()};
    const auto graded = run(command);
    ASSERT_EQ(graded.status, 0) << graded.err;
    const auto json = nlohmann::json::parse(test::readText(folder / "class/class.json"));
    EXPECT_EQ(json["students"][0]["points"], 2);
    EXPECT_EQ(json["students"][1]["points"], 0);
    EXPECT_TRUE(fs::exists(folder / "class/class.csv"));
    EXPECT_TRUE(fs::exists(folder / "class/class.html"));

    auto strict = command;
    strict.insert(strict.end(), {"--pass", "30"});
    EXPECT_EQ(run(strict).status, 1) << "ben has no point";
    test::writeText(folder / "carl.json", "no JSON");
    strict.insert(strict.begin() + 1, (folder / "carl.json").string());
    const auto bad = run(strict);
    EXPECT_EQ(bad.status, 3);
    EXPECT_NE(bad.err.find("carl.json"), std::string::npos) << bad.err;
    EXPECT_EQ(nlohmann::json::parse(test::readText(folder / "class/class.json"))["students"].size(), 2u);
}

// A sheet, its key, its file to hand in and sheets.json say the same draw; answers to another draw have no mark.
TEST(Class, ADrawIsNamedEverywhereAndAnotherOneIsRefused) {
    const test::TemporaryFolder folder;
    const std::string light = std::string(SHADESCOPE_SCENES) + "/../sheets/light";
    for (const char* seed : {"1", "2"}) {
        const auto made = run({"sheet", light, "--variants", "2", "--seed", seed, "-o", folder / seed});
        ASSERT_EQ(made.status, 0) << made.err;
    }
    const auto one = nlohmann::json::parse(test::readText(folder / "1/keys/sheets.json"))["sheets"];
    const auto other = nlohmann::json::parse(test::readText(folder / "2/keys/sheets.json"))["sheets"];
    const std::string draw = one[0]["draw"], another = other[0]["draw"];
    EXPECT_NE(draw, another);
    EXPECT_NE(draw, one[1]["draw"].get<std::string>());
    for (const char* file :
         {"1/sheet-01.html", "1/sheet-01-answers.json", "1/keys/sheet-01-key.html", "1/keys/sheets.csv"})
        EXPECT_NE(test::readText(folder / file).find(draw), std::string::npos) << file;

    const std::string right = one[0]["answers"][0];
    test::writeText(folder / "anna.json", answersTo(one[0], right.substr(0, right.find(' '))));
    test::writeText(folder / "none.json", R"({"version": 1, "sheet": 1, "answers": {"1": "0"}})");
    const auto graded =
        run({"grade", folder / "anna.json", "--sheets", folder / "1/keys/sheets.json", "-o", folder / "a"});
    EXPECT_EQ(graded.status, 0) << graded.err;
    for (const char* handIn : {"anna.json", "none.json"}) {
        const auto refused =
            run({"grade", folder / handIn, "--sheets", folder / "2/keys/sheets.json", "-o", folder / "b"});
        EXPECT_EQ(refused.status, 3) << "the marks are of another draw";
        EXPECT_TRUE(test::has(refused.err, another)) << refused.err;
        EXPECT_EQ(test::has(refused.err, draw), handIn == std::string("anna.json")) << refused.err;
        EXPECT_TRUE(nlohmann::json::parse(test::readText(folder / "b/class.json"))["students"].empty());
    }

    // The same seed gives the same draw; with fewer sheets those that are too many go.
    ASSERT_EQ(run({"sheet", light, "--variants", "1", "--seed", "1", "-o", folder / "1"}).status, 0);
    EXPECT_EQ(
        nlohmann::json::parse(test::readText(folder / "1/keys/sheets.json"))["sheets"][0]["draw"].get<std::string>(),
        draw);
    for (const char* file : {"1/sheet-02.html", "1/sheet-02-answers.json", "1/keys/sheet-02-key.html"})
        EXPECT_FALSE(fs::exists(folder / file)) << file;
}

TEST(Class, WrongUsageAndFilesThatAreNotThere) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(run({"sheet", folder / "none", "-o", folder / "out"}).status, 3);
    EXPECT_EQ(run({"sheet", folder / "none"}).status, 2);
    EXPECT_EQ(run({"sheet", folder / "none", "-o", folder / "out", "--variants", "0"}).status, 2);
    EXPECT_EQ(run({"grade", "-o", folder / "out"}).status, 2);
    EXPECT_EQ(run({"grade", folder / "none.json", "-o", folder / "out"}).status, 3);
    EXPECT_EQ(run({"grade", folder / "none.json", "-o", folder / "out", "--sheets", folder / "none"}).status, 3);
    test::writeText(folder / "file", "");
    test::writeText(folder / "a.json",
                    R"({"version": 1, "lessons": {"pyramid": {"x": {"outcome": "open", "hints": 0, "tries": []}}}})");
    EXPECT_EQ(run({"grade", folder / "a.json", "-o", folder / "file" / "out"}).status, 4);
}

}  // namespace
