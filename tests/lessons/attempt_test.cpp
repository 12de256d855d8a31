#include "lessons/questions/attempt.h"

#include "lessons/lesson.h"
#include "lessons/questions/known_mistakes.h"
#include "tests/lessons/pyramid_scene.h"

namespace lessons {
namespace {

class AttemptTest : public testing::Test {
protected:
    // Reads a page with this question of the pyramid; what is asked stands in lecture 1's numbers.
    void ask(std::string_view question) {
        const auto lesson = parseLesson(
            "title: T\nlecture: L\nsummary: S\nscene: pyramid\n# One\nText.\n" + std::string(question), "lesson.md",
            [](std::string_view) -> pipeline::Result<pipeline::Scene> { return pyramidScene(); });
        ASSERT_TRUE(lesson) << format(lesson.errors());
        m_page = lesson->pages.front();
        m_frame = frameOf(m_page.first.state.scene, requestFor(m_page));
        m_attempt.emplace(*m_page.question);
    }
    Verdict check(const Given& given) {
        const auto verdict = m_attempt->check(given, {.frame = *m_frame});
        EXPECT_TRUE(verdict) << format(verdict ? pipeline::Errors() : verdict.errors());
        return verdict ? *verdict : Verdict();
    }
    Verdict type(const char* text) { return check(Typed{text}); }
    // The verdict on a question that is asked anew.
    Verdict first(const char* text) {
        m_attempt.emplace(*m_page.question);
        return type(text);
    }
    Page m_page;
    pipeline::FramePtr m_frame;
    std::optional<Attempt> m_attempt;
};

// acos((22500 + 20250) / (30270.65·√3)) = 35.376°, see lesson_data_test.cpp
constexpr char kAngle[] =
    "question: What is the angle?\n"
    "answer: acos(buffer(n_dot_l.0, 240, 281))\n"
    "tolerance: 0.06\n"
    "unit: °\n"
    "mistake l-for-r: 39.23\n"
    "  That is another polygon's.\n"
    "hint: One.\n"
    "hint: Two.\n"
    "works: acos(0.815)\n"
    "= {answer : 1}\n"
    "right: It is {answer : 1}.\n"
    "points: 2\n";

TEST_F(AttemptTest, ANumberIsRightWithinItsToleranceInAnyForm) {
    ask(kAngle);
    for (const char* right : {"35.376", "35.4", "35,4", " 35.40 ° ", "acos(0.8154)", "353.76/10", "+35.37"})
        EXPECT_EQ(first(right).mark, Mark::Right) << right;
    EXPECT_EQ(first("35.376").said, "It is 35.4.");
    EXPECT_EQ(first("35,4").said, "Right: \"35,4\" is 35.4.\n\nIt is 35.4.");
    EXPECT_EQ(first("acos(0.8154)").said, "Right: \"acos(0.8154)\" is about 35.3731.\n\nIt is 35.4.");
}

TEST_F(AttemptTest, WhatIsNoNumberCostsNothingAndIsAnswered) {
    ask(kAngle);
    for (const char* none : {"", "  ", "abc", "1/0", "buffer(n_dot_l.0, 240, 281)", "setting(width)", "[1, 2]",
                             "with(cull=none; 1)", "pick.x", "nan", "inf"}) {
        EXPECT_EQ(type(none).mark, Mark::Again) << none;
    }
    EXPECT_EQ(type("abc").said, "\"abc\" is not a number. Type a number such as 0.5, 0,5, 1/2 or sqrt(2)/2.");
    EXPECT_EQ(type(std::string(5000, '(').c_str()).mark, Mark::Again);
    EXPECT_TRUE(m_attempt->progress().tries.empty());
    EXPECT_EQ(m_attempt->worth(), 2);
}

// Items C, A, B have the places 1, 2, 3.
constexpr char kOrder[] =
    "question: In which order?\n"
    "order: two | by 1 + 1\norder: three | by 3\norder: one | by 1\n"
    "mistake nearest-first: opposite\n  Round the other way.\n"
    "mistake file-order: A, B, C\n  As they stood.\n"
    "hint: Count.\nworks: 1, 2, 3\n";

TEST_F(AttemptTest, AnOrderIsRightAsAWholeAndItsMistakesHaveNames) {
    ask(kOrder);
    EXPECT_EQ(check(Ordered{{0, 1}}).mark, Mark::Again) << "one is missing";
    EXPECT_EQ(check(Ordered{{0, 1, 1}}).mark, Mark::Again) << "one stands twice";
    EXPECT_TRUE(m_attempt->progress().tries.empty());
    EXPECT_EQ(check(Ordered{{0, 1, 2}}).mistake, "file-order");
    EXPECT_EQ(check(Ordered{{1, 0, 2}}).mistake, "nearest-first");
    EXPECT_EQ(m_attempt->progress().tries.back().given, "B, A, C") << "in the reader's order";
    EXPECT_EQ(check(Ordered{{2, 0, 1}}).mark, Mark::Right);
    EXPECT_EQ(*answerText(*m_page.question, {.frame = *m_frame}), "C, A, B: one; two; three");
}

// The first two neighbours, with the numbers of those whose place is computed.
TEST_F(AttemptTest, AnUnknownOrderIsToldItsFirstWrongPair) {
    ask(kOrder);
    EXPECT_EQ(check(Ordered{{2, 1, 0}}).said, "Not yet: three stands before two (2).");
}

// The cross product in the other order changes what the third stage leaves; shading gets it.
TEST_F(AttemptTest, TheFirstStageThatDiffersIsFoundByTheProgram) {
    const auto lesson = parseLesson(
        "title: T\nlecture: L\nsummary: S\nscene: pyramid\n# One\nset: defect = normal-flip\n\nText.\nquestion: Q?\n"
        "differs: defect = none\nmistake symptom-for-cause: shading\n  It shows there.\n",
        "lesson.md", [](std::string_view) -> pipeline::Result<pipeline::Scene> { return pyramidScene(); });
    ASSERT_TRUE(lesson) << format(lesson.errors());
    m_page = lesson->pages.front();
    m_frame = frameOf(m_page.first.state.scene, requestFor(m_page));
    m_attempt.emplace(*m_page.question);
    EXPECT_EQ(check(Chosen{{1}}).said, "Not yet: nothing that Cull leaves differs.");
    const Verdict shading = check(Chosen{{5}});
    EXPECT_EQ(shading.mistake, "symptom-for-cause");
    EXPECT_EQ(shading.said, "Not yet: what Shading gets differs already.\n\nIt shows there.");
    EXPECT_EQ(check(Chosen{{2}}).mark, Mark::Right);
    EXPECT_EQ(*answerText(*m_page.question, {.frame = *m_frame}), "C: Normals");
}

// The named ones, and those that the program knows by itself.
TEST_F(AttemptTest, AWrongNumberIsAnsweredByItsMistake) {
    ask(kAngle);
    const std::pair<const char*, const char*> known[]{
        {"39.2", "l-for-r"},       {"-35.4", "sign"},          {"0.617", "radians"},
        {"0.62", "radians"},       {"70.75", "twice"},         {"17.69", "half"},
        {"353.8", "power-of-ten"}, {"0.0354", "power-of-ten"}, {"0.815", "cos-for-angle"}};
    for (const auto& [typed, id] : known) {
        const Verdict verdict = first(typed);
        EXPECT_EQ(verdict.mark, Mark::Known) << typed << ": " << verdict.said;
        EXPECT_EQ(verdict.mistake, id) << typed;
        EXPECT_FALSE(verdict.name.empty());
    }
    EXPECT_EQ(first("39.2").said, "That is another polygon's.");
    EXPECT_EQ(first("353.8").said, "The digits are right. The number is too large by a factor of 10.");
    EXPECT_EQ(first("50").said, "Not yet: too large.");
    EXPECT_EQ(first("20").said, "Not yet: too small.");
    EXPECT_EQ(first("-20").said, "Not yet: the sign is the other one, and the size differs.");
    EXPECT_EQ(first("35").mark, Mark::Again) << "right so far";
}

// Whole numbers with no tolerance: a neighbour of a mistake is not the mistake.
TEST_F(AttemptTest, AMistakeWithoutToleranceIsExact) {
    ask("question: Which row?\nanswer: floor(buffer(vertices.screen, 2, y))\n"  // 310, see lesson_data_test.cpp
        "mistake round-for-floor: 311\n  Cut off.\nmistake no-divide: 44080\n  Divide.\n");
    EXPECT_EQ(first("311").mistake, "round-for-floor");
    EXPECT_EQ(first("312").mark, Mark::NotYet);
    EXPECT_EQ(first("44080").mistake, "no-divide");
    EXPECT_EQ(first("310.0").mark, Mark::Right);
    EXPECT_EQ(first("300").mark, Mark::NotYet);
}

TEST_F(AttemptTest, PointsFallByAQuarterForEachWrongTryAndHint) {
    ask(kAngle);
    EXPECT_EQ(m_attempt->worth(), 2);
    EXPECT_EQ(m_attempt->triesLeft(), 3u);
    type("50");
    EXPECT_EQ(m_attempt->state(), Attempt::State::WrongUnknown);
    EXPECT_EQ(m_attempt->worth(), 1.5);
    EXPECT_EQ(*m_attempt->nextHint({.frame = *m_frame}), "One.");
    EXPECT_EQ(m_attempt->worth(), 1);
    type("39.2");
    EXPECT_EQ(m_attempt->state(), Attempt::State::WrongKnown);
    m_attempt->nextHint({.frame = *m_frame}).value();
    EXPECT_EQ(m_attempt->worth(), 0.5) << "never below a quarter";
    EXPECT_FALSE(m_attempt->isSettled());
    EXPECT_EQ(m_attempt->points(), 0);
    type("35.4");
    EXPECT_EQ(m_attempt->state(), Attempt::State::Right);
    EXPECT_EQ(m_attempt->points(), 0.5);
    const auto solution = m_attempt->solution({.frame = *m_frame});
    EXPECT_EQ(solution->answer, "35.3762 ± 0.06 °");
    EXPECT_EQ(solution->steps, (std::vector<std::string>{"acos(0.815)", "= 35.4"}));
    const std::vector<Try>& tries = m_attempt->progress().tries;
    ASSERT_EQ(tries.size(), 3u);
    EXPECT_EQ(tries[1], (Try{"39.2", false, "l-for-r", 1, 0}));
    // Somebody comes back to it.
    EXPECT_EQ(Attempt(*m_page.question, m_attempt->progress()).points(), 0.5);
}

TEST_F(AttemptTest, AWrongFirstAnswerToAPredictionCostsNothing) {
    std::string asked = kAngle;
    asked.replace(0, asked.find(':'), "prediction");
    ask(asked);
    EXPECT_TRUE(m_attempt->isFree());
    EXPECT_NE(type("50").said.find("A wrong prediction costs nothing."), std::string::npos);
    EXPECT_FALSE(m_attempt->isFree());
    EXPECT_EQ(m_attempt->worth(), 2) << "no points";
    EXPECT_EQ(m_attempt->triesLeft(), 3u) << "and no try";
    EXPECT_EQ(type("51").said.find("costs nothing"), std::string::npos);
    EXPECT_EQ(m_attempt->worth(), 1.5) << "the second one does";
    EXPECT_EQ(type("35.4").mark, Mark::Right);
    EXPECT_EQ(m_attempt->points(), 1.5);
    EXPECT_EQ(first("50").mark, Mark::NotYet);
    EXPECT_EQ(type("35.4").mark, Mark::Right);
    EXPECT_EQ(m_attempt->points(), 2);

    // Of two options the other one is left over.
    ask("prediction: Which?\nchoice: Kept. | if verdict(1) = kept\nchoice: Dropped. | if verdict(1) = back-facing\n");
    EXPECT_EQ(check(Chosen{{1}}).mark, Mark::NotYet);
    EXPECT_FALSE(m_attempt->isSettled());
    EXPECT_EQ(check(Chosen{{0}}).mark, Mark::Right);
    EXPECT_EQ(m_attempt->points(), 1);
}

TEST_F(AttemptTest, ThreeWrongTriesOrShowMeSettleItWithoutPoints) {
    ask(kAngle);
    for (const char* wrong : {"50", "51", "52"}) type(wrong);
    EXPECT_EQ(m_attempt->state(), Attempt::State::Shown);
    EXPECT_TRUE(m_attempt->isSettled());
    EXPECT_EQ(m_attempt->points(), 0);
    EXPECT_EQ(m_attempt->worth(), 0);
    m_attempt.emplace(*m_page.question);
    m_attempt->showMe();
    EXPECT_EQ(m_attempt->state(), Attempt::State::Shown);
    EXPECT_EQ(m_attempt->points(), 0);
}

TEST_F(AttemptTest, AValueThatWasTriedCostsNothingAgain) {
    ask(kAngle);
    type("39.2");
    for (const char* same : {"39.2", "39,2", "39.20 °", "196/5"}) {
        const Verdict verdict = type(same);
        EXPECT_EQ(verdict.mark, Mark::Again) << same;
        EXPECT_NE(verdict.said.find("You tried this answer already."), std::string::npos) << verdict.said;
        EXPECT_NE(verdict.said.find("That is another polygon's."), std::string::npos) << "what was said to it";
    }
    EXPECT_EQ(m_attempt->progress().tries.size(), 1u);
    EXPECT_EQ(m_attempt->triesLeft(), 2u);
    EXPECT_EQ(m_attempt->worth(), 1.5);
    EXPECT_EQ(m_attempt->state(), Attempt::State::WrongKnown);
    EXPECT_NE(type("39.3").mark, Mark::Again) << "another value, however near";
    EXPECT_EQ(type("35.4").mark, Mark::Right);

    ask(kOrder);
    check(Ordered{{0, 1, 2}});
    EXPECT_EQ(check(Ordered{{0, 1, 2}}).mark, Mark::Again);
    EXPECT_EQ(check(Ordered{{1, 0, 2}}).mark, Mark::Known);
    EXPECT_EQ(m_attempt->triesLeft(), 1u);
}

TEST_F(AttemptTest, AChoiceKnowsWhatWasTriedAndTheLastOptionNeedsNoTry) {
    ask("question: Which?\n"
        "choice: Kept. | if verdict(1) = kept | It is kept.\n"
        "choice cull-sign: Dropped. | if verdict(1) = back-facing | That is its front.\n"
        "choice: Both. | if verdict(1) != kept and verdict(1) != back-facing\n");
    EXPECT_EQ(m_attempt->triesLeft(), 2u);
    const Verdict verdict = check(Chosen{{1}});
    EXPECT_EQ(verdict.mark, Mark::Known);
    EXPECT_EQ(verdict.mistake, "cull-sign");
    EXPECT_EQ(verdict.said, "That is its front.");
    EXPECT_TRUE(m_attempt->isOff(1));
    EXPECT_FALSE(m_attempt->isOff(0));
    EXPECT_EQ(check(Chosen{{}}).mark, Mark::Again);
    EXPECT_EQ(check(Chosen{{0}}).said, "It is kept.");
    EXPECT_EQ(m_attempt->points(), 0.75);
    EXPECT_EQ(m_attempt->solution({.frame = *m_frame})->answer, "A: Kept.");
}

// Left and Base look away (lesson_data_test.cpp).
TEST_F(AttemptTest, SeveralSaysHowManyAreRightAndKnowsTheOpposite) {
    ask("question: Which are dropped?\n"
        "several: Left | if verdict(0) = back-facing\n"
        "several: Front | if verdict(1) = back-facing\n"
        "several hidden-for-back: Back | if verdict(3) = back-facing | It is thin.\n"
        "several: Base | if verdict(4) = back-facing\n"
        "mistake cull-sign: opposite\n  Those stay.\n");
    const Verdict back = check(Chosen{{0, 2}});
    EXPECT_EQ(back.mistake, "hidden-for-back");
    EXPECT_EQ(back.said, "1 of 2 are right. 1 is missing.\n\nIt is thin.");
    EXPECT_EQ(check(Chosen{{2, 1}}).mistake, "cull-sign");
    EXPECT_EQ(check(Chosen{{3, 0}}).mark, Mark::Right);
    EXPECT_EQ(m_attempt->progress().tries[0].given, "A, C");
    EXPECT_EQ(m_attempt->solution({.frame = *m_frame})->answer, "A: Left; D: Base");
}

TEST_F(AttemptTest, AClickIsJudgedByWhatItHitsOrHowFarItIsOff) {
    ask("question: Which?\nclick: polygon\nanswer: verdict(pick.polygon) = back-facing\n"
        "mistake hidden-for-back: pick.polygon = 3\n  It is thin.\n");
    EXPECT_EQ(check(Pick{.x = 3, .y = 4}).mark, Mark::Again) << "beside the body";
    EXPECT_EQ(check(pickOf({ThingKind::Polygon, 3})).mistake, "hidden-for-back");
    EXPECT_EQ(check(pickOf({ThingKind::Polygon, 1})).mark, Mark::NotYet);
    EXPECT_EQ(check(pickOf({ThingKind::Polygon, 4})).mark, Mark::Right);
    EXPECT_EQ(m_attempt->progress().tries.back().given, "polygon 4");
    EXPECT_EQ(m_attempt->solution({.frame = *m_frame})->answer, "polygon 0 and 4");

    ask("question: Where?\nclick: pixel\nnear: [100, 50] within 6 px\n");
    EXPECT_EQ(check(Pick{.x = 82, .y = 54}).said, "Not yet, but you are near.");  // 18.4 px off, up to 24 is near
    EXPECT_EQ(check(Pick{.x = 60, .y = 54}).said, "Not yet: it is far from here.");
    EXPECT_EQ(check(Pick{.x = 104, .y = 54}).mark, Mark::Right);  // 5.7 px off
}

TEST_F(AttemptTest, TheWayToAPlaceIsSaidOnlyAfterAHint) {
    ask("question: Where?\nclick: pixel\nnear: [100, 50] within 6 px\nhint: At the left.\n");
    ASSERT_TRUE(m_attempt->nextHint({.frame = *m_frame}));
    // 40 px to the left of it and 6 px below it; what is off by less than half of the distance needs no way.
    EXPECT_EQ(check(Pick{.x = 60, .y = 56}).said, "Not yet: it is far from here. Go right and up.");
    EXPECT_EQ(check(Pick{.x = 115, .y = 52}).said, "Not yet, but you are near. Go left.");
}

// The pyramid has n = 8.
TEST_F(AttemptTest, AHandThatStandsAtAMistakeHearsItsName) {
    ask("question: Lower n.\nuntil: buffer(specular.0, 268, 281, b) >= 175/255\nfree: material.0.n\n"
        "answer: material.0.n = 4\nmistake half: setting(material.0.n) > 4\n  Lower still.\n");
    const Verdict verdict = check(Reached{});
    EXPECT_EQ(verdict.mistake, "half");
    EXPECT_EQ(verdict.said, "Lower still.");
}

// k_s I_0 (R·V)^n = 40·0.3974^n is above 175/255 from n = 4.4 down.
TEST_F(AttemptTest, UntilIsJudgedByTheReadersFrameAndCostsNoTries) {
    ask("question: Lower n.\nuntil: buffer(specular.0, 268, 281, b) >= 175/255\nfree: material.0.n\n"
        "answer: material.0.n = 4\n");
    for (int i = 0; i < 5; ++i) EXPECT_EQ(check(Reached{}).mark, Mark::NotYet);
    EXPECT_EQ(m_attempt->worth(), 1);
    EXPECT_FALSE(m_attempt->triesLeft());
    const auto gauge = gaugeOf(std::get<UntilQuestion>(m_page.question->kind), {.frame = *m_frame});
    ASSERT_TRUE(gauge && *gauge);
    EXPECT_NEAR((*gauge)->value, 0.0249, 1e-4);
    EXPECT_NEAR((*gauge)->needed, 0.6863, 1e-4);
    EXPECT_EQ((*gauge)->said, "0.0249, needed ≥ 0.6863");
    const auto reader = pipeline::withSetting(m_page.first.state.scene, "material.0.n=4");
    m_frame = frameOf(*reader, requestFor(m_page));
    EXPECT_EQ(check(Reached{}).mark, Mark::Right);
    EXPECT_EQ(m_attempt->points(), 1);
    EXPECT_EQ(m_attempt->solution({.frame = *m_frame})->answer, "`material.0.n` = 4");
}

TEST_F(AttemptTest, WhatIsStoppedHasNotHappened) {
    ask(kAngle);
    std::stop_source source;
    source.request_stop();
    const auto verdict = m_attempt->check(Typed{"35.4"}, {.frame = *m_frame, .stop = source.get_token()});
    ASSERT_FALSE(verdict);
    EXPECT_TRUE(m_attempt->progress().tries.empty());
}

}  // namespace
}  // namespace lessons
