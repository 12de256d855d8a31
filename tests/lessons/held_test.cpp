// The keys that let a hand move something: how they are read, what a page may not do with them.
#include <set>

#include "lessons/check.h"
#include "lessons/held_figure.h"
#include "lessons/lesson.h"
#include "lessons/library.h"
#include "tests/lessons/pyramid_scene.h"

namespace lessons {
namespace {

// A header of five lines; the heading is line 6, so `keys` begin in line 7.
pipeline::Result<Lesson> read(const std::string& keys, const std::string& rest = "\nText.\n") {
    return parseLesson("title: T\nlecture: L\nsummary: S\ncan: do it\nscene: pyramid\n# One\n" + keys + rest,
                       "lesson.md",
                       [](std::string_view) -> pipeline::Result<pipeline::Scene> { return pyramidScene(); });
}
Held heldOf(const std::string& keys) {
    const auto lesson = read(keys);
    EXPECT_TRUE(lesson) << format(lesson.errors());
    return lesson ? lesson->pages[0].first.held : Held{};
}
std::string errorsOfKeys(const std::string& keys) {
    const auto lesson = read(keys);
    return lesson ? "" : format(lesson.errors());
}
const std::string kQuestion = "\nText.\nquestion: Row?\nanswer: 310\nhint: Look.\nworks: So it is.\n";

TEST(Held, ReadsWhatCanBeHeld) {
    const Held held = heldOf(
        "hold: light.0 around 0, 0, 75 | Lamp\nhold: object.0.rz on 200, 0, 0 | Pyramid\n"
        "hold: material.0.n from 1 to 512 | Exponent | n\n");
    ASSERT_EQ(held.holds.size(), 3u);
    EXPECT_EQ(held.holds[0].kind, pipeline::Hold::Kind::LampAtInfinity);
    EXPECT_EQ(held.holds[0].keys, (std::vector<std::string>{"light.0.x", "light.0.y", "light.0.z"}));
    EXPECT_EQ(held.holds[0].point, pipeline::Vec3d(0, 0, 75));
    EXPECT_EQ(held.holds[1].kind, pipeline::Hold::Kind::Turn);
    EXPECT_EQ(held.holds[1].axis, pipeline::Vec3d(0, 0, 1));
    EXPECT_EQ(held.holds[2].symbol, "n");
    EXPECT_EQ(held.holds[2].high, 512);
    EXPECT_EQ(heldOf("hold: camera | Eye\n").holds[0].keys, (std::vector<std::string>{"camera.theta", "camera.phi"}));
    // Along the viewing axis of lecture 1's camera, θ = 45°, φ = 60°: (−0.6124, −0.6124, −0.5).
    const pipeline::Vec3d axis = heldOf("hold: object.0 along view from -50 to 50 | Pyramid\n").holds[0].axis;
    EXPECT_NEAR(axis.x, -0.6124, 1e-4);
    EXPECT_NEAR(axis.z, -0.5, 1e-4);
}

// The pyramid's box is 150 wide around (75, 75, 75): 1.3 times its half is 97.5.
TEST(Held, ReadsAVertexAndASpot) {
    const Held held =
        heldOf("hold: vertex.0.4 in z over | Apex\nhold: pixel along row 240 | Spot\nfile: pyramid.des\n");
    ASSERT_EQ(held.holds.size(), 1u);
    EXPECT_EQ(held.holds[0].keys, (std::vector<std::string>{"vertex.0.4.x", "vertex.0.4.y", "vertex.0.4.z"}));
    EXPECT_EQ(held.holds[0].axis, pipeline::Vec3d(0, 0, 1));
    EXPECT_EQ(held.holds[0].high, 97.5);
    EXPECT_TRUE(held.holds[0].turnsOver);
    ASSERT_TRUE(held.spot);
    EXPECT_EQ(held.spot->row, 240);
    EXPECT_FALSE(heldOf("hold: vertex.0.4 | Apex\n").holds[0].turnsOver);
    for (const char* wrong : {"hold: vertex.0.5 | V\n", "hold: vertex.0.4 in w | V\n", "hold: vertex.0.4 often | V\n",
                              "hold: pixel along row 480 | Spot\n", "hold: pixel along row 1.5 | Spot\n",
                              "hold: material.0.n at rim from 1 to 9 | Rim of no ball\n", "file: pyramid.des\n"})
        EXPECT_NE(errorsOfKeys(wrong), "") << wrong;
}

TEST(Held, APlayHasItsConditionAndItsFindingBelowIt) {
    const Held held =
        heldOf("hold: camera | Eye\nplay: Go up.\n  until: setting(camera.phi) < 5\n  done: It is flat from here.\n");
    ASSERT_TRUE(held.play);
    EXPECT_EQ(held.play->text, "Go up.");
    EXPECT_EQ(held.play->until.text, "setting(camera.phi) < 5");
    EXPECT_EQ(held.play->done, "It is flat from here.");
    EXPECT_NE(errorsOfKeys("hold: camera | Eye\nplay: Go up.\n").find("lesson.md:8:1: this play has no end"),
              std::string::npos);
    EXPECT_NE(errorsOfKeys("hold: camera | Eye\nplay: Go up.\n  until: 5\n  done: Up.\n").find("expected a condition"),
              std::string::npos);
}

TEST(Held, SaysWhatIsNoHold) {
    for (const char* wrong :
         {"light.0 | Lamp", "light.0 around 0, 0 | Lamp", "light.0 on ground | Lamp", "light.1 around 0, 0, 0 | Lamp",
          "object.3 along x from 0 to 1 | Box", "object.0 along w from 0 to 1 | Box", "object.0.rq on 0, 0, 0 | Box",
          "shading from 0 to 1 | Shading", "material.0.n from 5 to 2 | n", "material.0.n from -5 to 2 | n",
          "material.0.n from 1 to 9", "", "nonsense | X"})
        EXPECT_EQ(errorsOfKeys("hold: " + std::string(wrong) + '\n').substr(0, 12), "lesson.md:7:") << wrong;
    EXPECT_NE(errorsOfKeys("figure: pie\n"), "");
    EXPECT_NE(errorsOfKeys("pixels: soft\n"), "");
    EXPECT_NE(errorsOfKeys("hold: camera | Eye\nstrip: 1, 2\n"), "");
    EXPECT_NE(errorsOfKeys("strip: 1, 2, 3\n"), "");
}

TEST(Held, TheSecondHalfKeepsTheHoldsAndSaysWhatItSets) {
    const auto lesson = read("hold: camera | Eye\nplay: Go.\n  until: setting(camera.phi) < 5\n  done: Up.\n",
                             kQuestion + "## then\nset: shading = phong\nText.\n");
    ASSERT_TRUE(lesson) << format(lesson.errors());
    EXPECT_EQ(lesson->pages[0].then->held.holds.size(), 1u);
    EXPECT_FALSE(lesson->pages[0].then->held.play) << "a play is before the question";
    EXPECT_EQ(lesson->pages[0].then->sets, std::vector<std::string>{"shading"});
    const auto none = read("hold: camera | Eye\n", kQuestion + "## then\nhold: none\nText.\n");
    ASSERT_TRUE(none);
    EXPECT_TRUE(none->pages[0].then->held.holds.empty());
}

TEST(Held, AHandDoesNotLeadToTheSecondHalf) {
    const auto faults = [](const std::string& keys, const std::string& then) {
        const auto lesson = read(keys, kQuestion + then);
        return lesson ? format(checkLesson(*lesson)) : format(lesson.errors());
    };
    const std::string hold = "hold: material.0.n from 1 to 64 | Exponent | n\n";
    EXPECT_EQ(faults(hold, "## then\nset: material.0.n = 8\nText.\n"), "") << "it is 8 already";
    EXPECT_NE(faults(hold, "## then\nset: material.0.n = 4\nText.\n")
                  .find("material.0.n is held, and the second half sets it"),
              std::string::npos);
    EXPECT_NE(
        faults(hold + "hides: z_view\nshows: {largest(z_view)}\n", "").find("reads z_view, which this page hides"),
        std::string::npos);
    EXPECT_NE(
        faults(hold + "play: Go.\n  until: setting(material.0.n) = 8\n  done: There.\n", "").find("from the beginning"),
        std::string::npos);
    EXPECT_NE(faults("hold: camera | Eye\nplay: Go *up*.\n  until: setting(camera.phi) < 5\n  done: Up.\n", "")
                  .find("has Markdown"),
              std::string::npos);
    EXPECT_NE(faults("hold: camera | Eye\nshows: row {300 + 10}\n", "")
                  .find("what is shown beside the hand gives the answer"),
              std::string::npos);
    EXPECT_EQ(faults("hold: camera | Eye\nshows: row {300 + 11}\n", ""), "");
    std::string words = "\n";
    for (int i = 0; i < 61; ++i) words += "word ";
    const auto long_ = read(hold, words + kQuestion);
    ASSERT_TRUE(long_) << format(long_.errors());
    EXPECT_NE(format(checkLesson(*long_)).find("words before the question, expected at most 60"), std::string::npos);
}

// The figure of the first half of the page with this heading, in a lesson of the program.
HeldFigure figureOn(const char* lesson, std::string_view heading, const char* settings, bool tells) {
    const auto read = readLesson(lessonFolder() / lesson);
    EXPECT_TRUE(read) << format(read.errors());
    const auto page = std::ranges::find(read->pages, heading, &Page::heading);
    const auto scene = std::make_shared<const pipeline::Scene>(withSettings(page->first.state.scene, settings).value());
    const pipeline::FramePtr frame = runFrame(scene, requestFor(*page), nullptr);
    const auto bufferOf = [&](const pipeline::BufferName& name) { return frame->buffer(name); };
    return figureOf({page->first, *scene, *frame, pickedPixel(page->first.state), 0, tells, bufferOf}, {800, 0, 1});
}

TEST(HeldFigure, TheCodesOfTheObjectsAreToldAfterTheAnswer) {
    constexpr const char* kPage = "Two squares, close together";
    EXPECT_EQ(figureOn("depth-precision", kPage, "camera.near=0.05", false).spoken.find("codes for"),
              std::string::npos);
    const HeldFigure told = figureOn("depth-precision", kPage, "camera.near=0.05", true);
    EXPECT_NE(told.spoken.find("codes for the objects"), std::string::npos) << told.spoken;
    EXPECT_TRUE(told.track) << "the near plane is on its axis";
}

// 0.8 · 60 and what the lamp gives; at the ringed point of "Light from everywhere" the two are its intensity.
TEST(HeldFigure, TheTermsOfTheEquationAreThePixelsIntensity) {
    const auto lesson = readLesson(lessonFolder() / "diffuse");
    ASSERT_TRUE(lesson);
    const Page& page = *std::ranges::find(lesson->pages, "Light from everywhere", &Page::heading);
    const auto scene = std::make_shared<const pipeline::Scene>(page.then->state.scene);
    const pipeline::FramePtr frame = frameOf(*scene, pipeline::setOf({pipeline::BufferId::Intensity}));
    const HeldFigure figure = figureOf({*page.then, *scene, *frame, glm::ivec2(211, 268), 0, true, {}}, {800, 0, 1});
    ASSERT_EQ(figure.terms.size(), 2u);
    EXPECT_EQ(termText(figure.terms[0].value, figure.most), "48.0");
    EXPECT_NEAR(figure.sum, frame->buffer({pipeline::BufferId::Intensity})->value(211, 268, 0), 1e-9);
}

// Every hold of the first halves of the program's lessons, but for questions that return.
template <class Visit>
void eachHold(Visit visit) {
    for (const std::string& name : lessonNames()) {
        const auto lesson = readLesson(lessonFolder() / name);
        ASSERT_TRUE(lesson) << name;
        for (std::size_t i = returningPages(*lesson); i < lesson->pages.size(); ++i)
            for (const pipeline::Hold& hold : lesson->pages[i].first.held.holds) {
                SCOPED_TRACE(name + ", " + lesson->pages[i].heading + ": " + hold.name);
                visit(lesson->pages[i].first, hold);
            }
    }
}

// Where a drag has led, a drag to that place leads again: within 0.5 px, of a number half a pixel of a track of 260. The eye
// and a turn have no place that a value gives: their grips stand still.
TEST(HeldGrid, APlaceGivesTheValuesThatGiveThePlace) {
    int places = 0;
    eachHold([&](const Half& half, const pipeline::Hold& hold) {
        using Kind = pipeline::Hold::Kind;
        const pipeline::Scene& scene = half.state.scene;
        const auto from = placeOf(scene, hold);
        ASSERT_TRUE(from);
        if (hold.kind == Kind::Eye || hold.kind == Kind::Turn) return;
        const auto after = [&](glm::dvec2 to) {
            return withSettings(scene, pipeline::toText(valuesAt(scene, hold, from->at, to)));
        };
        const bool isNumber = hold.kind == Kind::Number;
        for (const double x : {-1.0, -0.4, 0.3, 1.0})
            for (const double y : {-1.0, 0.4}) {
                const glm::dvec2 to = isNumber ? glm::dvec2((x + 1) / 2) : from->at + 80.0 * glm::dvec2(x, y);
                const auto moved = after(to);
                ASSERT_TRUE(moved) << format(moved.errors());
                const auto there = placeOf(*moved, hold);
                // Behind the eye; or a vertex that has stopped before a polygon turned over, which has no place of its own.
                if (!there || (hold.kind == Kind::Vertex && glm::distance(there->at, to) > 0.5)) continue;
                const auto again = after(there->at);
                ASSERT_TRUE(again) << format(again.errors());
                const auto back = placeOf(*again, hold);
                ASSERT_TRUE(back);
                EXPECT_LE(glm::distance(back->at, there->at), isNumber ? 0.5 / 260 : 0.5) << x << ", " << y;
                ++places;
            }
    });
    EXPECT_GT(places, 200);
}

// Of two opposite arrow keys at least one moves what stands at its limit, and all keep it within its limits. Home gives the
// page's own values as text, which a setting takes back to the bit.
TEST(HeldGrid, ArrowKeysMoveItAndHomeRestoresIt) {
    eachHold([](const Half& half, const pipeline::Hold& hold) {
        const pipeline::Scene& scene = half.state.scene;
        const auto own = valuesOf(scene, hold);
        int moves = 0;
        for (const glm::ivec2 by : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
            const auto moved = withSettings(scene, pipeline::toText(nudged(scene, hold, by, false)));
            ASSERT_TRUE(moved) << format(moved.errors());
            moves += valuesOf(*moved, hold) != own;
            const auto home = withSettings(*moved, pipeline::toText(own));
            ASSERT_TRUE(home);
            EXPECT_EQ(valuesOf(*home, hold), own);
        }
        EXPECT_GE(moves, 2);
    });
}

// What of the settings that a hand holds reaches which stage: a light its shadow buffer and shading, an exponent shading
// alone, the eye everything but what lights see.
std::set<pipeline::StageId> stagesReached(std::string_view key) {
    using enum pipeline::StageId;
    if (key.starts_with("light.")) return {ShadowBuffer, Shading};
    if (key.starts_with("material.") && key.ends_with(".n")) return {Shading};
    if (key.starts_with("camera.")) return {Transform, Cull, Normals, ZBuffer, Shading};
    return {pipeline::kStages.begin(), pipeline::kStages.end()};
}

// On every page of every lesson, by one arrow key, without what only the question reads.
TEST(HeldStep, RunsTheStagesAloneThatItsSettingsReach) {
    int steps = 0;
    for (const std::string& name : lessonNames()) {
        const auto lesson = readLesson(lessonFolder() / name);
        ASSERT_TRUE(lesson) << name;
        for (std::size_t i = returningPages(*lesson); i < lesson->pages.size(); ++i) {
            const Half& half = lesson->pages[i].first;
            if (half.held.holds.empty()) continue;
            pipeline::FrameRequest request{.wanted = buffersOf(half.held), .stop = {}};
            for (const pipeline::BufferName& shown : shownBuffers(half.state))
                if (!isDerived(shown.id)) request.wanted.set(index(shown.id));
            const auto before = std::make_shared<const pipeline::Scene>(half.state.scene);
            const pipeline::FramePtr frame = runFrame(before, request, nullptr);
            for (const pipeline::Hold& hold : half.held.holds) {
                const auto after = withSettings(*before, pipeline::toText(nudged(*before, hold, {1, 0}, false)));
                ASSERT_TRUE(after) << name << ": " << format(after.errors());
                const auto next = runFrame(std::make_shared<const pipeline::Scene>(*after), request, frame);
                for (const pipeline::PlanStep& step : next->plan())
                    EXPECT_TRUE(step.action != pipeline::Action::Run ||
                                stagesReached(hold.keys[0]).contains(step.stage))
                        << name << ", " << lesson->pages[i].heading << ": " << hold.name << ": "
                        << stageInfo(step.stage).name << ": " << step.why;
                ++steps;
            }
        }
    }
    EXPECT_GT(steps, 25);
}

}  // namespace
}  // namespace lessons
