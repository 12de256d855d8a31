// Sheets for a class, and its hand-ins graded.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

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

// An answer as a key writes it, as a student hands it in: "0.774 ± 0.002" is 0.774, "B: Gouraud" is B, "C, A: near; far"
// is C, A, and "for example x 226, y 280" is 226, 280.
std::string asHandedIn(const std::string& key) {
    std::smatch found;
    if (std::regex_search(key, found, std::regex("x (\\d+), y (\\d+)"))) return found[1].str() + ", " + found[2].str();
    if (std::regex_search(key, found, std::regex("^[A-I](, [A-I])+(?=: )"))) return found.str();
    const std::regex option("(^|; )([A-I]): ");
    std::string letters;
    for (std::sregex_iterator it(key.begin(), key.end(), option), end; it != end; ++it) letters += (*it)[2].str() + ' ';
    return letters.empty() ? key.substr(0, key.find(' ')) : letters;
}

// Each template that comes with the program gives sheets of six questions or more and of three kinds of answers, the manual
// names it, and what its key says has all points.
TEST(Class, EachTemplateOfTheProgramGivesSheetsWhoseKeysAreRight) {
    const fs::path all = fs::path(SHADESCOPE_SCENES) / ".." / "sheets";
    const std::string manual = test::readText(all / ".." / "manual" / "class.md");
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(all)) {
        const std::string name = entry.path().filename().string();
        SCOPED_TRACE(name);
        ++count;
        EXPECT_TRUE(test::has(manual, "| `" + name + "` |"));
        const test::TemporaryFolder folder;
        const auto made =
            run({"sheet", entry.path().string(), "--variants", "2", "--seed", "11", "-o", folder / "out"});
        ASSERT_EQ(made.status, 0) << made.err;
        const auto sheets = nlohmann::json::parse(test::readText(folder / "out/keys/sheets.json"))["sheets"];
        fs::create_directory(folder / "in");
        for (const auto& sheet : sheets) {
            nlohmann::json handedIn{{"version", 1}, {"sheet", sheet["sheet"]}, {"draw", sheet["draw"]}};
            std::set<std::string> kinds;
            EXPECT_GE(sheet["answers"].size(), 6u);
            for (std::size_t i = 0; i < sheet["answers"].size(); ++i) {
                const std::string key = sheet["answers"][i], given = asHandedIn(key);
                handedIn["answers"][std::to_string(i + 1)] = given;
                kinds.insert(test::has(key, " y ")           ? "place"
                             : !(given[0] >= 'A')            ? "number"
                             : given.find(',') == given.npos ? "choice"
                                                             : "order");
            }
            EXPECT_GE(kinds.size(), 3u);
            // Places are said in words, right ones and those of mistakes.
            const std::string page = "out/keys/sheet-0" + std::to_string(int(sheet["sheet"])) + "-key.html";
            EXPECT_FALSE(test::has(test::readText(folder / page), "pick."));
            test::writeText(folder / "in" / (std::to_string(int(sheet["sheet"])) + ".json"), handedIn.dump());
        }
        const auto graded =
            run({"grade", folder / "in", "--sheets", folder / "out/keys/sheets.json", "-o", folder / "class"});
        ASSERT_EQ(graded.status, 0) << graded.err;
        for (const auto& student : nlohmann::json::parse(test::readText(folder / "class/class.json"))["students"])
            EXPECT_EQ(student["points"], student["of"]) << test::readText(folder / "class/class.csv");
    }
    EXPECT_GE(count, 4u) << "two for each lecture";
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
