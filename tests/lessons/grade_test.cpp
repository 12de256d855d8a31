#include "lessons/grading/grade.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "lessons/expression/changed_frames.h"
#include "lessons/grading/csv_text.h"
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
    // One row a student: Anna answered three rightly, Ben one wrongly.
    EXPECT_EQ(studentsCsv(all), "student,points,of,answers,right,mistakes\nanna,3,3,3,3,\nben,0,3,1,0,off-by-base\n");
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

// A sheet is handed in once: who predicts wrongly loses nothing, who leaves it out does.
TEST_F(GradeTest, AWrongPredictionOnASheetCountsNeitherWay) {
    SheetKeys keys;
    keys.texts[1] =
        "title: T\nlecture: L\nsummary: S\nscene: pyramid\n# One\nText.\nprediction: 2 + 3?\nanswer: 5\n"
        "# Two\nText.\nquestion: 2 + 2?\nanswer: 4\n";
    const std::pair<const char*, std::pair<double, double>> cases[]{{"5", {2, 2}}, {"9", {1, 1}}, {"", {1, 2}}};
    for (const auto& [given, points] : cases)
        handIn("with" + std::string(given) + ".json",
               R"({"version": 1, "sheet": 1, "answers": {"1": ")" + std::string(given) + R"(", "2": "4"}})");
    const Graded all = graded(&keys);
    ASSERT_EQ(all.students.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(all.students[i].points, cases[i].second.first) << cases[i].first;
        EXPECT_EQ(all.students[i].full, cases[i].second.second) << cases[i].first;
    }
}

// What somebody answers who has a misconception and otherwise knows everything. Nothing where the question has no answer
// of that misconception, or is answered by a hand in the picture.
std::optional<Given> answerOf(const Question& question, const std::string& id, const Context& context) {
    const auto typed = [&](const Expression& value) {
        return Given(Typed{fmt::format("{}", evaluate(value, context)->numbers[0])});
    };
    if (const auto* number = std::get_if<NumberQuestion>(&question.kind)) {
        if (id.empty()) return typed(number->answer);
        const auto mistake = std::ranges::find(number->mistakes, id, &Mistake::id);
        return mistake == number->mistakes.end() ? std::nullopt : std::optional(typed(mistake->value));
    }
    if (const auto* order = std::get_if<OrderQuestion>(&question.kind)) {
        const std::vector<std::size_t> right = *rightOrder(*order, context);
        if (id.empty()) return Ordered{right};
        for (const OrderQuestion::Wrong& wrong : order->mistakes)
            if (wrong.mistake.id == id)
                return Ordered{wrong.order.empty() ? decltype(right)(right.rbegin(), right.rend()) : wrong.order};
    }
    if (optionsOf(question).empty()) return {};
    const std::vector<std::size_t> right = *holdingOptions(optionsOf(question), context);
    if (id.empty()) return Chosen{right};
    const auto* several = std::get_if<SeveralQuestion>(&question.kind);
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < optionsOf(question).size(); ++i) {
        if (std::ranges::find(right, i) != right.end()) continue;
        others.push_back(i);
        if (optionsOf(question)[i].mistake != id) continue;
        std::vector<std::size_t> chosen = several ? right : std::vector<std::size_t>();
        chosen.push_back(i);
        return Chosen{chosen};
    }
    return several && several->opposite && several->opposite->id == id ? std::optional<Given>(Chosen{others})
                                                                       : std::nullopt;
}

// Thirty students. Number k has two misconceptions of those that four lessons know, drawn by a rule, and answers every
// question as they make one answer, then rightly; every tenth has none. The teacher's list is what they were given.
TEST_F(GradeTest, OfAClassOfThirtyTheMisconceptionsAreNamedAndNoOthers) {
    constexpr std::size_t kStudents = 30;
    std::vector<Lesson> lessons;
    std::set<std::string> known;
    for (const char* name : {"pyramid", "diffuse", "back-faces", "painter"}) {
        lessons.push_back(findLesson(name).value());
        for (const Page& page : lessons.back().pages)
            if (page.question) known.merge(mistakeIds(*page.question));
    }
    const std::vector<std::string> ids(known.begin(), known.end());
    ASSERT_GT(ids.size(), 30u);
    std::vector<Results> results(kStudents);
    std::map<std::string, std::set<std::size_t>> made;  // who made it
    for (const Lesson& lesson : lessons)
        runPages(lesson, {}, [&](const Page& page, std::size_t, const PageFrames& frames) {
            if (!page.question) return;
            ChangedFrames changed;
            const Context context{.frame = *frames.first, .changed = &changed};
            const auto right = answerOf(*page.question, "", context);
            for (std::size_t k = 0; right && k < kStudents; ++k) {
                Attempt attempt(*page.question);
                for (const std::size_t drawn : {7 * k, 11 * k + 5}) {
                    const std::string& id = ids[drawn % ids.size()];
                    const auto wrong = k % 10 == 0 ? std::nullopt : answerOf(*page.question, id, context);
                    if (!wrong || !attempt.progress().tries.empty()) continue;
                    ASSERT_TRUE(attempt.check(*wrong, context));
                    made[id].insert(k);
                }
                if (!attempt.isSettled()) {
                    const auto verdict = attempt.check(*right, context);
                    ASSERT_TRUE(verdict) << page.heading;
                    EXPECT_EQ(verdict->mark, Mark::Right) << page.heading << ": " << verdict->said;
                }
                results[k].put(lesson, page, attempt.progress());
            }
        });
    for (std::size_t k = 0; k < kStudents; ++k) handIn(fmt::format("student-{:02}.json", k), toText(results[k]));
    const Graded all = graded();
    ASSERT_EQ(all.students.size(), kStudents);
    std::map<std::string, std::size_t> expected, found;
    for (const auto& [id, students] : made) expected[id] = students.size();
    for (const SharedMistake& mistake : mistakesOf(all)) found[mistake.id] = mistake.students;
    EXPECT_EQ(found, expected);
    EXPECT_GT(expected.size(), 20u);
    for (const std::size_t k : {0, 10, 20}) EXPECT_EQ(all.students[k].points, all.students[k].full);
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
