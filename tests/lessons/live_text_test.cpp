#include "lessons/pages/live_text.h"

#include "lessons/library.h"
#include "lessons/questions/judge.h"
#include "tests/lessons/html_of.h"
#include "tests/lessons/pyramid_scene.h"
#include "tests/support/sweep.h"

namespace lessons {
namespace {

// Without white space and the tags of paragraphs, which a text alone has not.
std::string bare(std::string html) {
    for (const std::string_view tag : {"<p>", "</p>"})
        for (std::size_t at; (at = html.find(tag)) != html.npos;) html.erase(at, tag.size());
    std::erase_if(html, [](char c) { return c == '\n' || c == ' '; });
    return html;
}

// Spread over all lessons; every page in a long run.
std::vector<Page> somePages() {
    std::vector<Page> all, some;
    for (const Lesson& lesson : allLessons().lessons) all.insert(all.end(), lesson.pages.begin(), lesson.pages.end());
    for (const std::size_t i : test::sweep(all.size())) some.push_back(all[i]);
    return some;
}

// What the page says is what the program says: the HTML of the Markdown that was filled in.
TEST(LiveText, OfEveryTextIsTheHtmlOfWhatTheProgramSays) {
    std::size_t compared = 0;
    for (const Page& page : somePages()) {
        const pipeline::FramePtr frame = frameOf(page.first.state.scene, requestFor(page));
        ASSERT_TRUE(frame);
        const Pick pick{.x = 0, .y = 0, .polygon = 0, .vertex = 0, .object = 0, .light = 0};
        const Context context{.frame = *frame, .pick = &pick};
        std::vector<const Prose*> texts{&page.first.text};
        if (page.question)
            for (const Prose* text : textsOf(*page.question)) texts.push_back(text);
        for (const Prose* text : texts) {
            Prose dressed = *text;
            ASSERT_TRUE(dress(dressed, htmlOf(withHoleWords(dressed)))) << withHoleWords(*text);
            const auto said = filled(*text, context), live = filled(dressed, context);
            ASSERT_TRUE(said && live) << page.heading;
            EXPECT_EQ(bare(liveHtml(*live)), bare(htmlOf(*said))) << page.heading;
            ++compared;
        }
    }
    EXPECT_GT(compared, 200u);
}

TEST(LiveText, JudgesAndSpeaksAsTheProgramDoes) {
    for (const Page& page : somePages()) {
        if (!page.question || !std::holds_alternative<NumberQuestion>(page.question->kind)) continue;
        const pipeline::FramePtr frame = frameOf(page.first.state.scene, requestFor(page));
        Lesson one;
        one.pages.push_back(page);
        for (Prose* text : liveTexts(one)) ASSERT_TRUE(dress(*text, htmlOf(withHoleWords(*text))));
        for (const char* typed : {"0.5", "-3", "<b>", "1/2"}) {
            const auto expected = judge(*page.question, Typed{typed}, {.frame = *frame});
            const auto live = judge(*one.pages[0].question, Typed{typed}, {.frame = *frame});
            ASSERT_TRUE(expected && live);
            EXPECT_EQ(live->mark, expected->mark) << page.heading << ": " << typed;
            EXPECT_EQ(live->name, expected->name);
            EXPECT_EQ(bare(liveHtml(live->said)), bare(htmlOf(expected->said))) << page.heading << ": " << typed;
        }
    }
}

TEST(LiveText, TakesNothingThatSomebodyTypesForMarkup) {
    EXPECT_EQ(liveHtml("found \"<img src=x onerror=1>\""), "<p>found &quot;&lt;img src=x onerror=1&gt;&quot;</p>");
    EXPECT_EQ(liveHtml("\x02<b>\x02"), "<p>&lt;b&gt;</p>") << "an end of markup that never began";
    EXPECT_EQ(liveHtml("`material.0.n` = 4"), "<p><code>material.0.n</code> = 4</p>");
    EXPECT_EQ(liveHtml("one\n\ntwo `open"), "<p>one</p><p>two <code>open</code></p>");
    EXPECT_EQ(liveHtml(""), "");
}

// A hole in an address is percent-encoded, or lost with the link: then the text is refused, and the page with it.
TEST(LiveText, RefusesHtmlThatHasNotTheSameHoles) {
    Prose prose{{"a ", " b"}, {Prose::Hole{}}};
    EXPECT_FALSE(dress(prose, "<p>a b</p>"));
    EXPECT_EQ(prose.pieces.front(), "a ");
}

}  // namespace
}  // namespace lessons
