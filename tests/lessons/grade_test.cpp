#include "lessons/grade.h"

#include <gtest/gtest.h>
#include "lessons/csv_text.h"
#include "lessons/library.h"
#include "tests/support/files.h"

namespace lessons {
namespace {

namespace fs = std::filesystem;

class GradeTest : public testing::Test {
protected:
    fs::path handIn(const std::string& name, const std::string& text) {
        const fs::path file = m_folder / name;
        fs::create_directories(file.parent_path());
        test::writeText(file, text);
        m_files.push_back(file);
        return file;
    }
    // Page 2 of the pyramid, answered with one try.
    fs::path answered(const std::string& name, const char* outcome, const char* given, const char* mistake) {
        return handIn(name,
                      std::string(R"({"version": 1, "lessons": {"pyramid": {"Where one vertex goes": {"outcome": ")") +
                          outcome + R"(", "hints": 0, "tries": [{"given": ")" + given +
                          R"(", "right": false, "mistake": ")" + mistake + R"(", "hints": 0, "seconds": 3}]}}}})");
    }
    Graded graded(const SheetKeys* sheets = nullptr) {
        const auto done = grade(m_files, sheets);
        EXPECT_TRUE(done) << format(done ? pipeline::Errors() : done.errors());
        return done ? *done : Graded();
    }
    test::TemporaryFolder m_folder;
    std::vector<fs::path> m_files;
};

TEST_F(GradeTest, BadHandInsAreNamedAndTheOthersGraded) {
    answered("anna.json", "open", "169", "y-up");
    handIn("ben.json", "{");
    handIn("carl.json", R"({"version": 1, "lessons": {}})");
    handIn("dora.json", R"({"version": 1, "sheet": 3, "answers": {}})");
    answered("emil.json", "open", "311", "round-for-floor");
    m_files.push_back(m_folder / "none.json");
    const Graded all = graded();
    ASSERT_EQ(all.students.size(), 2u);
    EXPECT_EQ(all.students[1].name, "emil");
    ASSERT_EQ(all.refused.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(fs::path(all.refused[i].where.file).stem(),
                  std::vector<fs::path>({"ben", "carl", "dora", "none"})[i]);
    for (const char* name : {"ben", "carl", "dora", "none"})
        EXPECT_NE(toHtml(all).find(std::string(name) + ".json"), std::string::npos) << name;
}

// Two students with y-up, one of them twice; one with round-for-floor.
TEST_F(GradeTest, TheMisconceptionOfMostStudentsComesFirst) {
    answered("anna.json", "open", "311", "round-for-floor");
    answered("ben.json", "open", "169", "y-up");
    answered("carl.json", "open", "169", "y-up");
    const Graded all = graded();
    const auto shared = mistakesOf(all);
    ASSERT_EQ(shared.size(), 2u);
    EXPECT_EQ(shared[0].id, "y-up");
    EXPECT_EQ(shared[0].students, 2u);
    EXPECT_EQ(shared[1].students, 1u);
    ASSERT_FALSE(shared[0].treatedBy.empty());
    EXPECT_NE(toHtml(all).find("rows counted from the bottom"), std::string::npos);
}

TEST_F(GradeTest, WhatTheLessonNoLongerHasKeepsItsRow) {
    handIn(
        "anna.json",
        R"({"version": 1, "lessons": {"pyramid": {"A page of last year": {"outcome": "right", "hints": 0, "tries": []}},
            "gone": {"One": {"outcome": "right", "hints": 0, "tries": []}}}})");
    const Graded all = graded();
    ASSERT_EQ(all.answers.size(), 2u);
    for (const GradedAnswer& answer : all.answers) {
        EXPECT_FALSE(answer.note.empty());
        EXPECT_EQ(answer.points, 0);
    }
    EXPECT_NE(toCsv(all).find("A page of last year"), std::string::npos);
}

TEST_F(GradeTest, TwoHandInsOfOneNameAreToldApart) {
    answered("a/anna.json", "open", "1", "");
    answered("b/anna.json", "open", "2", "");
    const Graded all = graded();
    EXPECT_EQ(all.students[0].name, "a/anna");
    EXPECT_EQ(all.students[1].name, "b/anna");
}

