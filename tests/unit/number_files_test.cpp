// Files of numbers that announce much and hold little: what they take is counted before it is stored.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "pipeline/core/memory.h"
#include "pipeline/formats/number_file.h"

namespace pipeline {
namespace {

constexpr double kMiB = 1024.0 * 1024;

// Of this process, the most that it has held.
double peakBytes() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) * 1024;
    return 0;
}

// How much more it held at most while `work` ran.
template <class Work>
double peakOf(Work work) {
    giveBackFreedMemory();
    std::ofstream("/proc/self/clear_refs") << 5;  // the peak begins anew, see proc(5)
    const double before = peakBytes();
    work();
    return peakBytes() - before;
}

TEST(NumberFiles, ACsvOfSeparatorsTakesNoMemoryOfItsOwn) {
    const std::string commas(20'000'000, ',');
    const double taken = peakOf([&] {
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
    const double taken = peakOf([&] {
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

}  // namespace
}  // namespace pipeline
