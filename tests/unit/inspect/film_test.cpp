// Step films: which moments they show, what a picture holds, and that a GIF is what a reader of GIFs takes it for.
#include "pipeline/export/film/film.h"

#include <gif_lib.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "tests/support/files.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

Steps smallPyramid() {
    Scene scene = test::pyramid();
    scene.settings.width = 64, scene.settings.height = 48;
    scene.camera.pixelsPerUnit = 0.1;
    return Steps(test::frameOf(scene));
}

FilmRequest zFilm(const Steps& steps) {
    FilmRequest request;
    request.buffer = {BufferId::ZView};
    request.from = {StageId::ZBuffer, 0}, request.to = {StageId::ZBuffer, steps.total(StageId::ZBuffer)};
    return request;
}

TEST(Film, HasAPictureForTheBeginningAndForEveryStep) {
    const Steps steps = smallPyramid();
    FilmRequest request = zFilm(steps);
    const std::vector<Moment> moments = filmMoments(steps, request);
    ASSERT_EQ(moments.size(), 4u);  // three of the five polygons face the eye
    EXPECT_EQ(moments.front(), request.from);
    EXPECT_EQ(moments.back(), request.to);
}

TEST(Film, ThinsManyStepsEvenlyAndKeepsTheEnds) {
    const Steps steps = smallPyramid();
    FilmRequest request = zFilm(steps);
    request.level = StepLevel::Pixel, request.pictures = 11;
    const std::vector<Moment> moments = filmMoments(steps, request);
    ASSERT_EQ(moments.size(), 11u);
    EXPECT_EQ(moments.front(), request.from);
    EXPECT_EQ(moments.back(), request.to);
    const double mean = double(request.to.done) / 10;
    for (std::size_t i = 1; i < moments.size(); ++i)
        EXPECT_NEAR(double(moments[i].done - moments[i - 1].done), mean, 1);
}

TEST(Film, APictureIsTheBufferInTheWholeFramesColours) {
    const Steps steps = smallPyramid();
    FilmRequest request = zFilm(steps);
    const AnyBuffer whole = *steps.frame()->buffer(request.buffer);
    const PaletteRange range = fittingRange(whole, statistics(whole), DepthFormat::Linear);
    const Moment one = *steps.next(request.from, StepLevel::Polygon);
    const Buffer2D<Color8> picture = filmPicture(steps, one, request);
    const AnyBuffer there = *steps.frameAt(one)->buffer(request.buffer);
    ASSERT_EQ(picture.size.x, 64);
    ASSERT_GT(picture.size.y, 48);  // the words below
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            ASSERT_EQ(picture.at({x, y}), elementColor(there, std::size_t(x), std::size_t(y), range));
    request.captions = false;
    EXPECT_EQ(filmPicture(steps, one, request).size.y, 48);
}

TEST(Film, AGifHoldsThePicturesAndGoesOnForEver) {
    const Steps steps = smallPyramid();
    FilmRequest request = zFilm(steps);
    request.captions = false;
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "film.gif";
    const auto summary = writeFilm(steps, request, file);
    ASSERT_TRUE(summary) << format(summary.errors());
    EXPECT_EQ(summary->pictures, 4u);
    EXPECT_EQ(summary->bytes, std::filesystem::file_size(file));
    int error = 0;
    GifFileType* gif = DGifOpenFileName(file.c_str(), &error);
    ASSERT_NE(gif, nullptr);
    ASSERT_EQ(DGifSlurp(gif), GIF_OK);
    EXPECT_EQ(gif->ImageCount, 4);
    EXPECT_EQ(gif->SWidth, 64);
    EXPECT_EQ(gif->SHeight, 48);
    const Buffer2D<Color8> last = filmPicture(steps, request.to, request);
    std::set<std::uint32_t> colors;
    for (const Color8 c : last.pixels) colors.insert(std::uint32_t(c.r) << 16 | std::uint32_t(c.g) << 8 | c.b);
    ASSERT_LE(colors.size(), 256u);  // else the GIF is not exact
    const SavedImage& image = gif->SavedImages[3];
    for (std::size_t i = 0; i < last.pixels.size(); ++i) {
        const GifColorType color = image.ImageDesc.ColorMap->Colors[image.RasterBits[i]];
        ASSERT_EQ(Color8(color.Red, color.Green, color.Blue), last.pixels[i]);
    }
    DGifCloseFile(gif, &error);
}

