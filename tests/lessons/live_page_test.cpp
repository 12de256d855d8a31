#include "lessons/pages/live_page.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lessons/library.h"
#include "lessons/pages/live_text.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "tests/lessons/pyramid_scene.h"

namespace lessons {
namespace {

using Json = nlohmann::json;

// The parts of a page without its looks: what is put into which hole. For lessons that ask for no lines: those have more.
LiveParts plainParts() {
    return {"core",
            "<title>@TITLE@</title><style>@STYLE@</style>@STYLEHASH@ a@b.c <noscript>@PAPER@</noscript>"
            "<script type=data>@DATA@</script>@CORE@<script>@SCRIPT@</script>@SCRIPTHASH@",
            "p{}", "start('@TITLE@')"};
}
const std::string kCore = "<script type=\"application/octet-stream\" id=\"core\">";
std::string between(const std::string& text, const std::string& start, const std::string& end) {
    const std::size_t from = text.find(start) + start.size();
    return text.substr(from, text.find(end, from) - from);
}
Json dataOf(const LivePage& page) {
    return Json::parse(between(page.html, "<script type=data>", "</script>"), nullptr, false);
}

TEST(LivePage, FillsEachHoleOnce) {
    const auto lesson = findLesson("painter");
    ASSERT_TRUE(lesson);
    const auto page = makeLivePage(*lesson, plainParts());
    ASSERT_TRUE(page) << format(page.errors());
    EXPECT_EQ(between(page->html, kCore, "</script>"), "G{OJ!");  // base85 of "core"
    EXPECT_EQ(between(page->html, "<script>", "</script>"), "start('@TITLE@')") << "a hole in what is put in stays";
    EXPECT_NE(page->html.find("a@b.c"), std::string::npos);
    // printf 'p{}' | openssl dgst -sha256 -binary | base64
    EXPECT_NE(page->html.find("sha256-gG2yISYereRMiG2lMXrbiUgi0Ubw9p7QCeWcroOvy9Y="), std::string::npos)
        << page->html.substr(0, 300);
}

// Enough to read the lesson again without the program's folders: its text, and each scene complete in itself.
TEST(LivePage, CarriesItsScenesAndAsManyTextsAsTheLessonHas) {
    const auto lesson = findLesson("painter");
    ASSERT_TRUE(lesson);
    const auto page = makeLivePage(*lesson, plainParts());
    ASSERT_TRUE(page) << format(page.errors());
    const Json data = dataOf(*page);
    ASSERT_TRUE(data.is_object());
    // Without the questions that return from another lesson: the page does not know whether its reader has done that.
    const auto again = parseOwnPages(data["lesson"].get<std::string>(), "lesson.md", [&](std::string_view name) {
        const std::string file = std::string(name) + ".toml";
        return pipeline::readTomlScene({data["files"][file].get_ref<const std::string&>(), file}, nullptr);
    });
    ASSERT_TRUE(again) << format(again.errors());
    ASSERT_EQ(again->pages.size(),
              std::size_t(std::ranges::count_if(lesson->pages, [](const Page& each) { return !each.from; })));
    std::size_t texts = 0;
    for (const Page& one : again->pages)
        texts += 1 + std::size_t(one.then.has_value()) + (one.question ? textsOf(*one.question).size() : 0);
    EXPECT_EQ(data["texts"].size(), texts);
}

TEST(LivePage, TakesNoTextOfASceneForMarkup) {
    pipeline::Scene scene = pyramidScene();
    const std::string evil =
        "<img src=x onerror=alert(1)></script><!-- {1/0} `a` **b** @CORE@ \\{ \n# two\nscene: other";
    scene.name = evil;
    scene.objects[0].name = evil;
    const auto page = makeLivePage(scene, evil, evil, {}, plainParts());
    ASSERT_TRUE(page) << format(page.errors());
    EXPECT_EQ(page->html.find("<img src=x"), std::string::npos);
    EXPECT_EQ(between(page->html, kCore, "</script>"), "G{OJ!") << "no text ends the data block";
    const Json data = dataOf(*page);
    ASSERT_TRUE(data.is_object());
    EXPECT_NE(data["title"].get<std::string>().find("<img src=x onerror=alert(1)>"), std::string::npos)
        << "as text it is there";
    EXPECT_NE(data["texts"][0].get<std::string>().find("{1/0} `a` **b** @CORE@ \\{"), std::string::npos)
        << data["texts"][0];
}

TEST(LivePage, OfASceneBeginsAtASurfaceAndOfACueAtItsPixel) {
    const pipeline::Scene scene = pyramidScene();
    const auto page = makeLivePage(scene, "Pyramid", "Look.", {}, plainParts());
    ASSERT_TRUE(page) << format(page.errors());
    EXPECT_NE(dataOf(*page)["lesson"].get<std::string>().find("\npixel: "), std::string::npos);
    WindowState cue;
    cue.views = {BufferShown{.buffer = "z_view"}};
    cue.pixel = {268, 281};
    cue.channel = 0;
    const auto shown = makeLivePage(scene, "Pyramid", "Look.", cue, plainParts());
    ASSERT_TRUE(shown) << format(shown.errors());
    const std::string lesson = dataOf(*shown)["lesson"];
    for (const char* line : {"\npixel: 268, 281\n", "\nbuffers: z_view\n", "\nchannel: r\n"})
        EXPECT_NE(lesson.find(line), std::string::npos) << lesson;
}

}  // namespace
}  // namespace lessons
