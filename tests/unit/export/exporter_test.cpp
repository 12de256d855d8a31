#include "pipeline/export/buffers/exporter.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pipeline/export/folder/file_hash.h"
#include "pipeline/export/folder/size_text.h"
#include "tests/support/files.h"

namespace pipeline {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN();

template <class T>
ExportItem item(BufferId id, std::vector<std::size_t> shape, const std::vector<T>& numbers, PaletteRange range = {}) {
    AnyBuffer buffer{{id, bufferInfo(id).perLight ? 0 : -1}, &bufferInfo(id), std::move(shape), {}, nullptr};
    buffer.data = std::span<const T>(numbers);
    return {buffer, statistics(buffer), range};
}

class Exporting : public testing::Test {
protected:
    test::TemporaryFolder folder;

    std::filesystem::path write(const std::string& format, const ExportItem& buffer) {
        const auto file = folder / ("file." + format);
        const auto bytes = findExporter(format)->write(buffer, file);
        EXPECT_TRUE(bytes && *bytes == std::filesystem::file_size(file)) << format;
        return file;
    }
};

TEST_F(Exporting, NpyHoldsEveryType) {
    const std::vector<float> depth{1.5f, kInf, -2, 0.1f, 5, 6};
    const test::Npy read = test::readNpy(write("npy", item(BufferId::Depth, {2, 3}, depth)));
    EXPECT_EQ(read.descr, "<f4");
    EXPECT_EQ(read.shape, (std::vector<std::size_t>{2, 3}));
    EXPECT_EQ(read.values, std::vector<double>(depth.begin(), depth.end()));
    EXPECT_EQ(read.dataOffset % 64, 0u);
}

TEST_F(Exporting, NpyWritesOneDimensionWithItsComma) {
    const std::vector<std::uint8_t> verdicts{0, 1, 1, 0, 9};
    const auto file = write("npy", item(BufferId::PolygonsVerdict, {5}, verdicts));
    EXPECT_NE(test::readText(file).find("{'descr': '|u1', 'fortran_order': False, 'shape': (5,), }"),
              std::string::npos);
    EXPECT_EQ(test::readNpy(file).values, (std::vector<double>{0, 1, 1, 0, 9}));
}

TEST_F(Exporting, NpyHoldsDoublesIntegersAndEmptyArrays) {
    const std::vector<double> world{0.1, 1e300, -0.0};
    const test::Npy doubles = test::readNpy(write("npy", item(BufferId::VerticesWorld, {1, 3}, world)));
    EXPECT_EQ(doubles.descr, "<f8");
    EXPECT_EQ(doubles.values, world);
    std::filesystem::remove(folder / "file.npy");
    const std::vector<std::int32_t> ids{-1, 7};
    EXPECT_EQ(test::readNpy(write("npy", item(BufferId::ObjectId, {1, 2}, ids))).values, (std::vector<double>{-1, 7}));
    std::filesystem::remove(folder / "file.npy");
    const std::vector<float> none;
    const test::Npy empty = test::readNpy(write("npy", item(BufferId::VerticesNormal, {0, 3}, none)));
    EXPECT_EQ(empty.shape, (std::vector<std::size_t>{0, 3}));
    EXPECT_TRUE(empty.values.empty());
}

TEST_F(Exporting, SizesThatAreSaidToBeExactAreExact) {
    const std::vector<float> depth(35);
    const ExportItem buffer = item(BufferId::Depth, {5, 7}, depth);
    for (const Exporter& exporter : exporterTable()) {
        const auto size = std::filesystem::file_size(write(std::string(exporter.name), buffer));
        EXPECT_TRUE(!exporter.sizeIsExact || exporter.estimate(buffer.buffer) == size) << exporter.name;
    }
}

TEST_F(Exporting, CsvIsATableWithNames) {
    const std::vector<float> depth{0.1f, kInf, kNan, -kInf};
    EXPECT_EQ(test::readText(write("csv", item(BufferId::Depth, {2, 2}, depth))),
              "column,row,value\n0,0,0.1\n1,0,inf\n0,1,nan\n1,1,-inf\n");
}

TEST_F(Exporting, CsvNamesWhatItsLinesAre) {
    const std::vector<double> normals{0, 0, 1, 1, 0, 0};
    EXPECT_EQ(test::readText(write("csv", item(BufferId::VerticesNormal, {2, 3}, normals))),
              "vertex,x,y,z\n0,0,0,1\n1,1,0,0\n");
    std::filesystem::remove(folder / "file.csv");
    const std::vector<std::uint8_t> verdicts{0, 1};
    EXPECT_EQ(test::readText(write("csv", item(BufferId::PolygonsVerdict, {2}, verdicts))),
              "polygon,value\n0,0\n1,1\n");
    std::filesystem::remove(folder / "file.csv");
    const std::vector<std::uint8_t> color{1, 2, 3};
    EXPECT_EQ(test::readText(write("csv", item(BufferId::Color, {1, 1, 3}, color))), "column,row,r,g,b\n0,0,1,2,3\n");
    std::filesystem::remove(folder / "file.csv");
    const std::vector<float> normal{0, 0.5f, 1};
    EXPECT_EQ(test::readText(write("csv", item(BufferId::Normal, {1, 1, 3}, normal))),
              "column,row,x,y,z\n0,0,0,0.5,1\n")
        << "no name stands twice";
    std::filesystem::remove(folder / "file.csv");
    const std::vector<float> none;
    EXPECT_EQ(test::readText(write("csv", item(BufferId::VerticesNormal, {0, 3}, none))), "vertex,x,y,z\n");
}

// The last row comes first, for y points up; 1.5 is 3fc00000, of which 3f comes first.
TEST_F(Exporting, VtkHoldsPointsFromTheLastRowUp) {
    const std::vector<float> depth{0, 1.5f, kInf, -2};
    const std::string numbers("\x7f\x80\0\0\xc0\0\0\0\0\0\0\0\x3f\xc0\0\0", 16);
    EXPECT_EQ(test::readText(write("vtk", item(BufferId::Depth, {2, 2}, depth))),
              "# vtk DataFile Version 3.0\ndepth\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 1\n"
              "ORIGIN 0.5 0.5 0\nSPACING 1 1 1\nPOINT_DATA 4\nSCALARS depth float 1\nLOOKUP_TABLE default\n" +
                  numbers + "\n");
}

TEST_F(Exporting, VtkHoldsVectorsColorsAndFaces) {
    const std::vector<double> normal{0, 0, 1};
    const std::string vectors = test::readText(write("vtk", item(BufferId::Normal, {1, 1, 3}, normal)));
    EXPECT_NE(vectors.find("POINT_DATA 1\nVECTORS normal double\n"), std::string::npos) << vectors;
    std::filesystem::remove(folder / "file.vtk");
    const std::vector<std::uint8_t> color{1, 2, 3, 4, 5, 6};
    const std::string colors = test::readText(write("vtk", item(BufferId::Color, {2, 1, 3}, color)));
    EXPECT_NE(colors.find("SCALARS color unsigned_char 3\nLOOKUP_TABLE default\n\4\5\6\1\2\3\n"), std::string::npos);
    std::filesystem::remove(folder / "file.vtk");
    // Faces one behind the other, each from its own last row up.
    std::vector<float> texels(6 * 2 * 1);
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = i % 2 == 1 ? 0 : 1.5f;
    const std::string faces = test::readText(write("vtk", item(BufferId::ShadowBuffer, {6, 2, 1}, texels)));
    EXPECT_NE(faces.find("DIMENSIONS 1 2 6\n"), std::string::npos) << faces;
    std::string numbers;
    for (int face = 0; face < 6; ++face) numbers += std::string("\0\0\0\0\x3f\xc0\0\0", 8);
    EXPECT_TRUE(faces.ends_with("LOOKUP_TABLE default\n" + numbers + "\n"));
}

TEST_F(Exporting, PngHoldsTheFrameBufferAsItIs) {
    std::vector<std::uint8_t> color(2 * 3 * 3);
    for (std::size_t i = 0; i < color.size(); ++i) color[i] = std::uint8_t(13 * i);
    const test::Png read = test::readPng(write("png", item(BufferId::Color, {2, 3, 3}, color, {0, 255})));
    EXPECT_EQ(read.width, 3);
    EXPECT_EQ(read.height, 2);
    EXPECT_EQ(read.rgb, color);  // row 0 on top
    EXPECT_EQ(read.texts.at("Title"), "color");
}

TEST_F(Exporting, PngShowsOtherBuffersThroughTheirPalette) {
    const std::vector<float> depth{600, 800, kInf, 900};
    const test::Png read = test::readPng(write("png", item(BufferId::ZView, {1, 4}, depth, {600, 800})));
    // Ember's first and last stop, white where nothing was drawn, and the end for what is beyond.
    const std::vector<std::uint8_t> expected{0xff, 0xf3, 0xc4, 0x14, 0x1b, 0x3c, 255, 255, 255, 0x14, 0x1b, 0x3c};
    EXPECT_EQ(read.rgb, expected);
    EXPECT_EQ(read.texts.at("Palette"), "ember");
    EXPECT_EQ(read.texts.at("Range"), "600 800");
}

TEST_F(Exporting, ExrHoldsFloatsWithTheirChannels) {
    const std::vector<float> normal{0, 0.25f, 1, -1, 0.5f, 1e-30f, 1, 2, 3, 4, 5, 6};
    const auto file = write("exr", item(BufferId::Normal, {2, 2, 3}, normal));
    Imf::InputFile read(file.c_str());
    const Imath::Box2i window = read.header().dataWindow();
    EXPECT_EQ(window.max.x - window.min.x + 1, 2);
    EXPECT_EQ(window.max.y - window.min.y + 1, 2);
    std::vector<float> back(12);
    Imf::FrameBuffer pixels;
    for (int c = 0; c < 3; ++c) {
        const char* names[] = {"X", "Y", "Z"};
        EXPECT_NE(read.header().channels().findChannel(names[c]), nullptr);
        pixels.insert(names[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&back[std::size_t(c)]), 12, 24));
    }
    read.setFrameBuffer(pixels);
    read.readPixels(0, 1);
    EXPECT_EQ(back, normal);
}