// A stranger's text is neither markup nor a formula of a spreadsheet.
TEST_F(GradeTest, ForeignTextIsText) {
    answered("<b>anna.json", "open", "<script>alert(1)</script>", "<i>");
    answered("=HYPERLINK(1).json", "open", "=1+1", "");
    const Graded all = graded();
    EXPECT_EQ(toHtml(all).find("<script>"), std::string::npos);
    EXPECT_EQ(toHtml(all).find("<b>anna"), std::string::npos);
    EXPECT_EQ(toCsv(all).find(",=1+1"), std::string::npos);
    EXPECT_EQ(csvCell("=1+1"), "\"'=1+1\"");
    EXPECT_EQ(csvCell("-35.4"), "-35.4");
    EXPECT_EQ(csvCell("a, \"b\""), "\"a, \"\"b\"\"\"");
    EXPECT_EQ(csvCell("a\nb"), "a\\x0ab");
}

// Sheet 1 asks for 2 + 3, then for the larger of two, then for an order.
TEST_F(GradeTest, AnswersToASheetAreJudgedHere) {
    SheetKeys keys;
    keys.texts[1] =
        "title: T\nlecture: L\nsummary: S\nscene: pyramid\n# Sum\nText.\nquestion: 2 + 3?\nanswer: 5\n"
        "mistake off-by-base: 6\n  No.\n# Larger\nText.\nquestion: Which?\nchoice: One | if 1 > 2\n"
        "choice: Two | if 2 > 1\n# Order\nText.\nquestion: Upwards?\norder: two | by 2\norder: one | by 1\n";
    handIn("anna.json", R"({"version": 1, "sheet": 1, "answers": {"1": "10/2", "2": "b", "3": "B, A"}})");
    handIn("ben.json", R"({"version": 1, "sheet": 1, "answers": {"1": 6, "2": "?"}})");
    handIn("carl.json", R"({"version": 1, "sheet": 2, "answers": {"1": "5"}})");
    handIn("dora.json", R"({"version": 1, "sheet": 1, "answers": {"4": "5"}})");
    const Graded all = graded(&keys);
    ASSERT_EQ(all.students.size(), 2u);
    EXPECT_EQ(all.students[0].points, 3);
    EXPECT_EQ(all.students[0].full, 3);
    EXPECT_EQ(all.students[1].points, 0);
    EXPECT_EQ(all.answers[3].progress.tries.at(0).mistake, "off-by-base");
    EXPECT_EQ(all.answers[4].note, "no answer to such a question: \"?\"");
    EXPECT_EQ(all.answers[5].note, "not answered");
    EXPECT_EQ(all.refused.size(), 2u) << "no such sheet; no such question";
}

// Four items in order but for two neighbours: of 6 pairs 5 stand the right way round and 1 does not, (5 − 1) / 6 = 2/3.
// The opposite order has 0, and so has one of which as many pairs stand wrong as right: 3 and 3 of B, D, A, C.
TEST_F(GradeTest, AnOrderOnASheetHasTheShareOfItsPairs) {
    SheetKeys keys;
    keys.texts[1] =
        "title: T\nlecture: L\nsummary: S\nscene: pyramid\n# Order\nText.\nquestion: Upwards?\norder: a | by 1\n"
        "order: b | by 2\norder: c | by 3\norder: d | by 4\npoints: 3\nmistake draw-order: opposite\n  No.\n";
    const std::vector<std::pair<std::string, double>> cases{{"A, B, C, D", 3}, {"A, C, B, D", 2}, {"D, C, B, A", 0},
                                                            {"B, D, A, C", 0}, {"A, B", 0},       {"A, A, B, C", 0}};
    for (std::size_t i = 0; i < cases.size(); ++i)
        handIn(std::string(1, char('a' + i)) + ".json",
               R"({"version": 1, "sheet": 1, "answers": {"1": ")" + cases[i].first + R"("}})");
    const Graded all = graded(&keys);
    ASSERT_EQ(all.students.size(), cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) EXPECT_EQ(all.students[i].points, cases[i].second) << cases[i].first;
    EXPECT_EQ(all.answers[2].progress.tries.at(0).mistake, "draw-order") << "and the mistake has its name all the same";
}

