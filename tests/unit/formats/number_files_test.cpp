// Files of numbers that announce much and hold little: what they take is counted before it is stored.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>

#include <array>
#include <sstream>

#include "pipeline/formats/numbers/number_file.h"
#include "tests/support/files.h"
#include "tests/support/peak_memory.h"

namespace pipeline {
namespace {

constexpr double kMiB = 1024.0 * 1024;

TEST(NumberFiles, ACsvOfSeparatorsTakesNoMemoryOfItsOwn) {
    const std::string commas(20'000'000, ',');
    const double taken = test::peakOf([&] {
        const auto read = readCsvNumbers(commas, "depth.csv", 1000);
        ASSERT_FALSE(read);
        EXPECT_EQ(read.errors()[0].found, "no numbers");
        // A line of as many numbers is counted before it is read.
        const auto numbers = readCsvNumbers("1" + commas, "depth.csv", 1000);
        ASSERT_FALSE(numbers);
        EXPECT_EQ(numbers.errors()[0].found, "more numbers");
    });
    EXPECT_LT(taken, 40 * kMiB);
}

TEST(NumberFiles, ACsvHasEmptyFieldsAndAHeadingAsBefore) {
    const auto read = readCsvNumbers("row,column,z\n0,0,1.5\n1,0,-inf\n", "z.csv", 100);
    ASSERT_TRUE(read) << format(read.errors());
    EXPECT_EQ(read->shape, (std::vector<std::size_t>{1, 2}));
    const auto empty = readCsvNumbers("1,2,3\n4,,6\n", "z.csv", 100);
    ASSERT_FALSE(empty);
    EXPECT_EQ(empty.errors()[0].where.line, 2);
    EXPECT_EQ(empty.errors()[0].where.column, 3);
}

// The header of an OpenEXR file (ILM, "OpenEXR File Layout") and its table of lines, without a pixel.
std::string exrHeader(int width, int height, char compression) {
    std::string text("\x76\x2f\x31\x01\x02\0\0\0", 8);
    const auto number = [](int value) {
        std::string bytes;
        for (int shift = 0; shift < 32; shift += 8) bytes += char(value >> shift & 255);
        return bytes;
    };
    const auto attribute = [&](const std::string& name, const std::string& type, const std::string& value) {
        text += name + '\0' + type + '\0' + number(int(value.size())) + value;
    };
    std::string channels;
    for (const char name : {'B', 'G', 'R'})
        channels += std::string(1, name) + '\0' + number(2) + number(0) + number(1) + number(1);  // float
    attribute("channels", "chlist", channels + '\0');
    attribute("compression", "compression", std::string(1, compression));
    const std::string window = number(0) + number(0) + number(width - 1) + number(height - 1);
    attribute("dataWindow", "box2i", window);
    attribute("displayWindow", "box2i", window);
    attribute("lineOrder", "lineOrder", std::string(1, '\0'));
    const std::string one("\0\0\x80\x3f", 4);
    attribute("pixelAspectRatio", "float", one);
    attribute("screenWindowCenter", "v2f", std::string(8, '\0'));
    attribute("screenWindowWidth", "float", one);
    return text + std::string(1 + 8 * 300, '\0');
}

// 288 MB of floats are announced. With ZIP 16 lines are stored together, with DWAB 256: of those 25 000 wide 77 MB.
TEST(NumberFiles, AnExrTakesMemoryForWhatItHolds) {
    constexpr std::size_t kMost = std::size_t{4} << 26;
    constexpr char kZip = 3, kDwab = 9;
    const double taken = test::peakOf([&] {
        const auto ends = readExrNumbers(exrHeader(16000, 1500, kZip), "color.exr", kMost);
        ASSERT_FALSE(ends);
        EXPECT_TRUE(ends.errors()[0].found.starts_with("a file that cannot be read")) << ends.errors()[0].found;
        const auto block = readExrNumbers(exrHeader(25000, 1500, kDwab), "color.exr", kMost);
        ASSERT_FALSE(block);
        EXPECT_EQ(block.errors()[0].found, "256 lines of 25000 pixels stored together");
        EXPECT_FALSE(readExrNumbers(exrHeader(2000000000, 2, kZip), "color.exr", kMost));
    });
    EXPECT_LT(taken, 60 * kMiB);
}

// A picture of 4 × 2 of which the file has two pixels, (1, 1) and (2, 1); three passes in one file.
TEST(NumberFiles, AnExrOfPassesIsTakenApartAndItsDataWindowHasItsPlace) {
    const test::TemporaryFolder folder;
    const std::string file = (folder / "passes.exr").string();
    Imf::Header header(Imath::Box2i({0, 0}, {3, 1}), Imath::Box2i({1, 1}, {2, 1}));
    const std::vector<std::string> names{"R", "G", "B", "Z", "View.Normal.X", "View.Normal.Y", "View.Normal.Z"};
    std::vector<std::array<float, 2>> numbers;
    for (std::size_t i = 0; i < names.size(); ++i) {
        header.channels().insert(names[i], Imf::Channel(Imf::FLOAT));
        numbers.push_back({float(10 * i + 1), float(10 * i + 2)});
    }
    {
        Imf::OutputFile out(file.c_str(), header);
        Imf::FrameBuffer pixels;
        for (std::size_t i = 0; i < names.size(); ++i)
            pixels.insert(names[i], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(numbers[i].data()) - 4, 4, 0));
        out.setFrameBuffer(pixels);
        out.writePixels(1);
    }
    const std::string bytes = test::readText(file);
    EXPECT_EQ(exrLayers(bytes), (std::vector<std::string>{"", "View.Normal.", "Z"}));
    const auto color = readExrNumbers(bytes, "passes.exr", 1000, "");
    ASSERT_TRUE(color) << format(color.errors());
    EXPECT_EQ(color->shape, (std::vector<std::size_t>{2, 4, 3}));
    std::vector<double> expected(24, 0);
    for (const int x : {1, 2})
        for (const int c : {0, 1, 2}) expected[std::size_t(12 + 3 * x + c)] = 10 * c + x;
    EXPECT_EQ(color->values, expected);
    EXPECT_EQ(readExrNumbers(bytes, "passes.exr", 1000, "Z")->values, (std::vector<double>{0, 0, 0, 0, 0, 31, 32, 0}));
    EXPECT_EQ(readExrNumbers(bytes, "passes.exr", 1000, "View.Normal.")->values[15 + 2], 61);
}

// A TGA of 3 × 2 pixels, colours, packed, rows upwards (Truevision, TGA 2.0): a run of 4 pixels, then 2 as they are.
TEST(NumberFiles, ATgaIsUnpackedAndItsRowsArePutInOrder) {
    std::string tga(18, '\0');
    tga[2] = 10, tga[12] = 3, tga[14] = 2, tga[16] = 24;
    const std::string packets("\x83\1\2\3\x01\4\5\6\7\x08\x09", 11);  // blue, green, red
    const auto read = readNumbers(tga + packets, "color.tga", 1000);
    ASSERT_TRUE(read) << format(read.errors());
    EXPECT_EQ(read->shape, (std::vector<std::size_t>{2, 3, 3}));
    // The first three pixels of the file are the bottom row.
    EXPECT_EQ(read->values, (std::vector<double>{3, 2, 1, 6, 5, 4, 9, 8, 7, 3, 2, 1, 3, 2, 1, 3, 2, 1}));
    EXPECT_FALSE(readNumbers(tga + packets.substr(0, 9), "color.tga", 1000)) << "a packet ends early";
    EXPECT_FALSE(readNumbers(tga + "\x84\1\2\3" + "\x84\1\2\3", "color.tga", 1000)) << "ten pixels of six";
    EXPECT_FALSE(readNumbers(tga + packets, "color.tga", 6)) << "more than may be read";
    tga[17] = 0x20;
    EXPECT_EQ(readNumbers(tga + packets, "color.tga", 1000)->values[0], 3);
}

// A BMP of 1 × 2 pixels of 24 bits (a line is 4 bytes), its rows upwards; and with a height below 0, downwards.
TEST(NumberFiles, ABmpHasItsRowsInOrder) {
    std::string bmp(54, '\0');
    bmp.replace(0, 2, "BM");
    bmp[10] = 54, bmp[14] = 40, bmp[18] = 1, bmp[22] = 2, bmp[26] = 1, bmp[28] = 24;
    const std::string lines("\1\2\3\0\4\5\6\0", 8);
    const auto read = readNumbers(bmp + lines, "color.bmp", 1000);
    ASSERT_TRUE(read) << format(read.errors());
    EXPECT_EQ(read->values, (std::vector<double>{6, 5, 4, 3, 2, 1}));
    EXPECT_FALSE(readNumbers(bmp + lines.substr(1), "color.bmp", 1000));
    bmp.replace(22, 4, "\xfe\xff\xff\xff");
    EXPECT_EQ(readNumbers(bmp + lines, "color.bmp", 1000)->values, (std::vector<double>{3, 2, 1, 6, 5, 4}));
    bmp[28] = 16;
    EXPECT_FALSE(readNumbers(bmp + lines, "color.bmp", 1000));
}

}  // namespace
}  // namespace pipeline