TEST(Film, AFolderHoldsThePicturesByNumberAndCancellingLeavesNothing) {
    const Steps steps = smallPyramid();
    const FilmRequest request = zFilm(steps);
    const test::TemporaryFolder folder;
    const auto stopped =
        writeFilm(steps, request, folder.path() / "film", [](std::size_t done, std::size_t) { return done < 2; });
    ASSERT_TRUE(stopped);
    EXPECT_TRUE(stopped->cancelled);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "film"));
    ASSERT_TRUE(writeFilm(steps, request, folder.path() / "film"));
    for (const char* name : {"step_0001.png", "step_0002.png", "step_0003.png", "step_0004.png"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() / "film" / name)) << name;
}

// Programs that make one film of numbered pictures go on for as long as there is a next number. What film.json names is
// of the film before; of others nobody can tell whose they are.
TEST(Film, ReplacesTheFilmBeforeAndSaysHowManyPicturesGoOnBehindIt) {
    const Steps steps = smallPyramid();
    FilmRequest request = zFilm(steps);
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFilm(steps, request, folder.path()));  // four pictures
    test::writeText(folder / "step_0006.png", "somebody else's");
    request.pictures = 2;
    const auto shorter = writeFilm(steps, request, folder.path());
    ASSERT_TRUE(shorter);
    EXPECT_EQ(shorter->pictures, 2u);
    EXPECT_EQ(shorter->removed, (std::vector<std::string>{"step_0003.png", "step_0004.png"}));
    EXPECT_EQ(shorter->behind, 0u);
    EXPECT_EQ(shorter->inDoubt, "");
    EXPECT_EQ(folder.names(),
              (std::vector<std::string>{"film.json", "step_0001.png", "step_0002.png", "step_0006.png"}));
    for (const char* name : {"step_0003.png", "step_0004.png"}) test::writeText(folder / name, "somebody else's");
    test::writeText(folder / "step_0002.png", "painted in");
    const auto again = writeFilm(steps, request, folder.path());
    ASSERT_TRUE(again);
    EXPECT_EQ(again->behind, 2u);
    EXPECT_EQ(again->inDoubt, "step_0002.png is not as film.json has it");
    EXPECT_EQ(folder.names().size(), 6u);
}

// Anybody may have written it.
TEST(Film, RemovesNothingThatIsNoPictureOfAFilm) {
    const test::TemporaryFolder folder;
    const Steps steps = smallPyramid();
    std::string listed;
    for (const char* name : {"notes.txt", "step_1.png", "step_000x.png", "step_0009.png"}) {
        test::writeText(folder / name, "mine");
        listed += std::string(listed.empty() ? "" : ", ") + R"({"file": ")" + name + "\"}";
    }
    test::writeText(folder / "film.json", R"({"contents": [)" + listed + R"(, {"file": "../step_0001.png"}, 7]})");
    const auto film = writeFilm(steps, zFilm(steps), folder.path());
    ASSERT_TRUE(film);
    EXPECT_EQ(film->removed, std::vector<std::string>{"step_0009.png"});
    EXPECT_TRUE(std::filesystem::exists(folder / "notes.txt"));
}

// Of the hidden folder in which a film is made nothing is said: the file is named as it was asked for.
TEST(Film, ADiskThatIsFullNamesTheFileThatWasAskedFor) {
    const test::TemporaryFolder folder;
    const Steps steps = smallPyramid();
    const FilmRequest request = zFilm(steps);
    const auto errorOf = [&](const char* name) {
        const test::FullDisk full(100);  // a GIF's colours alone are more, and a PNG's picture
        const auto film = writeFilm(steps, request, folder / name);
        return film ? "written" : format(film.errors());
    };
    EXPECT_EQ(errorOf("f.gif"), (folder / "f.gif").string() + ": could not write: File too large\n");
    EXPECT_EQ(errorOf("film"), (folder / "film/step_0001.png").string() + ": could not write: File too large\n");
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace pipeline
