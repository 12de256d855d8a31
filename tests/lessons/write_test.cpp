// Questions of kind write: read, judged, and checked.
#include "lessons/lesson.h"
#include "lessons/questions/attempt.h"
#include "lessons/questions/write_run.h"
#include "pipeline/run/runner.h"
#include "tests/lessons/pyramid_scene.h"

namespace lessons {
namespace {

pipeline::Result<Lesson> lessonWith(std::string_view question) {
    return parseLesson("title: T\nlecture: L\nsummary: S\nscene: pyramid\n# One\n\nText.\n\n" + std::string(question),
                       "lesson.md",
                       [](std::string_view) -> pipeline::Result<pipeline::Scene> { return pyramidScene(); });
}
std::string refusalOf(std::string_view question) {
    const auto lesson = lessonWith(question);
    return lesson ? "" : format(lesson.errors());
}

constexpr std::string_view kCalcNormal =
    "question: Write CalcNormal.\n"
    "write: CalcNormal\n"
    "start:\n"
    "  const a = v1 - v0;\n"
    "answer:\n"
    "  const a = v1 - v0;\n"
    "  if (true) {\n"
    "    return normalize(cross(a, v2 - v0));\n"
    "  }\n"
    "mistake normal-flip:\n"
    "  It points inwards.\n"
    "trial: pyramid; object.0.rz = 30\n"
    "hint: Two edges.\n"
    "points: 2\n";

Page writePage(std::string_view question = kCalcNormal) {
    const auto lesson = lessonWith(question);
    EXPECT_TRUE(lesson) << format(lesson ? pipeline::Errors() : lesson.errors());
    return lesson ? lesson->pages.front() : Page();
}
const WriteQuestion& writeOf(const Page& page) { return std::get<WriteQuestion>(page.question->kind); }

TEST(WriteQuestions, AreReadWithTheirLinesAsTheyAreIndented) {
    const Page page = writePage();
    const WriteQuestion& write = writeOf(page);
    EXPECT_EQ(kindName(*page.question), "write");
    EXPECT_EQ(write.start, "function CalcNormal(v0, v1, v2) {\n  const a = v1 - v0;\n}");
    EXPECT_EQ(
        write.answer,
        "function CalcNormal(v0, v1, v2) {\n  const a = v1 - v0;\n  if (true) {\n    return normalize(cross(a, v2 "
        "- v0));\n  }\n}");
    EXPECT_EQ(write.lines, 6U);  // four lines and two more
    ASSERT_EQ(write.trials.size(), 1U);
    EXPECT_EQ(write.trials[0].scene.objects[0].transform.rotation.z, 30);
}

TEST(WriteQuestions, SayWhatIsWrongWithThem) {
    EXPECT_NE(refusalOf("question: Q\nwrite: CalcNormals\nanswer:\n  return 1;\n").find("CalcNormal"),
              std::string::npos);
    EXPECT_NE(refusalOf("question: Q\nwrite: lambert\n").find("no lines of \"answer\""), std::string::npos);
    EXPECT_NE(refusalOf("question: Q\nwrite: lambert\nanswer:\n  return 1;\nmistake no-maxx:\n  No.\n").find("no-max"),
              std::string::npos);
    EXPECT_NE(refusalOf("question: Q\nanswer: 1\nstart:\n  return 1;\n").find("kind number"), std::string::npos);
    // Only lines of a function go on below their key.
    EXPECT_NE(refusalOf("question: Q\nanswer: 1\n  + 1\n").find("lesson.md:11:3"), std::string::npos);
}

pipeline::OwnVerdict verdictOf(std::size_t wrong, std::vector<const pipeline::OwnMistake*> names) {
    return {5, wrong, wrong ? std::optional<std::size_t>(0) : std::nullopt, std::move(names)};
}

TEST(WriteQuestions, AreJudgedByTheirResults) {
    const Page page = writePage();
    const WriteQuestion& write = writeOf(page);
    const pipeline::FramePtr frame =
        runFrame(std::make_shared<const pipeline::Scene>(page.first.state.scene), requestFor(page), nullptr);
    const Context context{.frame = *frame};
    const auto verdict = [&](const std::string& trial, const pipeline::OwnVerdict& of) {
        return judge(*page.question, Written{"text", trial, of}, context).value();
    };
    EXPECT_EQ(verdict("", verdictOf(0, {})).mark, Mark::Right);
    const auto* const flip = &write.contract.mistakes[0];
    const Verdict known = verdict("", verdictOf(5, {flip}));
    EXPECT_EQ(known.mark, Mark::Known);
    EXPECT_EQ(known.mistake, "normal-flip");
    EXPECT_EQ(known.name, "cross product in the wrong order");
    EXPECT_EQ(known.said, "5 of 5 results differ.\n\nIt points inwards.");
    const Verdict two = verdict("a trial", verdictOf(2, {flip, &write.contract.mistakes[1]}));
    EXPECT_EQ(two.mark, Mark::NotYet);
    EXPECT_TRUE(two.said.starts_with("Right on this page, but not in a trial: 2 of 5 results differ."));
    EXPECT_NE(two.said.find("not normalised to length 1"), std::string::npos);
    EXPECT_EQ(judge(*page.question, Written{"text", "", {}}, context)->mark, Mark::Again);

    // Running is trying: it costs nothing, and the last text is kept.
    Attempt attempt(*page.question);
    for (const std::string text : {"one", "two", "two"})
        ASSERT_TRUE(attempt.check(Written{text, "", verdictOf(5, {flip})}, context));
    EXPECT_EQ(attempt.worth(), 2);
    EXPECT_FALSE(attempt.triesLeft());
    ASSERT_EQ(attempt.progress().tries.size(), 3U);
    EXPECT_EQ(attempt.progress().tries[1].given, "");
    EXPECT_EQ(attempt.progress().tries[2].given, "two");
    ASSERT_TRUE(attempt.nextHint(context));
    EXPECT_EQ(attempt.worth(), 1.5);
    ASSERT_TRUE(attempt.check(Written{"three", "", verdictOf(0, {})}, context));
    EXPECT_EQ(attempt.points(), 1.5);
}

// Stands for lines: the answer gives the right results, any other text those of a formula.
LinesRunner running(const WriteQuestion& write, pipeline::OwnFormula otherwise) {
    return
        [&write, otherwise](const pipeline::OwnContract& contract, const std::string& text,
                            const std::vector<pipeline::OwnElement>& calls) -> pipeline::Result<pipeline::OwnResults> {
            pipeline::OwnResults results;
            for (const pipeline::OwnElement& call : calls)
                results.push_back(valueOf(contract, text == write.answer ? contract.right : otherwise, call.in));
            return results;
        };
}

TEST(WriteQuestions, AreCheckedInTheirScenes) {
    const Page page = writePage();
    const WriteQuestion& write = writeOf(page);
    const pipeline::Scene& scene = page.first.state.scene;
    const auto found = [&](const Question& question, const WriteQuestion& of, pipeline::OwnFormula otherwise) {
        return format(writeErrorsOf(question, of, scene, running(of, otherwise)));
    };
    EXPECT_EQ(found(*page.question, write, write.contract.mistakes[0].formula), "");
    EXPECT_NE(found(*page.question, write, write.contract.right).find("the start is right already"), std::string::npos);
    WriteQuestion other = write;
    other.answer = "another text";
    EXPECT_NE(format(writeErrorsOf(*page.question, write, scene, running(other, write.contract.mistakes[0].formula)))
                  .find("the answer is wrong in 5 of 5 calls on this page"),
              std::string::npos);
    Question told = *page.question;
    told.hints[0].pieces[0] = "Close it: }, after return normalize(cross(a, v2 - v0));";
    EXPECT_NE(found(told, write, write.contract.mistakes[0].formula).find("a hint has the last line"),
              std::string::npos);
    // Flat shading interpolates no normal.
    const Page never = writePage("question: Q\nwrite: normalAt\nanswer:\n  return N0;\n");
    EXPECT_NE(found(*never.question, writeOf(never), nullptr).find("normalAt is never called on this page"),
              std::string::npos);
}

}  // namespace
}  // namespace lessons
