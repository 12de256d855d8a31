#include "lessons/grading/sheet.h"

#include <set>

#include "lessons/grading/sheet_blanks.h"
#include "pipeline/export/folder/file_hash.h"
#include "tests/lessons/pyramid_scene.h"
#include "tests/support/files.h"

namespace lessons {
namespace {

// Asks for x times 10, where x is one of `values`.
std::string timesTen(std::string_view header) {
    return "title: T\nlecture: L\nsummary: S\ncan: count\nscene: pyramid\n" + std::string(header) +
           "\n# One\nText.\nquestion: How much?\nanswer: 10 * setting(light.0.x)\nhint: Ten times.\nworks: {answer}\n";
}
SheetTemplate templateOf(const test::TemporaryFolder& folder, std::string_view header) {
    test::writeText(folder / "lesson.md", timesTen(header));
    const auto made = readSheetTemplate(folder.path());
    EXPECT_TRUE(made) << format(made ? pipeline::Errors() : made.errors());
    return made ? *made : SheetTemplate();
}
std::string errorsOf(std::string_view header) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "lesson.md", timesTen(header));
    const auto made = readSheetTemplate(folder.path());
    return made ? "" : format(made.errors()).substr(folder.path().string().size() + 1);
}

TEST(Sheets, OfASeedAreTheSameAndOfAnotherOthers) {
    const test::TemporaryFolder folder;
    const SheetTemplate made = templateOf(folder, "vary light.0.x: 100..900+10\nvary light.0.y: 200, 300\n");
    const auto texts = [&](std::uint64_t seed) {
        std::vector<std::string> all;
        const auto sheets = makeSheets(made, {seed, 3, 0});
        EXPECT_TRUE(sheets) << format(sheets ? pipeline::Errors() : sheets.errors());
        if (sheets)
            for (const Sheet& sheet : sheets->sheets) all.push_back(sheet.text);
        return all;
    };
    const auto first = texts(7);
    ASSERT_EQ(first.size(), 3u);
    EXPECT_EQ(texts(7), first);
    EXPECT_NE(texts(8), first);
}

// Three values, three sheets: each value once; a fourth sheet has none left.
TEST(Sheets, HaveAnswersOfTheirOwn) {
    const test::TemporaryFolder folder;
    const SheetTemplate made = templateOf(folder, "vary light.0.x: 10..30+10\n");
    const auto sheets = makeSheets(made, {1, 3, 0});
    ASSERT_TRUE(sheets) << format(sheets.errors());
    std::set<std::string> answers;
    for (const Sheet& sheet : sheets->sheets) answers.insert(sheet.answers.at(0));
    EXPECT_EQ(answers, (std::set<std::string>{"100", "200", "300"}));
    const auto four = makeSheets(made, {1, 4, 0});
    ASSERT_FALSE(four);
    EXPECT_NE(format(four.errors()).find("none of 1000 draws fits as sheet 4"), std::string::npos);
}

TEST(Sheets, KeepWhatIsWorthWorkingOut) {
    const test::TemporaryFolder folder;
    const SheetTemplate made = templateOf(folder, "vary light.0.x: 10..30+10\nkeep: setting(light.0.x) > 25\n");
    const auto sheets = makeSheets(made, {1, 1, 0});
    ASSERT_TRUE(sheets) << format(sheets.errors());
    EXPECT_EQ(sheets->sheets[0].answers.at(0), "300");
}

