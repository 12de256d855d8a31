// Runs every lesson that comes with the program: whatever a page shows, says and asks has to hold.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "lessons/check.h"
#include "lessons/library.h"
#include "lessons/questions/judge.h"
#include "pipeline/illumination/illumination.h"
#include "tests/lessons/pyramid_scene.h"

namespace lessons {
namespace {

std::string textOf(const pipeline::Result<std::string>& text) { return text ? *text : format(text.errors()); }

TEST(Lessons, CanAllBeRead) {
    const Library library = allLessons();
    EXPECT_EQ(format(library.errors), "");
    EXPECT_FALSE(library.lessons.empty());
}

// A page asks soon; the very first one within 60 words, beside the picture that it is about.
TEST(Lessons, AnOutlineHasWhatTheWholeLessonHasButItsPages) {
    const Library outlines = allOutlines(), whole = allLessons();
    EXPECT_TRUE(outlines.errors.empty());
    ASSERT_EQ(outlines.lessons.size(), whole.lessons.size());
    for (std::size_t i = 0; i < whole.lessons.size(); ++i) {
        const Lesson &outline = outlines.lessons[i], &lesson = whole.lessons[i];
        EXPECT_EQ(outline.name, lesson.name);
        EXPECT_EQ(outline.folder, lesson.folder);
        EXPECT_EQ(outline.title + outline.lecture + outline.summary + outline.next,
                  lesson.title + lesson.lecture + lesson.summary + lesson.next);
        EXPECT_EQ(outline.minutes, lesson.minutes);
        EXPECT_EQ(outline.returns.size(), lesson.returns.size());
        std::vector<std::string> headings, own;
        for (const Page& page : outline.pages) headings.push_back(page.heading);
        for (const Page& page : lesson.pages)
            if (!page.from) own.push_back(page.heading);
        EXPECT_EQ(headings, own) << lesson.name;
    }
}

TEST(Lessons, EveryPageAsksWithinAHundredWords) {
    const auto wordsIn = [](const Prose& prose) {
        std::istringstream words(withGaps(prose));
        return std::distance(std::istream_iterator<std::string>(words), {});
    };
    for (const Lesson& lesson : allLessons().lessons)
        for (const Page& page : lesson.pages)
            EXPECT_LE(wordsIn(page.first.text), 100) << lesson.name << ", " << page.heading;
    const Lesson pyramid = *findLesson("pyramid");
    const Half& first = pyramid.pages[0].first;
    EXPECT_LE(wordsIn(first.text), 60);
    ASSERT_TRUE(first.state.window.place);
    EXPECT_EQ(*first.state.window.place, pipeline::Place{pipeline::StageId::Shading}) << "all is drawn";
}

TEST(Lessons, EveryPageIsTrue) {
    for (const Lesson& lesson : allLessons().lessons)
        for (const Page& page : lesson.pages) {
            SCOPED_TRACE(lesson.name + ", " + page.heading);
            EXPECT_EQ(format(pipeline::checkScene(page.first.state.scene)), "");
            pipeline::FrameRequest request = requestFor(page);
            request.wanted.set(index(pipeline::BufferId::PolygonId));
            const pipeline::FramePtr frame = frameOf(page.first.state.scene, request);
            ASSERT_TRUE(frame);
            for (const pipeline::BufferName& buffer : shownBuffers(page.first.state))
                if (!pipeline::isDerived(buffer.id)) {
                    EXPECT_TRUE(frame->buffer(buffer)) << buffer.text() << ": " << frame->whyAbsent(buffer);
                }
            if (const auto pixel = pickedPixel(page.first.state)) {
                const auto polygons = frame->buffer({pipeline::BufferId::PolygonId});
                ASSERT_TRUE(polygons);
                EXPECT_GE(polygons->value(std::size_t(pixel->x), std::size_t(pixel->y)), 0) << "nothing is drawn there";
            }
            const auto text = filled(page.first.text, *frame);
            EXPECT_TRUE(text) << textOf(text);
            if (!page.question) continue;

            const Pick first{.x = 0, .y = 0, .polygon = 0, .vertex = 0, .object = 0, .light = 0};
            const Context context{.frame = *frame, .pick = &first};
            for (const Prose* prose : textsOf(*page.question)) {
                const auto filledIn = filled(*prose, context);
                EXPECT_TRUE(filledIn) << textOf(filledIn);
            }
            for (const Expression* expression : expressionsOf(*page.question)) {
                const auto value = evaluate(*expression, context);
                EXPECT_TRUE(value) << expression->text << ": " << format(value ? pipeline::Errors() : value.errors());
            }
            const auto* number = std::get_if<NumberQuestion>(&page.question->kind);
            if (!number) continue;
            const double answer = evaluate(number->answer, context)->numbers[0];
            if (answer != std::trunc(answer)) {
                EXPECT_GT(number->tolerance, 0) << "nobody types all digits of " << answer;
            }
            const auto markOf = [&](double typed) {
                const auto verdict = judge(*page.question, Typed{std::to_string(typed)}, context);
                return verdict ? verdict->mark : Mark::Again;
            };
            if (answer == std::trunc(answer) || number->tolerance > 1e-6) {
                EXPECT_EQ(markOf(answer), Mark::Right);
            }
            EXPECT_NE(markOf(answer + 2 * toleranceOf(*number, answer) + 1), Mark::Right);
        }
}

// A picture's colours go from the least to the greatest value: a term that adds less than a step of the frame buffer
// anywhere must not look like a highlight.
TEST(Lessons, NoPageShowsADifferenceThatNobodySees) {
    for (const Lesson& lesson : allLessons().lessons)
        for (const Page& page : lesson.pages) {
            SCOPED_TRACE(lesson.name + ", " + page.heading);
            const pipeline::FramePtr frame = frameOf(page.first.state.scene, requestFor(page));
            ASSERT_TRUE(frame);
            const double step = pipeline::maximumIntensity(page.first.state.scene) / 255;
            for (const pipeline::BufferName& name : shownBuffers(page.first.state)) {
                const auto buffer = frame->buffer(name);
                if (buffer->info->unit != "intensity") continue;
                const pipeline::BufferStatistics found = pipeline::statistics(*buffer);
                EXPECT_GT(found.max - found.min, step) << name.text();
            }
        }
}

TEST(Lessons, AnUnknownLessonIsAnsweredWithTheNearest) {
    EXPECT_TRUE(findLesson("pyramid"));
    const auto unknown = findLesson("piramid");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(format(unknown.errors()), "no lesson \"piramid\"; the nearest is \"pyramid\"\n");
}

class PyramidLesson : public testing::Test {
protected:
    void SetUp() override {
        const auto lesson = findLesson("pyramid");
        ASSERT_TRUE(lesson) << format(lesson.errors());
        m_lesson = *lesson;
    }
    double answer(std::size_t page) const {
        const Page& asked = m_lesson.pages[page];
        const auto frame = frameOf(asked.first.state.scene, requestFor(asked));
        const auto answer = evaluate(std::get<NumberQuestion>(asked.question->kind).answer, {.frame = *frame});
        return answer ? answer->numbers[0] : NAN;
    }
    std::vector<std::size_t> holding(std::size_t page) const {
        const Page& asked = m_lesson.pages[page];
        const auto frame = frameOf(asked.first.state.scene, requestFor(asked));
        return holdingOptions(optionsOf(*asked.question), {.frame = *frame}).value();
    }
    // Both halves.
    std::string text(std::size_t number) const {
        const Page& page = m_lesson.pages[number];
        return textOf(filled(page.first.text, *frameOf(page.first.state.scene, requestFor(page)))) +
               textOf(filled(page.then->text, *frameOf(page.then->state.scene, requestForThen(page))));
    }
    Lesson m_lesson;
};

// Worked out from the lecture's two files with the lecture's formulas, not with this program:
//   page 1   the apex moves one vertex and turns the four polygons that name it: C
//   page 2   z_v of vertex 2 is 1000 − 470·sin60·cos45 − 150·sin60·sin45 = 620.329,
//            y_v = −470·cos60·cos45 − 150·cos60·sin45 = −219.203; 240 + 200·219.203/620.329 = 310.673
//   page 3   Left and Base turn clockwise in the picture
//   page 4   (0, 150, 0) × (−135, 75, 150) = (22500, 0, 20250); 20250/30270.65 = 0.66896
//   page 5   at pixel 250, 270 Front is nearer than Left
//   page 6   N·L = (22500 + 20250)/(30270.65·√3) = 0.81537, the angle 35.376°
//   page 7   acos(0.3974) = 66.6°
//   page 8   N·L = (0, 40500, 20250)·(1, 1, 1)/(45280.4·√3) = 0.77460, 255·(0.2·50 + 100·0.2·0.7746 + 0.025)/175 = 37.18
//   page 9   asks for lines, which tests/web/write.mjs runs
TEST_F(PyramidLesson, AnswersAreThoseOfTheLecture) {
    ASSERT_EQ(m_lesson.pages.size(), 9u);
    EXPECT_EQ(holding(0), std::vector<std::size_t>{2});
    EXPECT_EQ(answer(1), 310);
    EXPECT_EQ(holding(2), (std::vector<std::size_t>{0, 4}));
    EXPECT_NEAR(answer(3), 0.66896, 1e-5);
    EXPECT_EQ(holding(4), std::vector<std::size_t>{0});
    EXPECT_EQ(answer(7), 37);
}

struct Said {
    std::size_t page;
    const char* words;
};

// The same, for what the pages say.
TEST_F(PyramidLesson, NumbersInTheTextAreThoseOfTheLecture) {
    const Said said[]{
        {1, "(335, 75, 150)"},
        {1, "= \u2212183.848"},  // (75 − 335)·sin 45
        {1, "= \u221215.053"},   // −(335 + 75)·cos 60·cos 45 + 150·sin 60
        {1, "= 673.927"},        // 1000 − (335 + 75)·sin 60·cos 45 − 150·cos 60
        {1, "= 265.440"},
        {1, "= 244.467"},
        // Shoelace formula on screen corners rounded to 1/256; without rounding Base has −1991.6.
        {2, "*Left* \u2212696.9, *Base* \u22121\u202f991.5: back-facing"},
        {2, "*Front* 895.3, *Right* 1\u202f756.7, *Back* 36.4: kept"},
        {3, "product is (0, 40\u202f500, 20\u202f250)"},
        {3, "= (0, 0.894, 0.447)"},
        {3, "is (0.743, 0, 0.669)"},
        {4, "shows polygon 1 at z_v = 671.93"},
        {5, ": (0.577, 0.577, 0.577)"},
        {5, "is 0.8154 on *Front* and 0.7746 on *Right*"},
        {5, "73.38 against 69.71"},      // 0.9·100·N·L
        {5, "at 92.5° from"},            // acos((−22500 + 20250)/(30270.65·√3)) = acos(−0.0429)
        {6, "= (0.386, 0.678, 0.626)"},  // from the mean of the vertices
        {6, "0.3974"},
        {6, "= 0.025."},  // 40·0.3974^8
        {6, "45.000 + 69.714 + 0.025 = 114.739"},
        {7, "0.9·50 + 100·(0.9 + 0.4) = 175"},
        {7, "is 0.7746"},
        {7, "pixel is (37, 93, 167)"},  // of 0.5 and 0.9: 255·63.755/175 = 92.9, 255·114.739/175 = 167.2
    };
    for (const Said& s : said)
        EXPECT_NE(text(s.page).find(s.words), std::string::npos) << s.words << " is not in\n" << text(s.page);
}

// What the first page shows as lines of the two files does stand there, in this order.
TEST_F(PyramidLesson, QuotedLinesStandInTheFiles) {
    const auto contents = [](const std::filesystem::path& file) {
        std::ifstream stream(file);
        std::ostringstream text;
        text << stream.rdbuf();
        return text.str();
    };
    const std::filesystem::path scene = pipeline::builtInScenes().front().file;
    const std::string files = contents(scene) + contents(scene.parent_path() / "pyramid.des");
    int quotes = 0;
    std::size_t at = 0;
    const Half& half = m_lesson.pages[0].first;
    for (const HeldFile& file : filesOf(half.held, half.state.scene))
        for (const pipeline::LectureLine& line : file.lines) {
            at = files.find(line.text, at);
            ASSERT_NE(at, std::string::npos) << line.text;
            ++quotes;
        }
    EXPECT_EQ(quotes, 9 + 14);
}

class EachLesson : public testing::TestWithParam<std::string> {};

TEST_P(EachLesson, IsRightByItsOwnCheck) {
    const auto lesson = findLesson(GetParam());
    ASSERT_TRUE(lesson) << format(lesson.errors());
    EXPECT_EQ(format(checkLesson(*lesson)), "");
}

INSTANTIATE_TEST_SUITE_P(Lessons, EachLesson, testing::ValuesIn(lessonNames()), [](const auto& name) {
    std::string words = name.param;
    std::ranges::replace(words, '-', '_');
    return words;
});

TEST(Lessons, NameNotionsOfTheLectures) {
    std::ifstream stream(pipeline::resourceFolder() / "manual" / "lectures.md");
    std::ostringstream lectures;
    lectures << stream.rdbuf();
    ASSERT_FALSE(lectures.str().empty());
    for (const Lesson& lesson : allLessons().lessons)
        for (const std::string& notion : lesson.notions)
            EXPECT_NE(lectures.str().find("| " + notion), std::string::npos) << lesson.name << ": " << notion;
}

}  // namespace
}  // namespace lessons
