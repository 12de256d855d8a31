#include "lessons/lesson.h"
#include "tests/lessons/pyramid_scene.h"

namespace lessons {
namespace {

pipeline::Result<pipeline::Scene> sceneNamed(std::string_view name) {
    if (name == "pyramid") return pyramidScene();
    return pipeline::Error{{}, "no scene \"" + std::string(name) + "\"", {}};
}

// A header of four lines, so that `page` begins in line 5.
std::string withHeader(std::string_view page) {
    return "title: T\nlecture: L\nsummary: S\nscene: pyramid\n" + std::string(page);
}

std::string errorsOf(std::string_view text) {
    const auto lesson = parseLesson(text, "lesson.md", sceneNamed);
    return lesson ? "" : format(lesson.errors());
}

TEST(LessonReader, GivesNamesToExpressions) {
    const auto lesson = parseLesson(withHeader("let: n = setting(material.0.n)\n"
                                               "# One\n"
                                               "let: twice = 2 * n\n"
                                               "\n"
                                               "Twice is {twice}.\n"
                                               "\n"
                                               "question: Three times?\n"
                                               "answer: twice + n\n"
                                               "right: Yes, {answer}.\n"
                                               "# Two\n"
                                               "let: twice = 3\n"
                                               "It is {twice}, and n {n}.\n"),
                                    "lesson.md", sceneNamed);
    ASSERT_TRUE(lesson) << format(lesson.errors());
    const auto said = [&](const Page& page, const Prose& prose) {
        return filled(prose, *frameOf(page.first.state.scene, requestFor(page))).value();
    };
    const Page &one = lesson->pages[0], &two = lesson->pages[1];
    EXPECT_EQ(said(one, one.first.text), "Twice is 16.");  // the lecture's n is 8
    EXPECT_EQ(said(one, one.question->right), "Yes, 24.");
    EXPECT_EQ(said(two, two.first.text), "It is 3, and n 8.");
    EXPECT_EQ(errorsOf(withHeader("# One\nlet: half\n\nText.\n")),
              "lesson.md:6:6: found \"half\", expected NAME = EXPRESSION\n");
    EXPECT_EQ(errorsOf(withHeader("# One\nlet: depth = 1\n\nText.\n")),
              "lesson.md:6:6: found the name \"depth\": A buffer has this name.\n");
    EXPECT_EQ(errorsOf(withHeader("# One\nlet: a = 1\nlet: a = 2\n\nText.\n")),
              "lesson.md:7:6: found the name \"a\" a second time, expected another name\n");
    // The answer's name is for what is said after it: the question gives nothing away.
    EXPECT_NE(errorsOf(withHeader("# One\nText.\n\nquestion: Is it {answer}?\nanswer: 1\n")), "");
}

// Depths have a range of their own, as n_dot_l has another; bytes that are colours have none.
TEST(LessonReader, ARangeIsForTheViewsOfOneQuantity) {
    const auto rangesOf = [](std::string_view keys) {
        std::vector<double> ends;  // the last one of each view; NaN where it has none
        const auto lesson =
            parseLesson(withHeader("# One\n" + std::string(keys) + "\nText.\n"), "lesson.md", sceneNamed);
        EXPECT_TRUE(lesson) << format(lesson.errors());
        if (lesson)
            for (const BufferShown& view : lesson->pages[0].first.state.window.views)
                ends.push_back(view.range ? (*view.range)[1] : -1);
        return ends;
    };
    EXPECT_EQ(rangesOf("buffers: color, z_view, n_dot_l.0\nrange: 600, 900\n"), (std::vector<double>{-1, 900, -1}));
    EXPECT_EQ(rangesOf("buffers: n_dot_l.0, r_dot_v.0\nrange: 0, 1\n"), (std::vector<double>{1, 1}));
    EXPECT_EQ(rangesOf("buffers: color, z_view\nrange: 0, 200; 600, 900\n"), (std::vector<double>{200, 900}));
}

TEST(LessonReader, ReadsHeaderPagesAndQuestions) {
    const auto lesson = parseLesson(withHeader("set: material.0.n = 6\n"
                                               "\n"
                                               "# One\n"
                                               "stage: z-buffer\n"
                                               "buffers: depth, n_dot_l.0\n"
                                               "pixel: 268, 281\n"
                                               "channel: g\n"
                                               "set: cull = none\n"
                                               "\n"
                                               "First line,\n"
                                               "note: second line.\n"
                                               "```\n"
                                               "# no heading\n"
                                               "```\n"
                                               "\n"
                                               "question: How\n"
                                               "many?\n"
                                               "answer: setting(material.0.n) / 2\n"
                                               "tolerance: 0.5\n"
                                               "hint: Half.\n"
                                               "# Two\n"
                                               "Text.\n"),
                                    "lesson.md", sceneNamed);
    ASSERT_TRUE(lesson) << format(lesson.errors());
    EXPECT_EQ(lesson->title, "T");
    EXPECT_EQ(lesson->lecture, "L");
    EXPECT_EQ(lesson->summary, "S");
    ASSERT_EQ(lesson->pages.size(), 2u);

    const Page& one = lesson->pages[0];
    EXPECT_EQ(one.heading, "One");
    EXPECT_EQ(one.where.line, 7);
    EXPECT_EQ(one.first.state.window.stage, pipeline::StageId::ZBuffer);
    ASSERT_EQ(shownBuffers(one.first.state).size(), 2u);
    EXPECT_EQ(shownBuffers(one.first.state)[1].text(), "n_dot_l.0");
    EXPECT_EQ(pickedPixel(one.first.state), glm::ivec2(268, 281));
    EXPECT_EQ(one.first.state.window.channel, 1);
    EXPECT_EQ(one.first.state.scene.settings.cull, pipeline::CullMode::None);
    EXPECT_EQ(one.first.state.scene.objects[0].material.exponent, 6);
    EXPECT_EQ(withGaps(one.first.text), "First line,\nnote: second line.\n```\n# no heading\n```");
    ASSERT_TRUE(one.question);
    EXPECT_EQ(withGaps(one.question->text), "How\nmany?");
    const auto& number = std::get<NumberQuestion>(one.question->kind);
    EXPECT_EQ(number.tolerance, 0.5);
    const auto answer = evaluate(number.answer, {.frame = *frameOf(one.first.state.scene, requestFor(one))});
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->numbers[0], 3);