TEST(Sheets, TellWhatIsWrongWithATemplate) {
    EXPECT_EQ(errorsOf(""),
              "lesson.md:1:1: nothing varies in this lesson, expected \"vary KEY: VALUES\" in its header\n");
    EXPECT_EQ(errorsOf("vary light.0.x: 9..1\n"), "lesson.md:6:17: found \"9..1\", expected FIRST..LAST+STEP\n");
    EXPECT_EQ(errorsOf("vary light.0.x: 0..1+0\n"), "lesson.md:6:17: found \"0..1+0\", expected FIRST..LAST+STEP\n");
    EXPECT_EQ(errorsOf("vary light.0.x: 0..1e300\n"),
              "lesson.md:6:17: found \"0..1e300\", expected FIRST..LAST+STEP\n");
    EXPECT_EQ(errorsOf("vary light.0.x\n"), "lesson.md:6:6: found \"light.0.x\", expected \"vary KEY: VALUES\"\n");
    EXPECT_EQ(errorsOf("vary p: pixel of polygon x\n"),
              "lesson.md:6:9: found \"pixel of polygon x\", expected pixel of polygon 2, 12 px inside\n");
    EXPECT_NE(errorsOf("vary light.0.x: 1, 2\nvary light.0.x: 3\n").find("a second time"), std::string::npos);
    const test::TemporaryFolder folder;
    const auto unknown = makeSheets(templateOf(folder, "vary lihgt.0.x: 1, 2\n"), {1, 1, 0});
    ASSERT_FALSE(unknown);
    EXPECT_NE(format(unknown.errors()).find("lihgt"), std::string::npos);
}

// The template that comes with the program: a pixel whose neighbours 6 px away show the same polygon.
TEST(Sheets, DrawAPixelInsideItsPolygon) {
    const auto made = readSheetTemplate(pipeline::resourceFolder() / "sheets" / "light");
    ASSERT_TRUE(made) << format(made.errors());
    const auto sheets = makeSheets(*made, {7, 2, 2});
    ASSERT_TRUE(sheets) << format(sheets.errors());
    const auto frame = frameOf(pyramidScene(), pipeline::BufferSet().set(index(pipeline::BufferId::PolygonId)));
    const auto ids = frame->buffer({pipeline::BufferId::PolygonId});
    for (const Sheet& sheet : sheets->sheets) {
        ASSERT_EQ(sheet.drawn.back().first, "spot");
        int x = 0, y = 0;
        ASSERT_EQ(std::sscanf(sheet.drawn.back().second.c_str(), "%d, %d", &x, &y), 2);
        for (const auto& [dx, dy] : {std::pair{0, 0}, {6, 0}, {-6, 0}, {0, 6}, {0, -6}})
            EXPECT_EQ(ids->value(std::size_t(x + dx), std::size_t(y + dy)), 2);
    }
}

TEST(Sheets, LeaveNumbersBlankThatTheKeyHas) {
    const Handout handout{
        "<main><section><table><tr><td>0</td><td class=number>1.5</td><td class=number>2.5</td></tr>"
        "<tr><td>1</td><td class=number>3.5</td></tr></table><div class=equation><p>I = 7 + 8 = 15</p><p>FB = 15</p>"
        "<p>x = 99</p></div></section></main>",
        "<main>Key<footer></footer></main>\n<!-- Answers to a handout of 5 bytes, SHA-256 x -->\n",
        {}};
    const auto all = blanked(handout, 9, 0);
    EXPECT_NE(all.sheet.find("<td class=number><span class=gap><b>1</b>&nbsp;</span></td>"), std::string::npos);
    EXPECT_EQ(all.sheet.find("3.5"), std::string::npos) << "the only number of its row";
    EXPECT_NE(all.sheet.find("1.5") == std::string::npos, all.sheet.find("2.5") == std::string::npos) << "one of a row";
    EXPECT_NE(all.sheet.find("= 15"), std::string::npos) << "the equation has it twice";
    EXPECT_EQ(all.sheet.find("99"), std::string::npos);
    EXPECT_NE(all.key.find("<li>99</li>"), std::string::npos);
    EXPECT_NE(all.key.find(pipeline::sha256Of(all.sheet)), std::string::npos);
    EXPECT_EQ(all.key.find("SHA-256 x"), std::string::npos);
    EXPECT_EQ(blanked(handout, 0, 0).sheet, handout.pages);
}

}  // namespace
}  // namespace lessons
