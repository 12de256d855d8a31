#include "lessons/pages/picture.h"

#include <sys/stat.h>

#include <fstream>

#include <gtest/gtest.h>
#include "lessons/pages/handout.h"
#include "pipeline/export/buffers/png_file.h"
#include "pipeline/export/html/html_text.h"
#include "pipeline/formats/built_in_scenes.h"
#include "tests/lessons/html_of.h"
#include "tests/support/files.h"

// A lesson is a folder of a stranger. What its pages name stays in that folder.
namespace lessons {
namespace {

namespace fs = std::filesystem;

std::string pngBytes(int width, int height) {
    return pngOf(pipeline::Buffer2D<pipeline::Color8>({width, height}, pipeline::Color8(200)));
}

// PNG, 2nd edition, 11.2.2: width and height stand at bytes 16 and 20, big-endian. The rest stays as it is.
std::string pngThatSays(std::uint32_t width, std::uint32_t height) {
    std::string bytes = pngBytes(1, 1);
    for (int i = 0; i < 4; ++i) {
        bytes[std::size_t(16 + i)] = char(width >> (24 - 8 * i));
        bytes[std::size_t(20 + i)] = char(height >> (24 - 8 * i));
    }
    return bytes;
}

class LessonPictures : public testing::Test {
protected:
    LessonPictures() {
        fs::create_directories(folder / "lesson" / "parts");
        test::writeText(folder / "outside.png", pngBytes(2, 2));
        test::writeText(inside("a.png"), pngBytes(3, 2));
        test::writeText(inside("parts/b c.png"), pngBytes(5, 4));
    }
    fs::path inside(const std::string& name) const { return folder / "lesson" / name; }
    std::string refusal(std::string_view address) {
        Pictures pictures(folder / "lesson");
        const auto picture = pictures.read(address);
        return picture ? "read" : format(picture.errors());
    }