    // A page inherits from the header alone.
    const Page& two = lesson->pages[1];
    EXPECT_EQ(two.first.state.scene.settings.cull, pipeline::CullMode::Back);
    EXPECT_EQ(two.first.state.scene.objects[0].material.exponent, 6);
    EXPECT_EQ(two.first.state.window.stage, pipeline::StageId::Shading);
    EXPECT_EQ(shownBuffers(two.first.state), std::vector<pipeline::BufferName>{{pipeline::BufferId::Color}});
    EXPECT_FALSE(pickedPixel(two.first.state));
    EXPECT_FALSE(two.question);
}

TEST(LessonReader, WindowsLineEndsMakeNoDifference) {
    EXPECT_EQ(
        errorsOf("title: T\r\nlecture: L\r\nsummary: S\r\nscene: pyramid\r\n# One\r\nstage: cull\r\n\r\nText.\r\n"),
        "");
}

TEST(LessonReader, PagesOfOneSceneShareItsMeshes) {
    const auto lesson = parseLesson(withHeader("# One\nText.\n# Two\nText.\n"), "lesson.md", sceneNamed);
    ASSERT_TRUE(lesson);
    EXPECT_EQ(lesson->pages[0].first.state.scene, lesson->pages[1].first.state.scene);  // meshes compare by address
}

struct Wrong {
    const char* page;
    const char* errors;
};

TEST(LessonReader, UnknownNamesAreAnsweredWithLineAndNearest) {
    const Wrong cases[]{
        {"# One\nstaeg: cull\n\nText.\n", "lesson.md:6:1: no key \"staeg\"; the nearest is \"stage\"\n"},
        {"# One\nstage: culling\n\nText.\n", "lesson.md:6:8: no stage \"culling\"; the nearest is \"cull\"\n"},
        {"# One\nbuffers: color, dept\n\nText.\n", "lesson.md:6:17: no buffer \"dept\"; the nearest is \"depth\"\n"},
        {"# One\nbuffers: n_dot_l.1\n\nText.\n",
         "lesson.md:6:10: no buffer \"n_dot_l.1\", expected a light that the scene has\n"},
        {"# One\nchannel: c\n\nText.\n", "lesson.md:6:10: found \"c\", expected r, g or b\n"},
        {"# One\nset: material.0.m = 4\n\nText.\n",
         "lesson.md:6:6: no setting \"material.0.m\"; the nearest is \"material.0.n\"\n"},
        {"# One\nscene: piramid\n\nText.\n", "lesson.md:6:8: no scene \"piramid\"\n"},
        {"# One\n\n{why(zbuffer)}\n", "lesson.md:7:6: no stage \"zbuffer\"; the nearest is \"z-buffer\"\n"},
        {"# One\nText.\nquestion: Q?\nanswer: pixel(0, 0).poligon\n",
         "lesson.md:8:21: pixel has no \"poligon\"; the nearest is \"polygon\"\n"},
        {"# One\nText.\nquestion: Q?\nanswer: 1\nhnt: x\n", "lesson.md:9:1: no key \"hnt\"; the nearest is \"hint\"\n"},
    };
    for (const Wrong& wrong : cases) EXPECT_EQ(errorsOf(withHeader(wrong.page)), wrong.errors) << wrong.page;
}

TEST(LessonReader, WhatIsMissingOrOutOfRangeIsAnError) {
    const Wrong cases[]{
        {"", "lesson.md:4: the file has no page, expected a line \"# HEADING\"\n"},
        {"# One\n", "lesson.md:5:1: this page has no text, expected Markdown below its keys\n"},
        {"# One\npixel: 640, 0\n\nText.\n",
         "lesson.md:6:8: found the pixel \"640, 0\", expected \"x, y\", x from 0 to 639, y from 0 to 479\n"},
        {"# One\npixel: 1\n\nText.\n",
         "lesson.md:6:8: found the pixel \"1\", expected \"x, y\", x from 0 to 639, y from 0 to 479\n"},
        {"# One\nstage:\n\nText.\n", "lesson.md:6:7: found nothing, expected what \"stage\" is\n"},
        {"# One\nstage: cull\nstage: cull\n\nText.\n",
         "lesson.md:7:1: found \"stage\" a second time, expected it once\n"},
        {"# One\nText.\nquestion: Q?\n",
         "lesson.md:7:1: no \"answer\" here, expected both a question and its answer\n"},
        {"# One\nText.\nanswer: 1\n", "lesson.md:7:1: no \"question\" here, expected both a question and its answer\n"},
        {"# One\nText.\nquestion: Q?\nanswer: 1\ntolerance: -1\n",
         "lesson.md:9:12: found \"-1\", expected a number from 0 on\n"},
        {"stray\n# One\nText.\n", "lesson.md:5:1: found \"stray\", expected \"key: value\" or \"# HEADING\"\n"},
    };
    for (const Wrong& wrong : cases) EXPECT_EQ(errorsOf(withHeader(wrong.page)), wrong.errors) << wrong.page;

    EXPECT_EQ(errorsOf("# One\nText.\n"),
              "lesson.md:1:1: no title in the header, expected \"title: …\"\n"
              "lesson.md:1:1: no lecture in the header, expected \"lecture: …\"\n"
              "lesson.md:1:1: no summary in the header, expected \"summary: …\"\n"
              "lesson.md:1:1: no scene for this page, expected \"scene: …\" in the header\n");
    EXPECT_NE(errorsOf(""), "");
}

TEST(LessonReader, AWrongSettingOfTheHeaderIsReportedOnce) {
    EXPECT_EQ(errorsOf(withHeader("set: shading = flt\n# One\nText.\n# Two\nText.\n")).find("lesson.md:5:6: "), 0u);
    EXPECT_EQ(errorsOf(withHeader("set: shading = flt\n# One\nText.\n# Two\nText.\n")).find("lesson.md", 1),
              std::string::npos);
}

TEST(LessonReader, ReportsTwentyErrorsAtMost) {
    std::string page = "# One\n\n";
    for (int i = 0; i < 30; ++i) page += "{nothing()}\n";
    const auto lesson = parseLesson(withHeader(page), "lesson.md", sceneNamed);
    ASSERT_FALSE(lesson);
    EXPECT_EQ(lesson.errors().size(), pipeline::kMaxErrors);
}

TEST(LessonReader, AFolderWithoutALessonIsAnError) { EXPECT_FALSE(readLesson("no such folder")); }

}  // namespace
}  // namespace lessons
