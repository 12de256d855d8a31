// The game of the wrong picture.
#include "lessons/games/wrong_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

#include "lessons/games/bug_quiz.h"
#include "lessons/games/look_text.h"
#include "lessons/library.h"
#include "lessons/questions/misconceptions.h"
#include "tests/support/sweep.h"

namespace {

using namespace lessons;
using pipeline::BufferName;
using pipeline::Defect;
using pipeline::defectInfo;
using pipeline::DefectRow;

std::unique_ptr<WrongPicture> gameOf(Defect defect) {
    Riddle riddle;
    riddle.defect = defect;
    riddle.causes = {defect, Defect::YDown, Defect::CullSign, Defect::ZClear, Defect::LRaw};
    riddle.par = 3;
    auto scene = sceneOf(defectInfo(defect));
    EXPECT_TRUE(scene) << pipeline::format(scene.errors());
    riddle.right = std::make_shared<const pipeline::Scene>(std::move(scene).value());
    return WrongPicture::begin(std::move(riddle));
}

TEST(WrongPicture, ASeedGivesTheSameRiddlesAndNoneTwice) {
    std::set<Defect> defects;
    for (std::size_t number = 0; number < riddleCount(); ++number) {
        const auto one = makeRiddle(2026, number), again = makeRiddle(2026, number);
        ASSERT_TRUE(one && again);
        EXPECT_EQ(one->defect, again->defect);
        EXPECT_EQ(one->causes, again->causes);
        defects.insert(one->defect);
        EXPECT_EQ(std::ranges::count(one->causes, one->defect), 1);
        EXPECT_EQ(std::set(one->causes.begin(), one->causes.end()).size(), 5u);
        // Three of the same box where it has so many; one of another.
        const auto sameBox = std::ranges::count_if(
            one->causes, [&](Defect cause) { return boxOf(defectInfo(cause)) == boxOf(defectInfo(one->defect)); });
        EXPECT_LE(sameBox, 4);
    }
    EXPECT_EQ(defects.size(), riddleCount());
    EXPECT_FALSE(makeRiddle(2026, 0)->defect == makeRiddle(2027, 0)->defect &&
                 makeRiddle(2026, 1)->defect == makeRiddle(2027, 1)->defect);
}

TEST(WrongPicture, APoolKeepsToItsStages) {
    const std::vector<int> boxes{2, 5};
    for (std::size_t number = 0; number < riddleCount(boxes); ++number) {
        const auto riddle = makeRiddle(1, number, boxes);
        ASSERT_TRUE(riddle);
        const int box = boxOf(defectInfo(riddle->defect));
        EXPECT_TRUE(box == 2 || box == 5);
        EXPECT_EQ(riddle->par, 2) << "one look to halve two stages, one for the cause";
    }
    EXPECT_FALSE(makeRiddle(1, 0, {4})) << "no defect is in the shadow buffer's own text";
}

// By the rule: 100, less 5 for a look beyond par, 20 for a wrong stage, 10 for a hint, 20 for a wrong cause.
TEST(WrongPicture, PointsFollowFromLooksMarksHintsAndCauses) {
    const auto game = gameOf(Defect::ZNoWrite);
    ASSERT_TRUE(game);
    EXPECT_EQ(game->points(), 100);
    game->look(BufferName{pipeline::BufferId::Color});  // free
    for (const auto id :
         {pipeline::BufferId::VerticesScreen, pipeline::BufferId::PolygonsVerdict, pipeline::BufferId::PolygonsNormal})
        game->look(BufferName{id});
    game->look(BufferName{pipeline::BufferId::PolygonsNormal});  // once more
    EXPECT_EQ(game->looks().size(), 3u);
    EXPECT_EQ(game->points(), 100);
    game->look(glm::ivec2(320, 240));
    EXPECT_EQ(game->points(), 95);
    EXPECT_FALSE(game->mark(2).isRight);
    EXPECT_FALSE(game->mark(2).isRight) << "the same stage costs once";
    EXPECT_EQ(game->points(), 75);
    EXPECT_FALSE(game->hint().empty());
    EXPECT_EQ(game->points(), 65);
    EXPECT_TRUE(game->mark(5).isRight);
    EXPECT_EQ(game->phase(), WrongPicture::Phase::Cause);
    EXPECT_FALSE(game->name(3).isRight);
    EXPECT_EQ(game->points(), 45);
    EXPECT_TRUE(game->name(0).isRight);
    EXPECT_EQ(game->phase(), WrongPicture::Phase::Over);
    while (!game->hint().empty()) {
    }
    EXPECT_EQ(game->hints(), 3);
}

TEST(WrongPicture, NeverGivesFewerThanTenPoints) {
    const auto game = gameOf(Defect::YDown);
    for (int box = 0; box < kBoxes; ++box)
        if (box != 1) game->mark(box);
    EXPECT_EQ(game->points(), 10);
}

// For every defect of the game: each stage but the right one is told to have done what it should, with a run of its own
// that agrees in every value.
TEST(WrongPicture, AStageThatIsAccusedWronglyIsShownToDoWhatItShould) {
    const auto table = pipeline::defectTable();
    for (const std::size_t i : test::sweep(table.size())) {
        if (!table[i].inGame) continue;
        const auto game = gameOf(table[i].id);
        ASSERT_TRUE(game);
        const int right = boxOf(table[i]);
        for (int box = 1; box < kBoxes; ++box) {
            if (box == right) continue;
            const WrongPicture::Answer answer = game->mark(box);
            EXPECT_FALSE(answer.isRight);
            EXPECT_NE(answer.why.find("did what it should"), std::string::npos);
            EXPECT_TRUE(answer.why.find(": 0 of ") != std::string::npos ||
                        answer.why.find("left out") != std::string::npos)
                << table[i].idText() << ", " << boxLabel(box) << ": " << answer.why;
            EXPECT_NE(answer.why.find(box < right ? "comes later" : "comes earlier"), std::string::npos);
        }
        EXPECT_TRUE(game->mark(right).isRight);
    }
}

// Somebody who sees no picture: the text of a buffer that shows the error differs from that of the right frame.
TEST(WrongPicture, EveryDefectIsInTheTextOfABuffer) {
    for (const DefectRow& row : pipeline::defectTable()) {
        if (!row.inGame) continue;
        const auto game = gameOf(row.id);
        ASSERT_TRUE(game);
        bool isTold = false;
        for (const BufferName& name : pipeline::allBuffers(game->right()->scene().lights.size()))
            isTold = isTold || lookText(*game->right(), name) != lookText(*game->wrong(), name);
        EXPECT_TRUE(isTold) << row.idText();
    }
}

// The columns have names, and their numbers end below each other: the pyramid's file has its first vertex at 75, 75, 150.
TEST(WrongPicture, NumbersAreATableWithNames) {
    const auto frame = gameOf(Defect::Winding)->right();
    const std::string text = lookText(*frame, {pipeline::BufferId::VerticesWorld});
    std::vector<std::string> lines;
    std::istringstream stream(text.substr(text.find("\n\n") + 2));
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    ASSERT_GE(lines.size(), 2u) << text;
    std::istringstream names(lines[0]);
    EXPECT_EQ(std::vector<std::string>(std::istream_iterator<std::string>(names), {}),
              (std::vector<std::string>{"vertex", "x", "y", "z"}));
    for (const std::string& line : lines)
        EXPECT_TRUE(line.starts_with("and ") || line.size() == lines[0].size()) << text;
    EXPECT_NE(text.find("In world units"), std::string::npos) << "the unit";
}

TEST(WrongPicture, LooksDoNotNameTheDefect) {
    for (const Defect defect : {Defect::NoBias, Defect::ZNoWrite, Defect::Winding}) {
        const auto game = gameOf(defect);
        for (const BufferName& name : pipeline::allBuffers(1)) {
            const std::string text = game->look(name);
            EXPECT_EQ(text.find(defectInfo(defect).name), std::string::npos) << text;
            EXPECT_EQ(text.find("planted"), std::string::npos) << text;
        }
        const std::string pixel = game->look(glm::ivec2(320, 300));
        EXPECT_EQ(pixel.find("acne"), std::string::npos) << pixel;
    }
}

TEST(WrongPicture, TheRevealHasBothValuesBothEquationsAndTheFix) {
    const auto game = gameOf(Defect::LRaw);
    const std::string text = game->reveal();
    for (const std::string_view part :
         {"light_vector.0 differs in", "wrong:", "right:", "L = p_L − p", "|p_L − p|", "A vector that is too long"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST(WrongPicture, TheRevealOfADepthTestHasItsFragments) {
    const auto game = gameOf(Defect::ZFlip);
    const std::string text = game->reveal();
    EXPECT_NE(text.find("fragments, wrong:\n  polygon"), std::string::npos) << text;
    EXPECT_NE(text.find("passed, stays"), std::string::npos) << text;
}

TEST(WrongPicture, TheLessonsAndPagesThatRowsNameAreThere) {
    const Library library = allLessons();
    for (const DefectRow& row : pipeline::defectTable()) {
        if (row.lesson.empty()) continue;
        const auto lesson = std::ranges::find(library.lessons, row.lesson, &Lesson::name);
        ASSERT_NE(lesson, library.lessons.end()) << row.idText() << ": " << row.lesson;
        EXPECT_NE(std::ranges::find(lesson->pages, row.heading, &Page::heading), lesson->pages.end())
            << row.idText() << ": " << row.heading;
    }
}

TEST(WrongPicture, TheDefectsThatMisconceptionsNameArePlanted) {
    for (const Misconception& row : misconceptions().rows)
        EXPECT_TRUE(row.defect.empty() || pipeline::findDefect(row.defect)) << row.id << ": " << row.defect;
}

TEST(BugQuiz, TheQuestionsDoNotTellTheAnswersAndTheAnswersDo) {
    const auto quiz = makeBugQuiz(2026, 2, {});
    ASSERT_TRUE(quiz) << pipeline::format(quiz.errors());
    for (std::size_t number = 0; number < 2; ++number) {
        const DefectRow& row = defectInfo(makeRiddle(2026, number)->defect);
        EXPECT_EQ(quiz->questions.find(row.idText()), std::string::npos) << row.idText();
        EXPECT_NE(quiz->answers.find("box ticked"), std::string::npos);
        EXPECT_EQ(quiz->questions.find("box ticked"), std::string::npos);
        EXPECT_NE(quiz->questions.find("Something is wrong in " + std::string(row.scene)), std::string::npos);
    }
    EXPECT_FALSE(makeBugQuiz(1, 1000, {}));
}

}  // namespace
