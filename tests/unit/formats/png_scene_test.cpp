// A picture carries its scene, and a damaged or foreign one is refused.
#include "pipeline/formats/png_scene.h"

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <fstream>
#include <random>

#include "pipeline/export/buffers/png_file.h"
#include "pipeline/export/export_frame.h"
#include "pipeline/formats/scene_reader.h"
#include "tests/support/files.h"
#include "tests/support/peak_memory.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

const FileLoader kNoFiles = [](std::string_view) -> Result<NamedFile> { return Error{{}, "no file", {}}; };

std::filesystem::path exported(const Scene& scene, const test::TemporaryFolder& folder, BufferId id) {
    ExportRequest request;
    request.folder = folder / "out";
    request.formats = {"png"};
    request.buffers = {{id}};
    EXPECT_TRUE(exportFrame(*test::frameOf(scene, setOf({id})), request, {}));
    return folder / "out" / (BufferName{id}.text() + ".png");
}

TEST(PngScene, OpensAgainWithTheSameFrame) {
    const test::TemporaryFolder folder;
    Scene scene = test::pyramid();
    scene.name = "Größe";
    scene.settings.shading = Shading::Phong, scene.objects[0].material.exponent = 37;
    const auto file = exported(scene, folder, BufferId::ZView);
    const Result<Scene> again = readScene(file);
    ASSERT_TRUE(again) << format(again.errors());
    EXPECT_EQ(again->name, "Größe");
    EXPECT_TRUE(again->settings == scene.settings);
    EXPECT_EQ(test::firstDifference(*test::frameOf(scene), *test::frameOf(*again)), "");
    EXPECT_EQ(shownBuffer(test::readText(file)), "z_view");
}

TEST(PngScene, CarriesWhatTheWindowShows) {
    const test::TemporaryFolder folder;
    ExportRequest request;
    request.folder = folder / "out";
    request.formats = {"png"};
    request.buffers = {{BufferId::Color}};
    request.state = "stage = \"shading\"\n# Größe\n";
    ASSERT_TRUE(exportFrame(*test::frameOf(test::pyramid()), request, {}));
    const std::string png = test::readText(folder / "out" / "color.png");
    EXPECT_EQ(carriedState(png), request.state);
    EXPECT_TRUE(readPngScene({png, "color.png"}, kNoFiles));
    EXPECT_EQ(carriedState(pngOf({{4, 4}, Color8(7)})), "");
}

// Two pixels: half transparent red, and nothing.
TEST(PngScene, ATransparentPictureKeepsItsAlphaAndItsTexts) {
    const std::array<std::uint8_t, 8> pixels{200, 10, 20, 128, 1, 2, 3, 0};
    const std::string png = pngOf(pixels, {2, 1}, {{kSceneChunk, "Größe"}, {kStateChunk, "pixel = [1, 2]"}});
    EXPECT_EQ(carriedState(png), "pixel = [1, 2]");
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    ASSERT_TRUE(png_image_begin_read_from_memory(&image, png.data(), png.size()));
    EXPECT_TRUE(image.format & PNG_FORMAT_FLAG_ALPHA);
    image.format = PNG_FORMAT_RGBA;
    std::array<std::uint8_t, 8> read{};
    ASSERT_TRUE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr));
    EXPECT_EQ(read, pixels);
}

TEST(PngScene, APictureOfAnotherProgramIsRefused) {
    const std::string png = pngOf({{4, 4}, Color8(7)});
    const Result<Scene> scene = readPngScene({png, "holiday.png"}, kNoFiles);
    ASSERT_FALSE(scene);
    EXPECT_EQ(format(scene.errors()),
              "holiday.png: the picture carries no scene, expected a picture that this program exported\n");
    EXPECT_EQ(shownBuffer(png), "");
    EXPECT_EQ(shownBuffer("no picture"), "");
}

// Any byte of it may be wrong, and the file may end anywhere: it is read or refused.
TEST(PngScene, ADamagedPictureIsReadOrRefused) {
    const test::TemporaryFolder folder;
    const std::string whole = test::readText(exported(test::pyramid(), folder, BufferId::Color));
    ASSERT_FALSE(whole.empty());
    std::mt19937 random(1);
    const std::size_t head = whole.find("IDAT");  // the text stands before the pixels
    int refused = 0;
    for (int i = 0; i < 400; ++i) {
        std::string bytes = whole;
        if (i % 2 == 0)
            bytes.resize(random() % head);
        else
            bytes[random() % head] = char(random());
        refused += !readPngScene({bytes, "x.png"}, kNoFiles);
    }
    EXPECT_GT(refused, 200);
    EXPECT_TRUE(readPngScene({whole, "x.png"}, kNoFiles));
}

// The length in a chunk's first four bytes is a claim, here 768 MB in a file of some hundred bytes.
TEST(PngScene, AChunkTakesNoMoreMemoryThanAScene) {
    std::string bytes = pngOf(std::array<std::uint8_t, 4>{}, {1, 1}, {{"Title", "depth"}});
    const std::size_t key = bytes.find("Title");
    ASSERT_NE(key, bytes.npos);
    bytes[key - 8] = '\x30';  // length and kind stand before the key, in four bytes each
    Result<Scene> scene = Error{};
    const double taken = test::peakOf([&] { scene = readPngScene({bytes, "x.png"}, kNoFiles); });
    EXPECT_FALSE(scene);
    EXPECT_LT(taken, 16.0 * kMaxCarriedScene);
}

}  // namespace
}  // namespace pipeline