// Each of these lost the hand-ins of the whole class, or led out of the folder that they came in.
TEST_F(GradeTest, AHostileHandInCostsNobodyElseTheirPoints) {
    SheetKeys keys;
    keys.texts[1] = "title: T\nlecture: L\nsummary: S\nscene: pyramid\n# Sum\nText.\nquestion: 2 + 3?\nanswer: 5\n";
    const std::string deep(100000, '['), end(100000, ']');
    handIn("deep.json", R"({"version": 1, "sheet": 1, "answers": {"1": )" + deep + end + "}}");
    handIn("deep2.json", deep);
    handIn("deep3.json", R"({"version": 1, "lessons": {"pyramid": {"x": )" + deep + end + "}}}");
    handIn("long.json", '"' + std::string(1 << 20, 'x'));  // a parser's message quotes what it has read
    const fs::path anna = handIn("anna.json", R"({"version": 1, "sheet": 1, "answers": {"1": "5"}})");
    fs::create_symlink(anna, m_folder / "link.json");
    fs::create_directories(m_folder / "folder.json");
    m_files.insert(m_files.end(), {m_folder / "link.json", m_folder / "folder.json"});
    const Graded all = graded(&keys);
    ASSERT_EQ(all.students.size(), 1u);
    EXPECT_EQ(all.students[0].points, 1);
    EXPECT_EQ(all.refused.size(), 6u);
    EXPECT_LT(toHtml(all).size(), 10000u);
}

TEST_F(GradeTest, ANameInAHandInLeadsToNoOtherFolder) {
    const fs::path own = m_folder / "own";
    fs::create_directories(own);
    fs::copy_file(lessonFolder() / "pyramid" / "lesson.md", own / "lesson.md");
    handIn("anna.json", R"({"version": 1, "lessons": {")" + own.string() +
                            R"(": {"Where one vertex goes": {"outcome": "right", "hints": 0, "tries": []}}}})");
    const Graded all = graded();
    ASSERT_EQ(all.answers.size(), 1u);
    EXPECT_EQ(all.answers[0].note, "no such lesson here");
}

// Sheets ask the same with other numbers: of three students on three sheets one row says how many were right.
TEST_F(GradeTest, TheTeachersPageCountsAQuestionOverAllSheets) {
    SheetKeys keys;
    for (const std::size_t sheet : {1, 2, 3}) {
        const std::string n = std::to_string(sheet);
        keys.texts[sheet] =
            "title: T\nlecture: L\nsummary: S\nscene: pyramid\n# Sum\nText.\nquestion: 2?\nanswer: " + n + "\n";
        handIn(n + ".json", R"({"version": 1, "sheet": )" + n + R"(, "answers": {"1": "1"}})");
    }
    const std::string html = toHtml(graded(&keys));
    const std::size_t row = html.find("all sheets");
    ASSERT_NE(row, std::string::npos);
    EXPECT_EQ(html.find("all sheets", row + 1), std::string::npos);
    EXPECT_NE(html.find("33 %", row), std::string::npos);
}

TEST_F(GradeTest, AnAnswerThatIsLeftEmptyIsNotAnswered) {
    SheetKeys keys;
    keys.texts[1] = "title: T\nlecture: L\nsummary: S\nscene: pyramid\n# Sum\nText.\nquestion: 2 + 3?\nanswer: 5\n";
    handIn("anna.json", R"({"version": 1, "sheet": 1, "answers": {"1": ""}})");
    EXPECT_EQ(graded(&keys).answers.at(0).note, "not answered");
}

TEST_F(GradeTest, AFolderStandsForItsFiles) {
    answered("class/b.json", "open", "1", "");
    answered("class/a.json", "open", "1", "");
    answered("class/below/c.json", "open", "1", "");
    handIn("class/notes.txt", "no hand-in");
    const std::vector<fs::path> paths{m_folder / "class", m_folder / "other.json"};
    EXPECT_EQ(handInsOf(paths), (std::vector<fs::path>{m_folder / "class" / "a.json", m_folder / "class" / "b.json",
                                                       m_folder / "other.json"}));
}

TEST_F(GradeTest, TellsOfEachHandInAndStopsBetweenThem) {
    for (const char* name : {"a.json", "b.json", "c.json"}) answered(name, "open", "1", "");
    std::stop_source source;
    std::size_t told = 0;
    const auto done = grade(m_files, nullptr, source.get_token(), [&](std::size_t) {
        if (++told == 2) source.request_stop();
    });
    ASSERT_FALSE(done);
    EXPECT_EQ(told, 2u);
}

}  // namespace
}  // namespace lessons