TEST_F(Exporting, ExrKeepsInfinityAndNamesDistancesZ) {
    const std::vector<double> depth{kInf, 5};
    const auto file = write("exr", item(BufferId::ZView, {1, 2}, depth));
    Imf::InputFile read(file.c_str());
    std::vector<float> back(2);
    Imf::FrameBuffer pixels;
    pixels.insert("Z", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(back.data()), 4, 8));
    read.setFrameBuffer(pixels);
    read.readPixels(0, 0);
    EXPECT_EQ(back, (std::vector<float>{kInf, 5}));
}

TEST_F(Exporting, AFileThatCannotBeWrittenSaysWhy) {
    const std::vector<float> depth{1};
    for (const Exporter& exporter : exporterTable()) {
        const auto result = exporter.write(item(BufferId::Depth, {1, 1}, depth), folder / "missing/file");
        ASSERT_FALSE(result) << exporter.name;
        EXPECT_EQ(result.errors()[0].found, "could not write: No such file or directory") << exporter.name;
        EXPECT_EQ(result.errors()[0].where.file, (folder / "missing/file").string());
    }
}

TEST(ExporterTable, SaysWhatAFormatCannotHold) {
    const auto refuses = [](const char* format, BufferId id) {
        return std::string(findExporter(format)->refuses(bufferInfo(id)));
    };
    EXPECT_EQ(refuses("png", BufferId::VerticesWorld), "A picture has pixels, not vertices.");
    EXPECT_EQ(refuses("png", BufferId::PolygonsVerdict), "A picture has pixels, not polygons.");
    EXPECT_EQ(refuses("png", BufferId::ShadowBuffer), "");
    EXPECT_EQ(refuses("exr", BufferId::ObjectId), "OpenEXR has no signed and no 8-bit integers.");
    EXPECT_EQ(refuses("exr", BufferId::Depth), "");
    for (const BufferInfo& info : bufferTable()) {
        EXPECT_EQ(refuses("npy", info.id), "");
        EXPECT_EQ(refuses("csv", info.id), "");
    }
    EXPECT_EQ(findExporter("bmp"), nullptr);
}

TEST(Sha256, AgreesWithTheStandard) {
    // FIPS 180-4, the example of one block.
    const test::TemporaryFolder folder;
    test::writeText(folder / "abc", "abc");
    EXPECT_EQ(sha256(folder / "abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_FALSE(sha256(folder / "missing"));
    EXPECT_FALSE(sha256(folder.path()));
}

TEST(Exporter, ASmallSizeIsNotWrittenAsZero) {
    EXPECT_EQ(sizeText(999), "999 B");
    EXPECT_EQ(sizeText(2540), "2.5 kB");
    EXPECT_EQ(sizeText(99'949), "99.9 kB");
    EXPECT_EQ(sizeText(100'000), "0.1 MB");
    EXPECT_EQ(sizeText(48'900'000), "48.9 MB");
}

}  // namespace
}  // namespace pipeline