    test::TemporaryFolder folder;
};

TEST_F(LessonPictures, OfTheFolderAndBelowAreRead) {
    Pictures pictures(folder / "lesson");
    const auto a = pictures.read("a.png");
    ASSERT_TRUE(a) << format(a.errors());
    EXPECT_EQ(a->bytes, pngBytes(3, 2));
    EXPECT_EQ(a->type, "png");
    EXPECT_EQ(a->size, glm::ivec2(3, 2));
    for (const char* address : {"parts/b%20c.png", "parts/b c.png", "./parts/../parts/b c.png"}) {
        const auto b = pictures.read(address);
        ASSERT_TRUE(b) << format(b.errors());
        EXPECT_EQ(b->size, glm::ivec2(5, 4)) << address;
    }
}

// ITU T.81, B.1.1.3 and B.2.2: SOI, a comment of 2 bytes, and the head of a baseline frame, 7 high and 300 wide.
TEST_F(LessonPictures, AJpegSaysItsSizeInItsFrame) {
    using namespace std::string_literals;
    test::writeText(inside("c.jpg"), "\xff\xd8\xff\xfe\x00\x04zz\xff\xc0\x00\x11\x08\x00\x07\x01\x2c\x03"s);
    Pictures pictures(folder / "lesson");
    const auto picture = pictures.read("c.jpg");
    ASSERT_TRUE(picture) << format(picture.errors());
    EXPECT_EQ(picture->type, "jpeg");
    EXPECT_EQ(picture->size, glm::ivec2(300, 7));
}

TEST_F(LessonPictures, NothingOutsideTheFolderIsTouched) {
    const std::string absolute = (folder / "outside.png").string(), fifo = inside("fifo").string();
    fs::create_symlink(folder / "outside.png", inside("link.png"));
    fs::create_directory_symlink(folder.path(), inside("up"));
    fs::create_symlink("/dev/zero", inside("zero.png"));
    ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);  // who opened it to read would wait for ever
    for (const std::string& address : {std::string("/dev/zero"),
                                       absolute,
                                       fifo,
                                       std::string("../outside.png"),
                                       std::string("%2e%2e/outside.png"),
                                       std::string("parts/../../outside.png"),
                                       std::string("link.png"),
                                       std::string("up/outside.png"),
                                       std::string("zero.png"),
                                       std::string("fifo"),
                                       std::string("parts"),
                                       std::string("nothing.png"),
                                       "file://" + absolute,
                                       std::string("http://127.0.0.1:9/a.png"),
                                       std::string("//127.0.0.1/a.png"),
                                       std::string("\\\\127.0.0.1\\a.png"),
                                       std::string("qrc:/a.png"),
                                       std::string(":/a.png"),
                                       std::string("data:image/png;base64,AA=="),
                                       std::string("a\n.png"),
                                       std::string()}) {
        EXPECT_NE(refusal(address), "read") << address;
        EXPECT_EQ(refusal(address).find('\n'), refusal(address).size() - 1) << "one line: " << address;
    }
    EXPECT_EQ(refusal("../outside.png"), "\"../outside.png\" is no file of the lesson's folder\n");
    EXPECT_EQ(refusal("link.png"), "\"link.png\" leaves the lesson's folder; put the file beside the lesson\n");
    EXPECT_EQ(refusal("fifo"), "\"fifo\": this is not a regular file, expected a file\n");
    Pictures none({});
    EXPECT_FALSE(none.read("a.png")) << "a text without a folder";
}

TEST_F(LessonPictures, TheirSizeIsKnownBeforeTheyAreUnpacked) {
    test::writeText(inside("bomb.png"), pngThatSays(4001, 4000));  // 16 004 000
    test::writeText(inside("large.png"), pngThatSays(4000, 4000));
    test::writeText(inside("negative.png"), pngThatSays(0x80000000u, 1));
    test::writeText(inside("none.png"), "P6 1 1 255 abc");
    test::writeText(inside("short.png"), pngBytes(1, 1).substr(0, 20));
    std::ofstream(inside("long.png")).seekp(kMaxPictureBytes) << 'x';  // a hole takes no room
    EXPECT_EQ(refusal("bomb.png"), "\"bomb.png\": the picture has 16 004 000 pixels, expected at most 16 000 000\n");
    for (const char* name : {"negative.png", "none.png", "short.png"})
        EXPECT_EQ(refusal(name), '"' + std::string(name) + "\": found no picture, expected a PNG or JPEG file\n");
    EXPECT_EQ(refusal("long.png"), "\"long.png\": the file is larger than 8 388 608 bytes, expected a smaller file\n");

    Pictures pictures(folder / "lesson");
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(pictures.read("large.png")) << i;  // 48 000 000 together
    EXPECT_FALSE(pictures.read("a.png"));
}

TEST(LessonLinks, LeadToTheWebOrStayInTheFolder) {
    using enum LinkTarget;
    for (const char* address : {"https://example.org/", "HTTP://example.org", "mailto:a@example.org"})
        EXPECT_EQ(linkTarget(address), Web) << address;
    for (const char* address : {"page.html", "parts/page.html#place", "#place", "a/../b", "x?y=../z", ""})
        EXPECT_EQ(linkTarget(address), Inside) << address;
    for (const char* address : {"../x",
                                "a/../../x",
                                "%2e%2e/x",
                                "..",
                                "/etc/passwd",
                                "//example.org/x",
                                "/\\example.org",
                                "\\\\example.org",
                                "https:\\\\example.org",
                                "file:///etc/passwd",
                                "javascript:alert(1)",
                                "JaVaScRiPt:alert(1)",
                                "vbscript:x",
                                "data:text/html,x",
                                "java\tscript:alert(1)",
                                "java%09script:x",
                                " javascript:alert(1)",
                                "%20javascript:x",
                                "jar:http://x",
                                "x:y"})
        EXPECT_EQ(linkTarget(address), None) << address;
}

TEST(LessonLinks, ThatLeaveTheFolderKeepTheirWords) {
    EXPECT_EQ(htmlOf("[a](../x) [b](/etc/passwd) [c](file:///x) [d](&#106;avascript:x)"),
              "<p><a>a</a> <a>b</a> <a>c</a> <a>d</a></p>\n");
    EXPECT_EQ(htmlOf("[a](b.html) [c](https://example.org/?x&y) <mailto:a@b>"),
              "<p><a href=\"b.html\">a</a> <a href=\"https://example.org/?x&amp;y\">c</a> "
              "<a href=\"mailto:a@b\">mailto:a@b</a></p>\n");
}

constexpr const char* kLesson =
    "title: T <b>t</b>\nlecture: L\"onmouseover=x\nsummary: S <img src=x>\nscene: pyramid\n\n"
    "# H <script>\nstage: shading\nbuffers: color\npixel: 268, 281\n\n"
    "<script>x</script> ![own](a.png) ![away](/dev/zero) ![up](../outside.png) [j](javascript:x) "
    "![q\"<i>](nothing.png)\n\n"
    "question: How much ![in](parts/b%20c.png)?\nanswer: 1\nhint: <u> [f](file:///etc/passwd)\n";

TEST_F(LessonPictures, AHandoutTakesItsOwnAndNamesTheOthers) {
    test::writeText(inside("lesson.md"), kLesson);
    const auto lesson = readLesson(folder / "lesson");
    ASSERT_TRUE(lesson) << format(lesson.errors());
    const auto handout = makeHandout(*lesson);
    ASSERT_TRUE(handout) << format(handout.errors());
    const auto has = [&](const std::string& part) { return handout->pages.find(part) != handout->pages.npos; };
    EXPECT_TRUE(has("<img src=\"" + pipeline::imageSource("png", pngBytes(3, 2)) + "\" alt=\"own\">"));
    EXPECT_TRUE(has("<img src=\"" + pipeline::imageSource("png", pngBytes(5, 4)) + "\" alt=\"in\">"));
    EXPECT_TRUE(has("alt=\"own\"> away up <a>j</a> q&quot;&lt;i&gt;</p>"));
    for (const char* part :
         {"<script", "/dev/zero", "outside.png", "javascript:", "file:", "<b>t", "<u>", "<img src=x"})
        EXPECT_FALSE(has(part)) << part;
    const std::string at = (folder / "lesson" / "lesson.md").string() + ":6:1: a picture is left out: ";
    EXPECT_EQ(format(handout->leftOut), at + "\"/dev/zero\" is no file of the lesson's folder\n" + at +
                                            "\"../outside.png\" is no file of the lesson's folder\n" + at +
                                            "\"nothing.png\": no such file\n");
    EXPECT_NE(handout->answers.find(pipeline::imageSource("png", pngBytes(5, 4))), std::string::npos);
}

TEST_F(LessonPictures, ManyThatAreLeftOutAreCounted) {
    std::string text = kLesson;
    for (int i = 0; i < 50; ++i) text.insert(text.find("question:"), "![x](../y.png)\n");
    test::writeText(inside("lesson.md"), text);
    const auto handout = makeHandout(*readLesson(folder / "lesson"));
    ASSERT_TRUE(handout) << format(handout.errors());
    ASSERT_EQ(handout->leftOut.size(), 21u);
    EXPECT_EQ(format(handout->leftOut.back()), "33 more pictures are left out");  // 3 and 50, less the first 20
}

TEST_F(LessonPictures, ALessonsSceneIsNoLinkOutOfItsFolder) {
    fs::copy_file(pipeline::resourceFolder() / "scenes" / "pyramid.scene", folder / "away.scene");
    fs::create_symlink(folder / "away.scene", inside("near.scene"));
    std::string text = kLesson;
    text.replace(text.find("scene: pyramid"), 14, "scene: near.scene");
    test::writeText(inside("lesson.md"), text);
    const auto lesson = readLesson(folder / "lesson");
    ASSERT_FALSE(lesson);
    EXPECT_NE(format(lesson.errors()).find("\"near.scene\" leaves the lesson's folder"), std::string::npos)
        << format(lesson.errors());
}

}  // namespace
}  // namespace lessons
